#include <explore/core/errors.h>
#include <explore/navigation/keep_out.h>

#include <sstream>

namespace explore
{
namespace
{
std::vector<std::string> split(const std::string& text, char separator)
{
	std::vector<std::string> parts;
	std::istringstream stream(text);
	for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
	return parts;
}

Eigen::Vector2d cornerOf(const std::string& text, const std::string& whole)
{
	std::istringstream stream(text);
	Eigen::Vector2d corner;
	std::string rest;
	if (!(stream >> corner.x() >> corner.y()) || stream >> rest)
		throw ConfigError("[bounds] keep_out = " + whole + ": '" + text +
		                  "' is not a corner; accepted are polygons like 0 0, 2 0, 2 1; 5 5, 6 5, 6 6");
	return corner;
}

PlanPolygon polygonOf(const std::string& text, const std::string& whole)
{
	PlanPolygon polygon;
	for (const std::string& corner : split(text, ',')) polygon.push_back(cornerOf(corner, whole));
	if (polygon.size() < 3) throw ConfigError("[bounds] keep_out = " + whole + ": a polygon needs three corners");
	return polygon;
}

/** Even–odd rule. */
bool contains(const PlanPolygon& polygon, const Eigen::Vector2d& point)
{
	bool inside = false;
	for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
	{
		const Eigen::Vector2d &a = polygon[i], &b = polygon[j];
		if ((a.y() > point.y()) == (b.y() > point.y())) continue;
		if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
	}
	return inside;
}
}  // namespace

bool AllowedArea::inBounds(const Eigen::Vector2d& point_in_map) const
{
	return !bounded || ((point_in_map.array() >= low.array()).all() && (point_in_map.array() <= high.array()).all());
}

bool AllowedArea::isKeptOut(const Eigen::Vector2d& point_in_map) const
{
	for (const PlanPolygon& polygon : keep_out)
		if (contains(polygon, point_in_map)) return true;
	return false;
}

AllowedArea allowedArea(const BoundsConfig& config)
{
	AllowedArea area;
	area.bounded = config.enabled;
	area.low = {config.min_x_m, config.min_y_m};
	area.high = {config.max_x_m, config.max_y_m};
	if (area.bounded && (area.low.array() >= area.high.array()).any())
		throw ConfigError("[bounds] min_x, max_x, min_y, max_y enclose nothing: each max must be above its min");
	for (const std::string& text : split(config.keep_out, ';'))
		area.keep_out.push_back(polygonOf(text, config.keep_out));
	return area;
}
}  // namespace explore
