// Where the rays of a depth image cross the plane of a wall, and whether what they met lies on, before or behind it.
#pragma once

#include <explore/perception/level_view.h>
#include <explore/perception/upright_walls.h>

#include <Eigen/Core>
#include <optional>

namespace explore
{
/** Where a pixel's ray crosses a wall's plane. */
struct WallCrossing
{
	float depth_m = 0;   ///< along the optical axis; 0 = the ray never gets there
	float along_m = 0;   ///< UprightWall::along_m
	float height_m = 0;  ///< above the floor
	float slope = 0;     ///< metres toward the wall per metre of depth: what depth noise counts across the wall
};

/** Pixels from first to last, both included; empty when last < first. */
struct PixelBox
{
	int first_u = 0, last_u = -1, first_v = 0, last_v = -1;

	[[nodiscard]] bool empty() const { return last_u < first_u || last_v < first_v; }
	[[nodiscard]] int pixels() const { return empty() ? 0 : (last_u - first_u + 1) * (last_v - first_v + 1); }
};

/** A rectangle in a wall's plane. */
struct WallRectangle
{
	double from_m, to_m;     ///< along the wall
	double bottom_m, top_m;  ///< above the floor
};

/** The rays of one image against one wall. All quantities are affine in (u, v) up to one division. */
class WallRays
{
public:
	WallRays(const LevelPose& pose, const CameraIntrinsics& camera, const UprightWall& wall);

	[[nodiscard]] WallCrossing at(int u, int v) const
	{
		const auto column = static_cast<float>(u), row = static_cast<float>(v);
		const float approach = -m_normal.at(column, row);
		if (approach < kGrazing) return {};
		const float depth_m = m_offset_m / approach;
		return {depth_m, depth_m * m_tangent.at(column, row), m_camera_height_m + depth_m * m_up.at(column, row),
		        approach};
	}
	/** Height above the floor of the point that pixel (u, v) sees at `depth_m`. */
	[[nodiscard]] float heightAt(int u, int v, float depth_m) const
	{
		return m_camera_height_m + depth_m * m_up.at(static_cast<float>(u), static_cast<float>(v));
	}
	/** UprightWall::along_m of the same point. */
	[[nodiscard]] float alongAt(int u, int v, float depth_m) const
	{
		return depth_m * m_tangent.at(static_cast<float>(u), static_cast<float>(v));
	}
	/** How far in front of the plane the point at `depth_m` on this ray lies; negative behind. */
	[[nodiscard]] float inFront_m(const WallCrossing& crossing, float depth_m) const
	{
		return m_offset_m - depth_m * crossing.slope;
	}
	/** The pixels that may see the rectangle, clipped to the image. */
	[[nodiscard]] PixelBox boxOf(const WallRectangle& rectangle) const;

private:
	static constexpr float kGrazing = 0.02F;  ///< rays flatter than this against the wall say nothing about it
	/** offset + of_u · u + of_v · v */
	struct Affine
	{
		float offset = 0, of_u = 0, of_v = 0;
		[[nodiscard]] float at(float u, float v) const { return offset + of_u * u + of_v * v; }
	};
	static Affine along(const Eigen::Vector3d& axis_in_camera, const CameraIntrinsics& camera);

	CameraIntrinsics m_camera;
	Eigen::Isometry3d m_level_from_camera;
	UprightWall m_wall;
	float m_offset_m, m_camera_height_m;
	Affine m_normal, m_tangent, m_up;
};
}  // namespace explore
