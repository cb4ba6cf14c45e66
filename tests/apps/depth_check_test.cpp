// A camera whose depth bends walls: explore-mrpt says so once and names a correction that helps.
#include "apps/program.h"
#include "apps/rawlog_maker.h"
#include "support/analytic_scene.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>

using namespace explore;
using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
struct Drive
{
	double curvature_per_m = 0;  ///< every depth z is measured as z + curvature · z²
	double period_s = 0.5;
};

/** 24 frames along a corridor, looking a little to the left and right in turn. */
std::string driveLog(const fs::path& folder, const Drive& drive)
{
	const Scene scene = corridorScene(9, {}, {});
	const mrpt::poses::CPose3D mount(0, 0, 0.7, 0, 0.05, 0);
	std::vector<DepthFrame> frames;
	for (int i = 0; i < 24; ++i)
	{
		CameraNoise noise;
		noise.axial_scale = 1.0;
		noise.seed = static_cast<std::uint32_t>(i);
		const mrpt::poses::CPose3D map_from_robot(0.1 * i, 0.02 * (i % 9) - 0.1, 0, 0.03 * (i % 5) - 0.06, 0, 0);
		DepthFrame& frame =
		    frames.emplace_back(renderFrame(scene, map_from_robot, mount, xtionIntrinsics(160, 120), noise));
		frame.timestamp = mrpt::Clock::fromDouble(1.5e9 + drive.period_s * i);
		for (float& z : frame.image.depth_m) z += static_cast<float>(drive.curvature_per_m) * z * z;
	}
	const fs::path path = folder / "drive.rawlog";
	writeRawlog(path, frames);
	return path.string();
}

struct Warned
{
	std::string err;
	json in_summary;
};

Warned exploreLog(const std::string& log, std::vector<std::string> further = {})
{
	std::vector<std::string> arguments{"--rawlog", log, "--out", (testFolder() / "out").string()};
	arguments.insert(arguments.end(), further.begin(), further.end());
	const auto result = exploreMrpt(arguments);
	EXPECT_EQ(result.exit_code, 0) << result.err;
	return {result.err, json::parse(readFile(testFolder() / "out" / "summary.json"))["warnings"]};
}

std::size_t timesIn(const std::string& text, const std::string& part)
{
	std::size_t times = 0;
	for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
	return times;
}
}  // namespace

TEST(DepthCheck, BentWallsAreToldOnceOnStandardErrorAndInTheSummary)
{
	const Warned warned = exploreLog(driveLog(freshFolder(), {0.015}));
	EXPECT_EQ(timesIn(warned.err, "warning: Walls that should be square look bent"), 1U) << warned.err;
	ASSERT_EQ(warned.in_summary.size(), 1U) << warned.in_summary;
	EXPECT_THAT(warned.in_summary[0].get<std::string>(), HasSubstr("depth_quadratic"));
}

TEST(DepthCheck, TheSummaryHasItWhateverIsShown)
{
	const Warned warned = exploreLog(driveLog(freshFolder(), {0.015}), {"--verbosity", "ERROR"});
	EXPECT_EQ(timesIn(warned.err, "look bent"), 0U) << warned.err;
	EXPECT_EQ(warned.in_summary.size(), 1U);
}

TEST(DepthCheck, TheCorrectionThatItNamesEndsIt)
{
	const std::string log = driveLog(freshFolder(), {0.015});
	const std::string remark = exploreLog(log).in_summary.at(0);
	std::smatch number;
	ASSERT_TRUE(std::regex_search(remark, number, std::regex("depth_quadratic by ([-+.0-9]+)"))) << remark;
	const Warned corrected = exploreLog(log, {"--set", "camera.depth_quadratic=" + number[1].str()});
	EXPECT_EQ(corrected.in_summary, json::array());
}

TEST(DepthCheck, AGoodCameraIsNotBlamed)
{
	const Warned warned = exploreLog(driveLog(freshFolder(), {}));
	EXPECT_EQ(timesIn(warned.err, "bent"), 0U);
	EXPECT_EQ(warned.in_summary, json::array());
}

TEST(DepthCheck, TwoSecondsAreTooFewToTell)
{
	EXPECT_EQ(exploreLog(driveLog(freshFolder(), {0.015, 0.1})).in_summary, json::array());
}
