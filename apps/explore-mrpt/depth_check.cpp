#include <explore-mrpt/depth_check.h>
#include <explore/perception/upright_walls.h>
#include <mrpt/system/datetime.h>

#include <cmath>

namespace explore::app
{
namespace
{
constexpr double kBetweenLooks_s = 0.5;
}

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
	m_bend = withFrame(m_bend, walls, view.pose);
	auto remark = bentWallRemark(m_bend);
	m_said = remark.has_value();
	return remark;
}
}  // namespace explore::app
