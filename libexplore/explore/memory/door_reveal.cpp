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
constexpr std::size_t kFacePoints = 3;               // that the wall's face needs
constexpr double kThickness_m = 0.1;                 // of a wall: its inner faces are about so deep
constexpr double kFlat_m = 0.04, kThick_m = 0.06;    // a wall that ends before has no inner face, one beyond has
constexpr double kDeepest_m = 0.3;                   // of inner faces; what is deeper belongs to the room behind
constexpr double kJump_m = 0.1;                      // from the end of the wall to what is seen behind it
constexpr double kLowest_m = 0.2, kHighest_m = 1.8, kRowStep_m = 0.05;
constexpr double kLeastPixels = 1.5;    // that the inner face has to cover
constexpr double kHiddenShare = 0.6;    // of these pixels: so many without return may hide it
constexpr std::size_t kNothing_px = 2;  // without return: nothing comes back from behind

/** Beside a jamb: inward along the wall, and behind the door's middle plane as the camera sees it. */
struct PlanPoint
{
	double inward_m = 0, behind_m = 0;
};
/** What a pixel measured; no value without return. */
using JambPoint = std::optional<PlanPoint>;

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
		// The wall's outer face stands before the door's middle plane, which from the side it hides.
		const auto outside = pixelAt({-kOutside_m, -kFarFace_m}, height_m), inside = pixelAt({kInside_m, 0}, height_m);
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
	[[nodiscard]] std::optional<Eigen::Vector2d> pixelAt(const PlanPoint& at, double height_m) const
	{
		Eigen::Vector3d point = m_place.point(m_side * (0.5 * m_place.width_m - at.inward_m), height_m);
		point.head<2>() += at.behind_m * m_behind;
		return pixelOfPoint(m_image.intrinsics, m_camera_from_map * point);
	}
	[[nodiscard]] JambPoint pointAt(int u, int v) const
	{
		const double depth_m = m_image.at(u, v);
		if (depth_m <= 0) return std::nullopt;
		const Eigen::Vector3d point = m_map_from_camera * (depth_m * rayOfPixel(m_image.intrinsics, u, v));
		const Eigen::Vector2d offset = point.head<2>() - m_place.center_in_map;
		return PlanPoint{offset.dot(m_inward) + 0.5 * m_place.width_m, offset.dot(m_behind)};
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
		if (point && point->inward_m < -kBeside_m && std::abs(point->behind_m) < kFarFace_m)
			behind_m.push_back(point->behind_m);
	if (behind_m.size() < kFacePoints) return std::nullopt;
	const auto middle = behind_m.begin() + static_cast<std::ptrdiff_t>(behind_m.size() / 2);
	std::nth_element(behind_m.begin(), middle, behind_m.end());
	return *middle;
}

/** Where the wall ends in a row of pixels, from outside inward. */
struct WallEnd
{
	double deep_m = 0;                            ///< behind the wall's face
	std::size_t hole_px = 0;                      ///< without return, right after it
	std::optional<double> next_m = std::nullopt;  ///< what is seen after these, behind the wall's face
};

/** No value where the row ends first. */
std::optional<WallEnd> endOf(const std::vector<JambPoint>& row, double face_m)
{
	std::size_t last = 0;
	for (std::size_t i = 0; i < row.size(); ++i)
		if (row[i] && row[i]->behind_m - face_m < kDeepest_m) last = i;
	if (last + 1 >= row.size() || !row[last]) return std::nullopt;
	std::size_t next = last + 1;
	while (next < row.size() && !row[next]) ++next;
	WallEnd end{row[last]->behind_m - face_m, next - last - 1};
	if (next < row.size()) end.next_m = row[next]->behind_m - face_m;
	return end;
}

/** Whether the wall surely ends there, with its inner face in view if it has one. */
bool isEnd(const WallEnd& end, double inner_px)
{
	// A leaf that stands open toward the camera, or whoever stands there, hides the wall.
	if (end.deep_m < -kThickness_m) return false;
	const bool may_hide_it = static_cast<double>(end.hole_px) >= kHiddenShare * inner_px;
	// Nothing at all comes back from behind: the inner face would be bright beside it.
	if (!end.next_m) return may_hide_it && end.hole_px >= kNothing_px;
	// The projector's shadow beside an edge may hide a small inner face; a wall across goes on without an end.
	return *end.next_m - end.deep_m > kJump_m && !(may_hide_it && end.deep_m < kFlat_m);
}

RevealRows rowOf(const JambScan& scan, double height_m)
{
	const std::vector<JambPoint> row = scan.row(height_m);
	const auto face_m = faceOf(row);
	if (!face_m) return {};
	const double inner_px = scan.innerPixels(*face_m);
	if (inner_px < kLeastPixels) return {};
	const auto end = endOf(row, *face_m);
	if (!end || !isEnd(*end, inner_px)) return {};
	return {end->deep_m < kFlat_m ? 1 : 0, end->deep_m > kThick_m ? 1 : 0};
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
