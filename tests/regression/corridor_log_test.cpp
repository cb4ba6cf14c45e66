// The bundled corridor log against the geometry it was made from (rawlogs/README.md).
#include <explore/core/geometry.h>
#include <explore/pipeline/explorer.h>
#include <explore/sources/source.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace explore
{
namespace
{
struct TrueOpening
{
	Eigen::Vector2d center;
	double width_m;
};
const std::array<TrueOpening, 4> kOpenings{
    {{{3.45, 1.0}, 0.9}, {{8.0, 1.0}, 1.0}, {{5.45, -1.0}, 0.9}, {{11.0, 0.0}, 1.0}}};

struct Replayed
{
	DepthFrame frame;
	StepResult result;
};

std::vector<Replayed> replay()
{
	mrpt::system::COutputLogger logger;
	logger.logging_enable_console_output = false;
	SourceConfig config;
	config.rawlog = EXPLORE_SOURCE_DIR "/rawlogs/corridor.rawlog";
	const auto source = makeSource(config, logger);
	std::vector<Replayed> frames;
	ExplorerState state;
	// The log's walls have no thickness, which the full method relies on; it is the anchor of the paper's method.
	ExplorerConfig paper;
	paper.perception.method = PerceptionMethod::paper;
	while (auto frame = source->next())
	{
		StepResult result = step(*frame, state, paper);
		frames.push_back({std::move(*frame), std::move(result)});
	}
	return frames;
}

class CorridorLog : public testing::Test
{
protected:
	static void SetUpTestSuite() { s_frames = replay(); }
	static inline std::vector<Replayed> s_frames;
};

Eigen::Vector2d inMap(const DepthFrame& frame, const Eigen::Vector3d& point_in_robot)
{
	return (isometryOf(frame.map_from_robot) * point_in_robot).head<2>();
}

const TrueOpening* openingAt(const Eigen::Vector2d& center)
{
	const auto match = std::ranges::find_if(
	    kOpenings, [&](const TrueOpening& opening) { return (opening.center - center).norm() <= 0.30; });
	return match == kOpenings.end() ? nullptr : &*match;
}

TEST_F(CorridorLog, DeliversEveryFrameWithItsOdometry)
{
	ASSERT_EQ(s_frames.size(), 60U);
	for (std::size_t i = 0; i < s_frames.size(); ++i)
	{
		EXPECT_EQ(s_frames[i].frame.pose_origin, PoseOrigin::odometry);
		EXPECT_NEAR(s_frames[i].frame.map_from_robot.x(), 0.12 * static_cast<double>(i), 1e-6);
	}
}

TEST_F(CorridorLog, FloorIsHalfAMetreBelowTheCamera)
{
	for (const auto& [frame, result] : s_frames)
	{
		ASSERT_TRUE(result.percepts.ground && result.percepts.ground->seen);
		EXPECT_NEAR(result.percepts.ground->camera_height_m, 0.50, 0.01);
		EXPECT_LT(angleBetweenAxes(result.percepts.ground->plane.normal, Eigen::Vector3d::UnitZ()), 0.5 * kDegree_rad);
	}
}

TEST_F(CorridorLog, EveryOpeningIsFoundAndFewOtherThings)
{
	std::size_t right = 0, wrong = 0;
	std::array<int, kOpenings.size()> seen{};
	for (const auto& [frame, result] : s_frames)
		for (const Door& door : result.percepts.doors)
		{
			const TrueOpening* truth = openingAt(inMap(frame, door.center));
			(truth ? right : wrong) += 1;
			if (!truth) continue;
			++seen[static_cast<std::size_t>(truth - kOpenings.data())];
			EXPECT_NEAR(door.width_m, truth->width_m, 0.15) << "frame " << frame.index;
		}
	for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_GE(seen[i], 10) << "opening " << i;
	// The paper takes some gaps between things in a wall's plane for doors.
	EXPECT_GE(static_cast<double>(right), 0.9 * static_cast<double>(right + wrong));
}

TEST_F(CorridorLog, VanishingPointLiesAlongTheCorridor)
{
	int given = 0;
	for (const auto& [frame, result] : s_frames)
	{
		if (!result.decision.headings.vanishing_point_rad) continue;
		++given;
		const double in_map_rad = wrapToPi(*result.decision.headings.vanishing_point_rad + frame.map_from_robot.yaw());
		EXPECT_NEAR(in_map_rad, 0.0, 2 * kDegree_rad) << "frame " << frame.index;
	}
	EXPECT_GE(given, 55);
}

TEST_F(CorridorLog, ChosenHeadingNeverRunsIntoWallsOrTheBox)
{
	// The corridor's solid outline on the floor: walls y = ±1 with their openings, the box.
	const auto solid = [](const Eigen::Vector2d& point)
	{
		const bool in_box = std::abs(point.x() - 6.2) < 0.2 && std::abs(point.y() + 0.65) < 0.25;
		const auto opening_beside = [&](const TrueOpening& opening) {
			return std::abs(opening.center.x() - point.x()) < 0.5 * opening.width_m &&
			       opening.center.y() * point.y() > 0;
		};
		return in_box ||
		       (std::abs(point.y()) > 1.0 && point.x() < 10.9 && std::ranges::none_of(kOpenings, opening_beside));
	};
	for (const auto& [frame, result] : s_frames)
	{
		if (!result.decision.headings.chosen_rad) continue;
		const double yaw = frame.map_from_robot.yaw() + *result.decision.headings.chosen_rad;
		const Eigen::Vector2d start(frame.map_from_robot.x(), frame.map_from_robot.y());
		const Eigen::Vector2d ahead(std::cos(yaw), std::sin(yaw)), left(-ahead.y(), ahead.x());
		// The robot's 0.22 m to both sides, over the first metre or as far as it is said to be free.
		for (double s = 0.0; s < std::min(1.0, result.decision.open_path_m); s += 0.05)
			for (const double side : {-0.2, 0.0, 0.2})
				ASSERT_FALSE(solid(start + s * ahead + side * left)) << "frame " << frame.index << " at " << s << " m";
	}
}
}  // namespace
}  // namespace explore
