#include <explore/sinks/camera_projection.h>
#include <explore/sinks/html_text.h>
#include <explore/sinks/json_values.h>
#include <explore/sinks/picture_style.h>
#include <explore/sinks/report/camera_record.h>
#include <explore/sinks/report/depth_picture.h>
#include <explore/sinks/report/short_numbers.h>
#include <mrpt/core/bits_math.h>

#include <algorithm>

namespace explore
{
namespace
{
/** Image pixels to thousandths of the width. */
class Scale
{
public:
	explicit Scale(int width_px) : m_factor(1000.0 / width_px) {}
	[[nodiscard]] Json point(const Eigen::Vector2d& px) const { return {whole(px.x()), whole(px.y())}; }
	[[nodiscard]] Json stretch(const ImageSegment& ends) const
	{
		return {whole(ends.first.x()), whole(ends.first.y()), whole(ends.second.x()), whole(ends.second.y())};
	}
	[[nodiscard]] double length(const ImageSegment& ends) const { return m_factor * (ends.second - ends.first).norm(); }

private:
	[[nodiscard]] long whole(double px) const
	{
		constexpr double kMost = 1e5;  // far out in the same direction, for what is almost beside the camera
		return std::lround(std::clamp(m_factor * px, -kMost, kMost));
	}
	double m_factor;
};

Json wallsJson(const std::vector<Wall>& walls, const CameraProjection& projection, const Scale& scale, double reach_m)
{
	constexpr double kShortest = 6.0;  // thousandths: single specks say nothing
	Json list = Json::array();
	for (const Wall& wall : walls)
		for (const ImageSegment& part : projection.shownParts(wall.floor_line, reach_m))
			if (scale.length(part) >= kShortest) list.push_back(scale.stretch(part));
	return list;
}

Json doorJson(const Door& door, const std::optional<Ground>& ground, const CameraProjection& projection,
              const Scale& scale)
{
	const auto corners = doorCorners(door, ground);
	Json outline = Json::array();
	for (std::size_t i = 0; i < corners.size(); ++i)
		if (const auto side = projection.segment(corners[i], corners[(i + 1) % corners.size()]))
			outline.push_back(scale.stretch(*side));
	return {{"q", outline},
	        {"v", nameOf(door.verdict)},
	        {"w", shortNumber(door.width_m, 2)},
	        {"c", shortNumber(door.clear_width_m, 2)},
	        {"p", door.confidence ? shortNumber(*door.confidence, 2) : Json()},
	        {"n", jsonOrNull(door.track)}};
}

std::string nameOfArrow(HeadingKind kind)
{
	switch (kind)
	{
		case HeadingKind::vanishing_point:
			return "vp";
		case HeadingKind::door:
			return "door";
		case HeadingKind::avoid:
			return "avoid";
		case HeadingKind::chosen:
			break;
	}
	return "go";
}

Json degreesJson(const Headings& headings)
{
	const auto degrees = [](const std::optional<double>& heading_rad)
	{ return heading_rad ? shortNumber(mrpt::RAD2DEG(*heading_rad), 0) : Json(); };
	return {{"door", degrees(headings.door_rad)},
	        {"vp", degrees(headings.vanishing_point_rad)},
	        {"avoid", degrees(headings.avoid_rad)},
	        {"go", degrees(headings.chosen_rad)}};
}

/** What lies over the picture. */
void addMarks(Json& record, const DepthFrame& frame, const StepResult& result, double reach_m)
{
	const CameraProjection projection(frame);
	const Scale scale(frame.image.intrinsics.width_px);
	const Percepts& percepts = result.percepts;
	record["walls"] = wallsJson(percepts.walls, projection, scale, reach_m);
	Json doors = Json::array(), vanishing_points = Json::array(), arrows = Json::object();
	for (const Door& door : percepts.doors) doors.push_back(doorJson(door, percepts.ground, projection, scale));
	for (const VanishingPoint& vanishing_point : percepts.vanishing_points)
		if (const auto at = projection.pixel(vanishing_point.point))
		{
			Json mark = scale.point(*at);
			mark.push_back(jsonOrNull(vanishing_point.track));
			vanishing_points.push_back(mark);
		}
	for (const HeadingArrow& arrow : headingArrows(result))
		if (const auto ends = projection.segment(arrow.from_in_robot, arrow.to_in_robot))
			arrows[nameOfArrow(arrow.kind)] = scale.stretch(*ends);
	record["doors"] = doors;
	record["vp"] = vanishing_points;
	record["arrows"] = arrows;
}
}  // namespace

std::string cameraRecord(const DepthFrame& frame, const StepResult& result, double t_s,
                         const CameraRecordConfig& config)
{
	const Decision& decision = result.decision;
	Json record{{"i", frame.index}, {"t", shortNumber(t_s, 3)}};
	const auto& intrinsics = frame.image.intrinsics;
	record["img"] = jsonOrNull(base64(depthJpeg(frame.image, config.max_range_m, config.width_px)));
	if (!frame.image.empty())
	{
		record["ratio"] = shortNumber(double(intrinsics.height_px) / intrinsics.width_px, 4);
		addMarks(record, frame, result, 2.0 * config.max_range_m);
	}
	record["seen"] = result.percepts.doors.size();
	record["deg"] = degreesJson(decision.headings);
	record["stop"] = decision.stop ? Json(nameOf(decision.stop_reason)) : Json();
	record["free"] = shortNumber(decision.open_path_m, 2);
	record["speed"] = shortNumber(decision.command.velocity_mps.norm(), 2);
	return jsonText(record);
}
}  // namespace explore
