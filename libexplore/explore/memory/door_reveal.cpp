#include <explore/memory/door_reveal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace explore
{
namespace
{
constexpr double kOutside_m = 0.2, kInside_m = 0.4;  // of the jamb, along the wall: how far pixels are looked at
constexpr double kBeside_m = 0.06;                   // from here on outward it is the wall's face
constexpr double kFarFace_m = 0.3;                   // of the wall's face from where the door is thought to be
constexpr double kThickness_m = 0.1;                 // of a wall: inner faces are at least so deep
constexpr double kDeepest_m = 0.2;  // behind the wall's face: what is deeper belongs to the room behind
constexpr double kMost_m = 0.15;    // deeper than this tells no more
constexpr double kLowest_m = 0.2, kHighest_m = 1.8, kRowStep_m = 0.05;
constexpr double kLeastPixels = 1.5;  // that the inner face has to cover

/** A measured point beside a jamb: inward along the wall, and behind the door's middle plane as the camera sees it. */
struct JambPoint
{
	double inward_m = 0, behind_m = 0;
	bool valid = false;
};

class JambScan
{
public:
	JambScan(const DepthFrame& frame, const DoorPlace& place, double side)
	    : m_image(frame.image),
	      m_map_from_camera(isometryOf(frame.map_from_robot) * isometryOf(frame.robot_from_camera)),
	      m_camera_from_map(m_map_from_camera.inverse(Eigen::Isometry)),
	      m_place(place),
	      m_side(side)
	{
		const Eigen::Vector2d camera = m_map_from_camera.translation().head<2>() - place.center_in_map;
		const double facing = camera.dot(place.normal()) > 0 ? 1.0 : -1.0;
		m_behind = -facing * place.normal();
		m_inward = -side * place.along();
		m_camera = {camera.dot(m_inward) + 0.5 * place.width_m, camera.dot(m_behind)};
	}

	/** The points of the row of pixels through the jamb at that height, from outside inward; empty: not in the image.
	 */
	[[nodiscard]] std::vector<JambPoint> row(double height_m) const
	{
		const auto outside = pixelAt(-kOutside_m, height_m), inside = pixelAt(kInside_m, height_m);
		if (!outside || !inside) return {};
		const auto v = static_cast<int>(std::lround(0.5 * (outside->y() + inside->y())));
		const auto first = static_cast<int>(std::lround(outside->x())),
		           last = static_cast<int>(std::lround(inside->x()));
		const auto in_image = [&](int u) { return u >= 0 && u < m_image.intrinsics.width_px; };
		if (v < 0 || v >= m_image.intrinsics.height_px || !in_image(first) || !in_image(last)) return {};
		std::vector<JambPoint> points;
		points.reserve(static_cast<std::size_t>(std::abs(last - first)) + 1);
		const int step = last > first ? 1 : -1;
		for (int u = first; u != last + step; u += step) points.push_back(pointAt(u, v));
		return points;
	}

	/** Pixels that the inner face covers down to kThickness_m behind the wall's face; below 0: it is turned away. */
	[[nodiscard]] double innerPixels(double face_m) const
	{
		const double near_m = face_m - m_camera.y(), deep_m = near_m + kThickness_m;
		return m_image.intrinsics.fx_px * (std::atan2(m_camera.x(), near_m) - std::atan2(m_camera.x(), deep_m));
	}

private:
	[[nodiscard]] std::optional<Eigen::Vector2d> pixelAt(double inward_m, double height_m) const
	{
		const double along_m = m_side * (0.5 * m_place.width_m - inward_m);
		return pixelOfPoint(m_image.intrinsics, m_camera_from_map * m_place.point(along_m, height_m));
	}
	[[nodiscard]] JambPoint pointAt(int u, int v) const
	{
		const double depth_m = m_image.at(u, v);
		if (depth_m <= 0) return {};
		const Eigen::Vector3d point = m_map_from_camera * (depth_m * rayOfPixel(m_image.intrinsics, u, v));
		const Eigen::Vector2d offset = point.head<2>() - m_place.center_in_map;
		return {offset.dot(m_inward) + 0.5 * m_place.width_m, offset.dot(m_behind), true};
	}

	const DepthImage& m_image;
	Eigen::Isometry3d m_map_from_camera, m_camera_from_map;
	const DoorPlace& m_place;
	double m_side;
	Eigen::Vector2d m_behind, m_inward;
	Eigen::Vector2d m_camera;  ///< inward and behind, as JambPoint
};

/** How far the wall's face is behind the door's middle plane (usually negative); no value: not seen. */
std::optional<double> faceOf(const std::vector<JambPoint>& row)
{
	std::vector<double> behind_m;
	for (const JambPoint& point : row)
		if (point.valid && point.inward_m < -kBeside_m && std::abs(point.behind_m) < kFarFace_m)
			behind_m.push_back(point.behind_m);
	if (behind_m.size() < 2) return std::nullopt;
	const auto middle = behind_m.begin() + static_cast<std::ptrdiff_t>(behind_m.size() / 2);
	std::nth_element(behind_m.begin(), middle, behind_m.end());
	return *middle;
}

/** The depth behind the wall's face of what is seen last, from outside inward, before the room behind. */
RevealRows rowOf(const JambScan& scan, double height_m)
{
	const std::vector<JambPoint> row = scan.row(height_m);
	const auto face_m = faceOf(row);
	if (!face_m) return {};
	const double inner_px = scan.innerPixels(*face_m);
	if (inner_px < kLeastPixels) return {};
	std::size_t last = 0;
	for (std::size_t i = 0; i < row.size(); ++i)
		if (row[i].valid && row[i].behind_m - *face_m < kDeepest_m) last = i;
	// The projector's shadow beside an edge hides what is there, and at a grazing angle the inner face does not end
	// before the row does.
	if (last + 1 >= row.size() || !row[last + 1].valid) return {};
	const double deep_m = row[last].behind_m - *face_m;
	// A leaf that stands open toward the camera, or whoever stands there, hides it as well.
	return deep_m > -kThickness_m ? RevealRows{1, std::min(deep_m, kMost_m)} : RevealRows{};
}
}  // namespace

RevealRows revealOf(const DepthFrame& frame, const DoorPlace& place)
{
	RevealRows rows;
	if (frame.image.empty()) return rows;
	for (const double side : {-1.0, 1.0})
	{
		const JambScan scan(frame, place, side);
		for (double height_m = kLowest_m; height_m <= kHighest_m; height_m += kRowStep_m) rows += rowOf(scan, height_m);
	}
	return rows;
}

RevealQuery revealQuery(const DepthFrame& frame)
{
	return [&frame](const DoorPlace& place) { return revealOf(frame, place); };
}
}  // namespace explore
