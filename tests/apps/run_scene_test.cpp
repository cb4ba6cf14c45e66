// scene.3Dscene as runs leave it, with every end of a run.
#include "apps/program.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CText.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
mrpt::opengl::COpenGLScene sceneIn(const fs::path& out)
{
	mrpt::opengl::COpenGLScene scene;
	EXPECT_TRUE(scene.loadFromFile((out / "scene.3Dscene").string()));
	return scene;
}

std::size_t partsOf(mrpt::opengl::COpenGLScene& scene, const std::string& name)
{
	const auto object = std::dynamic_pointer_cast<mrpt::opengl::CSetOfObjects>(scene.getByName(name));
	if (!object) throw std::runtime_error("no object " + name);
	return object->size();
}

/** Path, doors and corridors are those that the run's other files tell of. */
void expectTheSameAsTheFiles(const fs::path& out)
{
	auto scene = sceneIn(out);
	const auto path = std::dynamic_pointer_cast<mrpt::opengl::CSetOfLines>(scene.getByName("path"));
	ASSERT_TRUE(path);
	EXPECT_EQ(path->size() + 1, linesOf(readFile(out / "trajectory.tum")).size());
	const json summary = json::parse(readFile(out / "summary.json"));
	EXPECT_EQ(partsOf(scene, "doors"), summary["doors"].size());
	for (const json& door : summary["doors"])
		EXPECT_TRUE(scene.getByName("door." + std::to_string(door["track"].get<int>())));
	EXPECT_EQ(partsOf(scene, "corridors"), summary["corridors"].size());
	EXPECT_EQ(partsOf(scene, "left_over"), summary["exploration"]["left_over"].size());
	const auto map = std::dynamic_pointer_cast<mrpt::opengl::COctoMapVoxels>(scene.getByName("map"));
	ASSERT_TRUE(map);
	EXPECT_GT(map->getVoxelCount(0), 500U);
}

/** Of the last frame, as frames.jsonl numbers it. */
std::string textOfLastFrame(const fs::path& out)
{
	auto scene = sceneIn(out);
	const auto text = std::dynamic_pointer_cast<mrpt::opengl::CText>(scene.getByName("frame.text"));
	return text ? text->getString() : "";
}
}  // namespace

TEST(RunScene, ShowsWhatTheOtherFilesTell)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {25});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out)).exit_code, 0);
	ASSERT_FALSE(json::parse(readFile(out / "summary.json"))["doors"].empty()) << "else nothing is compared";
	expectTheSameAsTheFiles(out);
	EXPECT_LT(fs::file_size(out / "scene.3Dscene"), 4'000'000U);
}

TEST(RunScene, WithoutATrajectoryTheTrailIsShown)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {20});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out, {"--set", "output.trajectory=false"})).exit_code, 0);
	auto scene = sceneIn(out);
	const auto box = scene.getByName("path")->getBoundingBox();
	EXPECT_NEAR(box.min.x, 0.0, 0.3);
	EXPECT_NEAR(box.max.x, 0.95, 0.3);
}

TEST(RunScene, WithoutPosesItShowsTheLastFrame)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {3});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out, {"--set", "source.pose=none"})).exit_code, 0);
	EXPECT_THAT(textOfLastFrame(out), HasSubstr("frame 2: "));
	EXPECT_FALSE(fs::exists(out / "map.bt"));
}

TEST(RunScene, CanBeSwitchedOffAndAnOldOneIsRemoved)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {2});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out)).exit_code, 0);
	ASSERT_TRUE(fs::exists(out / "scene.3Dscene"));
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out, {"--set", "output.scene=false"})).exit_code, 0);
	EXPECT_FALSE(fs::exists(out / "scene.3Dscene"));
}

TEST(RunScene, OfDamagedInputHasWhatCameBefore)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {20});
	const std::string bytes = readFile(folder / "log.rawlog");
	writeFile(folder / "cut.rawlog", bytes.substr(0, bytes.size() / 2));
	ASSERT_EQ(exploreMrpt(runOf(folder / "cut.rawlog", out)).exit_code, 3);
	expectTheSameAsTheFiles(out);
}

TEST(RunScene, OfAnInterruptedRunHasWhatCameBefore)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {300});
	Program run(EXPLORE_MRPT_PROGRAM, runOf(folder / "log.rawlog", out, {"--realtime"}), {});
	while (run.running() && linesOf(readFile(out / "frames.jsonl")).size() < 5)
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	run.signal(SIGINT);
	ASSERT_EQ(run.wait().exit_code, 128 + SIGINT);
	expectTheSameAsTheFiles(out);
}

TEST(RunScene, OfARunThatGoesOnAfterItsLastFrameIsThatOfAWholeOne)
{
	const fs::path folder = freshFolder();
	writeCorridorRawlog(folder / "log.rawlog", {5});
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", folder / "whole")).exit_code, 0);
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", folder / "o", {"--max-frames", "5"})).exit_code, 0);
	fs::remove(folder / "o" / "scene.3Dscene");
	ASSERT_EQ(exploreMrpt({"--resume", (folder / "o").string(), "--max-frames", "9", "--quiet"}).exit_code, 0);
	EXPECT_TRUE(readFile(folder / "o" / "scene.3Dscene") == readFile(folder / "whole" / "scene.3Dscene"));
}

TEST(RunScene, AFullDiskIsNoticed)
{
	const fs::path folder = freshFolder(), out = folder / "o";
	writeCorridorRawlog(folder / "log.rawlog", {6});
	// Without map, report and state the scene is the largest file.
	const std::vector<std::string> alone{"--set", "source.pose=none",          "--set", "output.report=false",
	                                     "--set", "output.checkpoint_period=0"};
	ASSERT_EQ(exploreMrpt(runOf(folder / "log.rawlog", out, alone)).exit_code, 0);
	Program::Setup setup;
	setup.file_size_limit = fs::file_size(out / "scene.3Dscene") - 1;
	const auto result = exploreMrpt(runOf(folder / "log.rawlog", folder / "full", alone), setup);
	EXPECT_EQ(result.exit_code, 5);
	EXPECT_THAT(result.err, HasSubstr("scene.3Dscene"));
	EXPECT_FALSE(fs::exists(folder / "full" / "scene.3Dscene"));
	EXPECT_FALSE(fs::exists(folder / "full" / "scene.3Dscene.part"));
	EXPECT_TRUE(readFile(folder / "full" / "frames.jsonl") == readFile(out / "frames.jsonl"));
	EXPECT_TRUE(fs::exists(folder / "full" / "summary.json"));
}
