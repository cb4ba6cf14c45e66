#include <explore-mrpt/depth_check.h>
#include <explore/perception/upright_walls.h>
#include <mrpt/system/datetime.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace explore::app
{
namespace
{
constexpr double kBetweenLooks_s = 0.5;
constexpr float kFrom_m = 0.3F, kTo_m = 1.8F;  // above the floor: where walls are looked at
constexpr double kFills = 0.7;

/** The share of what is seen toward the wall, from its one end to the other, that lies on it. */
double filledShare(const LevelView& view, const UprightWall& wall, const PerceptionConfig& perception)
{
	const Eigen::Vector2d left = wall.at(wall.from_m), right = wall.at(wall.to_m);
	const LevelSamples& samples = view.samples;
	std::size_t seen = 0, on_it = 0;
	for (std::size_t i = 0; i < samples.size(); ++i)
	{
		if (samples.z[i] < kFrom_m || samples.z[i] > kTo_m) continue;
		const Eigen::Vector2d point(samples.x[i], samples.y[i]);
		const bool toward =
		    left.x() * point.y() <= left.y() * point.x() && right.x() * point.y() >= right.y() * point.x();
		if (!toward) continue;
		const double tolerance_m =
		    wallTolerance(wall, point, samples.depth_m[i], perception.upright_walls, perception.sensor_noise);
		++seen;
		on_it += static_cast<std::size_t>(std::abs(wall.inFront_m(point)) <= tolerance_m);
	}
	return seen == 0 ? 0.0 : static_cast<double>(on_it) / static_cast<double>(seen);
}

/** Those that are flat all over. Fronts of shelves and stacks pass for walls too, but what stands back or forth in them
 *  turns them, by the same degrees in every frame of a drive along them. */
std::vector<UprightWall> flatOnes(std::vector<UprightWall> walls, const LevelView& view,
                                  const PerceptionConfig& perception)
{
	std::erase_if(walls, [&](const UprightWall& wall) { return filledShare(view, wall, perception) < kFills; });
	return walls;
}
}  // namespace

std::optional<std::string> DepthCheck::look(const DepthFrame& frame)
{
	if (m_said || frame.image.empty()) return std::nullopt;
	// absolute: times that run backwards are another recording's
	if (m_looked && std::abs(mrpt::system::timeDifference(*m_looked, frame.timestamp)) < kBetweenLooks_s)
		return std::nullopt;
	m_looked = frame.timestamp;
	const PerceptionConfig& perception = m_config.perception;
	const LevelView view = levelView(frame, m_config.robot, {}, perception.level, perception.sensor_noise);
	const auto walls = findUprightWalls(view, perception.upright_walls, perception.sensor_noise,
	                                    static_cast<unsigned>(perception.seed));
	m_bend = withFrame(m_bend, flatOnes(walls, view, perception), view.pose);
	auto remark = bentWallRemark(m_bend);
	m_said = remark.has_value();
	return remark;
}
}  // namespace explore::app
