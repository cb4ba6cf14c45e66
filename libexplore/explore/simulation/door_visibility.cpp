#include <explore/simulation/door_visibility.h>

#include <algorithm>
#include <array>

namespace explore::simulation
{
namespace
{
constexpr int kColumns = 12, kRows = 20, kJambPoints = 40, kLintelPoints = 25;
constexpr double kBeforeWall_m = 0.02, kInsideEdge_m = 0.03, kMeasuredHeight_m = 2.0;

/** The opening as it is seen from the camera's side. */
struct DoorHole
{
	Eigen::Vector3d origin;  ///< middle of the floor line, before the wall's near face
	Eigen::Vector3d left;    ///< unit, horizontal
	double half_width_m, low_m, high_m;

	[[nodiscard]] Eigen::Vector3d at(double left_m, double height_m) const
	{
		return origin + left_m * left + height_m * Eigen::Vector3d::UnitZ();
	}
};

/** The middle of piece `index` of `count` equal ones. */
double middle(double from, double to, int index, int count)
{
	return from + (to - from) * (index + 0.5) / count;
}

struct Count
{
	int all = 0, in_image = 0, clear = 0, glass = 0;
	void add(PointSight sight)
	{
		++all;
		in_image += sight != PointSight::outside ? 1 : 0;
		clear += sight == PointSight::clear ? 1 : 0;
		glass += sight == PointSight::glass ? 1 : 0;
	}
	[[nodiscard]] double share(int part) const { return all > 0 ? static_cast<double>(part) / all : 0.0; }
	/** Over at least half of what the image could show. */
	[[nodiscard]] bool seen() const { return in_image > 0 && 2 * clear >= in_image; }
};

DoorHole openingOf(const DoorLabel& label, const Eigen::Vector3d& normal)
{
	const double top = std::min(label.height_m.value_or(kMeasuredHeight_m), kMeasuredHeight_m);
	return {label.floor_center_in_map + (0.5 * label.depth_m + kBeforeWall_m) * normal,
	        normal.cross(Eigen::Vector3d::UnitZ()), 0.5 * label.width_m, std::min(label.sill_m, top), top};
}

Count lookAtGrid(const DoorHole& opening, const TruthView& view, const std::string& leaf)
{
	Count count;
	for (int row = 0; row < kRows; ++row)
		for (int column = 0; column < kColumns; ++column)
			count.add(view.sightOf(opening.at(middle(-opening.half_width_m, opening.half_width_m, column, kColumns),
			                                  middle(opening.low_m, opening.high_m, row, kRows)),
			                       leaf));
	return count;
}

Count lookAtJamb(const DoorHole& opening, double left_m, const TruthView& view, const std::string& leaf)
{
	Count count;
	for (int i = 0; i < kJambPoints; ++i)
		count.add(view.sightOf(opening.at(left_m, middle(opening.low_m, opening.high_m, i, kJambPoints)), leaf));
	return count;
}

Count lookAtLintel(const DoorHole& opening, double height_m, const TruthView& view, const std::string& leaf)
{
	Count count;
	for (int i = 0; i < kLintelPoints; ++i)
		count.add(view.sightOf(
		    opening.at(middle(-opening.half_width_m, opening.half_width_m, i, kLintelPoints), height_m), leaf));
	return count;
}

bool before(const DoorHole& opening, const TruthView& view)
{
	for (const double left : {-opening.half_width_m, 0.0, opening.half_width_m})
		for (const double height : {opening.low_m, opening.high_m})
			if (view.depthOf(opening.at(left, height)) > 0.0) return true;
	return false;
}

/** `past_leaf` counts the opening's rays again, with the door's own leaf in their way. */
Visibility visibilityOf(const Count& grid, const Count& past_leaf, const std::array<Count, 2>& jambs, double range_m)
{
	constexpr int kPastLeaf = 4;  // one ray in four shows the gap beside the leaf
	if (10 * (grid.clear + grid.glass) < grid.all) return Visibility::hidden;
	const bool visible = jambs[0].seen() && jambs[1].seen() && range_m <= kVisibleRange_m && 2 * grid.clear >= grid.all;
	return visible && kPastLeaf * past_leaf.clear >= grid.all ? Visibility::visible : Visibility::ignored;
}
}  // namespace

std::optional<TruthDoor> doorInView(const DoorLabel& label, const TruthView& view)
{
	TruthDoor door;
	door.normal_in_map = Eigen::Vector3d(label.normal_in_map.x(), label.normal_in_map.y(), 0.0).normalized();
	if (door.normal_in_map.dot(view.cameraInMap() - label.floor_center_in_map) < 0.0) door.normal_in_map *= -1.0;
	const DoorHole opening = openingOf(label, door.normal_in_map);
	if (!before(opening, view)) return std::nullopt;

	const std::string leaf = label.id + "_leaf";
	const double edge_m = std::max(opening.half_width_m - kInsideEdge_m, 0.0);
	const Count grid = lookAtGrid(opening, view, leaf);
	const std::array jambs{lookAtJamb(opening, edge_m, view, leaf), lookAtJamb(opening, -edge_m, view, leaf)};
	double range_m = 0.0;
	for (std::size_t i = 0; i < jambs.size(); ++i)
	{
		door.jamb_share[i] = jambs[i].share(jambs[i].clear);
		const Eigen::Vector3d jamb = opening.at(i == 0 ? opening.half_width_m : -opening.half_width_m, 0.0);
		range_m = std::max(range_m, (jamb - view.cameraInMap()).head<2>().norm());
	}
	door.visible_share = grid.share(grid.clear);
	door.visibility = visibilityOf(grid, lookAtGrid(opening, view, {}), jambs, range_m);
	if (label.height_m)
	{
		const Count lintel = lookAtLintel(opening, *label.height_m - kInsideEdge_m, view, leaf);
		door.lintel_in_view = 2 * lintel.clear >= lintel.all;
	}
	return door;
}
}  // namespace explore::simulation
