#include <explore/memory/door_sight.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace explore
{
namespace
{
constexpr int kColumns = 9, kRows = 8;  // of the rays through an opening
constexpr double kJambBeside_m = 0.06;  // the jamb's face is seen so far beside the opening
// Distances from the middle of the wall: what ends nearer to the camera stands before it, what ends farther went
// through.
constexpr double kBefore_m = 0.2, kBehind_m = 0.3;

enum class Seen
{
	outside,  ///< of the image, or behind the camera
	nothing,  ///< no return
	front,    ///< something stands before it
	at,
	behind
};

/** How the rays to some points ended. */
struct RayCounts
{
	int all = 0;
	std::array<int, 5> ended{};

	[[nodiscard]] int of(Seen seen) const { return ended[static_cast<std::size_t>(seen)]; }
	[[nodiscard]] int inImage() const { return all - of(Seen::outside); }
	[[nodiscard]] int unoccluded() const { return inImage() - of(Seen::front); }
	void add(Seen seen)
	{
		++all;
		++ended[static_cast<std::size_t>(seen)];
	}
};

class FrameView
{
public:
	FrameView(const DepthFrame& frame, const SensorNoiseConfig& noise)
	    : m_image(frame.image),
	      m_noise(noise),
	      m_map_from_camera(isometryOf(frame.map_from_robot) * isometryOf(frame.robot_from_camera)),
	      m_camera_from_map(m_map_from_camera.inverse(Eigen::Isometry))
	{
	}

	[[nodiscard]] Eigen::Vector2d camera() const { return m_map_from_camera.translation().head<2>(); }

	/** How the ray to that point of the door's wall ended. */
	[[nodiscard]] Seen at(const Eigen::Vector3d& point_in_map, const Eigen::Vector2d& normal) const
	{
		const Eigen::Vector3d point = m_camera_from_map * point_in_map;
		const auto pixel = pixelOfPoint(m_image.intrinsics, point);
		if (!pixel) return Seen::outside;
		const double u = std::round(pixel->x()), v = std::round(pixel->y());
		if (!(u >= 0 && v >= 0 && u < m_image.intrinsics.width_px && v < m_image.intrinsics.height_px))
			return Seen::outside;
		const double depth_m = m_image.at(static_cast<int>(u), static_cast<int>(v));
		if (depth_m <= 0) return Seen::nothing;
		// Along the wall's normal: grazing rays come a long way within the thickness of a wall.
		const double per_depth = std::abs((point_in_map.head<2>() - camera()).dot(normal)) / point.x();
		const double behind_m = per_depth * (depth_m - point.x());
		const double noise_m = 3 * per_depth * depthSigma(point.x(), m_noise);
		if (behind_m < -kBefore_m - noise_m) return Seen::front;
		return behind_m > kBehind_m + noise_m ? Seen::behind : Seen::at;
	}

private:
	const DepthImage& m_image;
	const SensorNoiseConfig& m_noise;
	Eigen::Isometry3d m_map_from_camera, m_camera_from_map;
};

/** Heights of the rays, from knee to below the lintel. */
double rowHeight(const DoorPlace& place, int row)
{
	constexpr double kLowest_m = 0.1;
	const double highest_m = std::min(place.height_m.value_or(kUsualDoorHeight_m), kUsualDoorHeight_m) - kLowest_m;
	return kLowest_m + (highest_m - kLowest_m) * row / (kRows - 1);
}

RayCounts jambRays(const FrameView& view, const DoorPlace& place, double along_m)
{
	const Eigen::Vector2d normal = place.normal();
	RayCounts rays;
	for (int row = 0; row < kRows; ++row) rays.add(view.at(place.point(along_m, rowHeight(place, row)), normal));
	return rays;
}

RayCounts openingRays(const FrameView& view, const DoorPlace& place)
{
	const Eigen::Vector2d normal = place.normal();
	RayCounts rays;
	for (int column = 0; column < kColumns; ++column)
	{
		const double along_m = place.width_m * ((column + 0.5) / kColumns - 0.5);
		for (int row = 0; row < kRows; ++row) rays.add(view.at(place.point(along_m, rowHeight(place, row)), normal));
	}
	return rays;
}

bool isJambSeen(const RayCounts& rays, double min_share)
{
	const int seen = rays.of(Seen::at) + rays.of(Seen::behind);
	return rays.inImage() > 0 && seen >= min_share * rays.inImage();
}
}  // namespace

void describe(FieldVisitor& fields, DoorSightConfig& config)
{
	fields.real("sight_range", config.max_range_m, {0.5, 50.0}, "m",
	            "A door with both jambs nearer than this is expected to be found.");
	fields.degrees("sight_incidence_deg", config.max_incidence_rad, {0.0, 89.0},
	               "At a more grazing angle it is not expected to be found.");
	fields.real("sight_share", config.min_share, {0.1, 1.0}, "",
	            "Of its rays and of either jamb, in the image and not occluded, from which on it is expected.");
}

std::optional<DoorView> viewOf(const DepthFrame& frame, const DoorPlace& place, const DoorSightConfig& config,
                               const SensorNoiseConfig& noise)
{
	if (frame.image.empty()) return std::nullopt;
	const FrameView view(frame, noise);
	const Eigen::Vector2d sight = place.center_in_map - view.camera();
	const double cosine = std::abs(sight.normalized().dot(place.normal()));
	if (!(cosine >= std::cos(config.max_incidence_rad))) return std::nullopt;
	for (const double side : {-1.0, 1.0})
	{
		const double jamb_m = side * (0.5 * place.width_m + kJambBeside_m);
		const Eigen::Vector2d jamb = place.center_in_map + jamb_m * place.along();
		if ((jamb - view.camera()).norm() > config.max_range_m) return std::nullopt;
		if (!isJambSeen(jambRays(view, place, jamb_m), config.min_share)) return std::nullopt;
	}
	const RayCounts rays = openingRays(view, place);
	if (rays.unoccluded() < config.min_share * rays.all) return std::nullopt;
	const double unoccluded = rays.unoccluded();
	return DoorView{rays.of(Seen::behind) / unoccluded, rays.of(Seen::at) / unoccluded};
}

DoorQuery doorQuery(const DepthFrame& frame, const DoorSightConfig& config, const SensorNoiseConfig& noise)
{
	return [&frame, config, noise](const DoorPlace& place) { return viewOf(frame, place, config, noise); };
}
}  // namespace explore
