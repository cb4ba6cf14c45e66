// scene.3Dscene read back by MRPT: what is in it and where, against a corridor whose geometry is known.
#include "sinks/results_maker.h"
#include "support/analytic_scene.h"
#include "support/test_files.h"

#include <explore/core/byte_archive.h>
#include <explore/core/errors.h>
#include <explore/sinks/scene/run_scene.h>
#include <explore/sinks/summary.h>
#include <explore/sinks/trajectory.h>
#include <gmock/gmock.h>
#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/CPointCloudColoured.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CText.h>

#include <chrono>
#include <set>

using namespace explore;
using mrpt::opengl::COctoMapVoxels;
using mrpt::opengl::COpenGLScene;
using mrpt::opengl::CSetOfLines;
using mrpt::opengl::CSetOfObjects;
using mrpt::poses::CPose3D;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

namespace
{
constexpr double kLength_m = 6.0;

/** A drive along a corridor with a door on the left, walls at y = ±1 and an end at 6 m, in the explorer's hands. */
struct Drive
{
	explicit Drive(std::size_t frames, PoseOrigin origin = PoseOrigin::odometry)
	{
		const test::Scene scene = test::corridorScene(kLength_m, {2.0}, {});
		for (std::size_t i = 0; i < frames; ++i)
		{
			const CPose3D map_from_robot(0.1 * static_cast<double>(i), 0, 0, 0, 0, 0);
			DepthFrame frame = test::renderFrame(scene, map_from_robot, CPose3D(0.1, 0, 0.5, 0, 0, 0),
			                                     test::xtionIntrinsics(320, 240), {.max_depth_m = 5.0});
			if (origin == PoseOrigin::none) frame.map_from_robot = CPose3D();
			frame.index = i;
			frame.timestamp += i * std::chrono::milliseconds(250);
			frame.pose_origin = origin;
			last = sketchOf(frame, step(frame, state, {}), 5.0);
			path.push_back(isometryOf(frame.map_from_robot).translation());
		}
	}
	[[nodiscard]] RunSceneParts parts()
	{
		if (!state.memory) return {nullptr, nullptr, nullptr, {}, &last};
		return {&state.memory->map.tree(), state.memory.get(), &state.mission, path, &last};
	}

	ExplorerState state;
	FrameSketch last;
	std::vector<Eigen::Vector3d> path;
};

/** Through the file, as a viewer gets it. */
COpenGLScene readBack(const COpenGLScene& scene)
{
	const auto file = test::freshFolder() / "scene.3Dscene";
	writeScene(scene, file);
	COpenGLScene read;
	EXPECT_TRUE(read.loadFromFile(file.string()));
	return read;
}

template <class Object>
std::shared_ptr<Object> find(COpenGLScene& scene, const std::string& name)
{
	auto object = std::dynamic_pointer_cast<Object>(scene.getByName(name));
	if (!object) throw std::runtime_error("no object " + name);
	return object;
}

std::size_t sizeOf(COpenGLScene& scene, const std::string& name)
{
	return find<CSetOfObjects>(scene, name)->size();
}

std::vector<std::string> textsIn(const CSetOfObjects& objects)
{
	std::vector<std::string> texts;
	for (const auto& object : objects)
		if (const auto text = std::dynamic_pointer_cast<mrpt::opengl::CText>(object))
			texts.push_back(text->getString());
	return texts;
}
}  // namespace

TEST(Scene, VoxelsAreWhereTheWallsAre)
{
	Drive drive(12);
	COpenGLScene scene = readBack(runScene(drive.parts(), {}));
	const auto map = find<COctoMapVoxels>(scene, "map");
	std::size_t left = 0, right = 0, end = 0;
	std::set<int> right_wall_columns;
	ASSERT_GT(map->getVoxelCount(0), 1000U);
	for (std::size_t i = 0; i < map->getVoxelCount(0); ++i)
	{
		const auto& voxel = map->getVoxel(0, i);
		const double reach_m = 0.5 * voxel.side_length + 0.01;
		ASSERT_LT(voxel.coords.z - reach_m, 1.5);
		const auto near = [&](double a, double b) { return std::abs(a - b) < reach_m; };
		left += near(voxel.coords.y, 1.0);
		right += near(voxel.coords.y, -1.0);
		end += near(voxel.coords.x, kLength_m);
		if (near(voxel.coords.y, -1.0)) right_wall_columns.insert(static_cast<int>(voxel.coords.x / 0.05F));
		// Nothing stands in the middle of the corridor.
		EXPECT_FALSE(std::abs(voxel.coords.y) < 0.8 && voxel.coords.z > 0.2 && voxel.coords.z < 1.4 &&
		             voxel.coords.x > 0.5 && voxel.coords.x < kLength_m - 0.2)
		    << voxel.coords.asString();
	}
	EXPECT_GT(left, 400U);
	EXPECT_GT(right, left);  // it has no door
	EXPECT_GT(end, 150U);
	EXPECT_GT(right_wall_columns.size(), 60U);  // without holes from 2 m to 5 m at least
}

TEST(Scene, HoldsWhatTheSummaryTells)
{
	Drive drive(14);
	const ExplorationSummary summary = explorationSummary(drive.state);
	ASSERT_EQ(summary.doors.size(), 1U);  // else this corridor shows nothing
	COpenGLScene scene = readBack(runScene(drive.parts(), {}));
	EXPECT_EQ(sizeOf(scene, "doors"), summary.doors.size());
	EXPECT_EQ(sizeOf(scene, "corridors"), summary.corridors.size());
	EXPECT_EQ(sizeOf(scene, "left_over"), summary.left_over.size());
	const auto door = find<CSetOfObjects>(scene, "door." + std::to_string(summary.doors[0].track));
	EXPECT_THAT(textsIn(*door), Contains(HasSubstr(" 0.90 m")));
	const auto box = door->getBoundingBox();
	EXPECT_NEAR(0.5 * (box.min.x + box.max.x), 2.45, 0.1);  // the opening is from 2.0 to 2.9
	EXPECT_NEAR(0.5 * (box.min.y + box.max.y), 1.0, 0.1);
	EXPECT_EQ(find<CSetOfLines>(scene, "path")->size() + 1, drive.path.size());
	EXPECT_GT(find<CSetOfLines>(scene, "frontiers")->size(), 10U);
	const auto last = find<CSetOfObjects>(scene, "last_frame");
	EXPECT_NEAR(last->getPose().x, 1.3, 1e-6);
	for (const char* name : {"grid", "home", "path.bars", "robot", "heading.chosen"})
		EXPECT_TRUE(scene.getByName(name)) << name;
	EXPECT_FALSE(scene.getByName("frame.cloud"));
}

TEST(Scene, WithoutPosesThereIsTheLastFrame)
{
	Drive drive(3, PoseOrigin::none);
	ASSERT_EQ(drive.state.memory, nullptr);
	COpenGLScene scene = readBack(runScene(drive.parts(), {}));
	for (const char* name : {"map", "doors", "path", "home"}) EXPECT_FALSE(scene.getByName(name)) << name;
	const auto cloud = find<mrpt::opengl::CPointCloudColoured>(scene, "frame.cloud");
	EXPECT_GT(cloud->size(), 1000U);
	EXPECT_LT(cloud->size(), 6000U);
	EXPECT_EQ(find<CSetOfObjects>(scene, "last_frame")->getPose().x, 0.0);
	std::size_t lines = 0;
	for (const auto& line : *find<CSetOfLines>(scene, "frame.floor_lines"))
		for (const auto& end : {line.point1, line.point2})
		{
			++lines;
			EXPECT_NEAR(end.z, 0.0, 0.1);
			EXPECT_LT(std::min(std::abs(std::abs(end.y) - 1.0), std::abs(end.x - (kLength_m - 0.2))), 0.1)
			    << end.asString();
		}
	EXPECT_GT(lines, 2U);
}

TEST(Scene, DrawsTheHeadingsAndFindingsOfAFrame)
{
	DepthFrame frame = test::fullFrame();
	frame.points_in_camera.push_back({1, 2, 3});
	const FrameSketch sketch = sketchOf(frame, test::fullResult(), 5.0);
	COpenGLScene made;
	made.insert(frameObjects(sketch, {}));
	COpenGLScene scene = readBack(made);
	const std::map<std::string, double> headings{
	    {"heading.door", 0.31}, {"heading.vanishing_point", 0.02}, {"heading.avoid", 0.25}, {"heading.chosen", 0.29}};
	for (const auto& [name, angle_rad] : headings)
	{
		const auto box = find<mrpt::opengl::CArrow>(scene, name)->getBoundingBox();
		EXPECT_GT(box.max.x, 1.5) << name;
		EXPECT_NEAR(std::atan2(box.max.y, box.max.x), angle_rad, 0.06) << name;
	}
	EXPECT_THAT(textsIn(*find<CSetOfObjects>(scene, "frame.door.0")), Contains("door 0.92 m"));
	EXPECT_THAT(textsIn(*find<CSetOfObjects>(scene, "frame.vanishing_point.0")), Contains("VP"));
	EXPECT_EQ(find<mrpt::opengl::CText>(scene, "frame.text")->getString(), "frame 7: +17 deg, free 3.4 m, 0.40 m/s");
}

TEST(Scene, EveryVerdictHasAColourAndAShapeOfItsOwn)
{
	std::set<std::tuple<int, int, int>> colors;
	std::set<std::string> shapes;
	for (const Verdict verdict : {Verdict::open, Verdict::ajar, Verdict::closed, Verdict::blocked, Verdict::passage,
	                              Verdict::drop, Verdict::partial, Verdict::unknown})
	{
		DepthFrame frame = test::fullFrame();
		StepResult result = test::fullResult();
		result.percepts.doors[0].verdict = verdict;
		COpenGLScene scene;
		scene.insert(frameObjects(sketchOf(frame, result, 5.0), {}));
		const auto door = find<CSetOfObjects>(scene, "frame.door.0");
		std::string shape;
		mrpt::img::TColor color;
		std::size_t part = 0;
		for (const auto& object : *door)
		{
			const auto bars = std::dynamic_pointer_cast<mrpt::opengl::CSetOfTriangles>(object);
			if (!bars || part++ == 0) continue;  // the edges
			color = bars->getColor_u8();
			for (std::size_t i = 0; i < bars->getTrianglesCount(); ++i)
			{
				mrpt::opengl::TTriangle triangle;
				bars->getTriangle(i, triangle);
				shape += triangle.vertices[0].xyzrgba.pt.asString();
			}
		}
		colors.emplace(color.R, color.G, color.B);
		shapes.insert(shape);
	}
	EXPECT_EQ(colors.size(), 8U);
	EXPECT_EQ(shapes.size(), 8U);
}

TEST(Scene, ALargeMapIsDrawnWithLargerVoxels)
{
	octomap::OcTree map(0.05);
	for (int i = 0; i < 60; ++i)
		for (int j = 0; j < 60; ++j) map.setNodeValue(0.025 + 0.05 * i, 0.025 + 0.05 * j, 0.025, 2.0F, true);
	map.updateInnerOccupancy();
	RunSceneParts parts;
	parts.map = &map;
	RunSceneConfig config;
	config.most_voxels = 1000;
	COpenGLScene scene = readBack(runScene(parts, config));
	const auto voxels = find<COctoMapVoxels>(scene, "map");
	EXPECT_EQ(voxels->getVoxelCount(0), 900U);
	EXPECT_NEAR(voxels->getVoxel(0, 0).side_length, 0.1, 1e-9);
	config.most_voxels = 4000;
	EXPECT_EQ(find<COctoMapVoxels>(scene = readBack(runScene(parts, config)), "map")->getVoxelCount(0), 3600U);
}

TEST(Scene, TheSketchOfAFrameOutlivesACheckpoint)
{
	Drive drive(4);
	ByteWriter written;
	written(drive.last);
	FrameSketch read;
	ByteReader reader(written.bytes());
	reader(read);
	ASSERT_TRUE(reader.good() && reader.atEnd());
	const auto folder = test::freshFolder();
	RunSceneParts parts = drive.parts();
	writeScene(runScene(parts, {}), folder / "a");
	parts.last = &read;
	writeScene(runScene(parts, {}), folder / "b");
	EXPECT_TRUE(test::readFile(folder / "a") == test::readFile(folder / "b"));
}

TEST(Scene, PathsComeFromTheTrajectory)
{
	const auto file = test::freshFolder() / "trajectory.tum";
	const auto line = [](double x)
	{ return trajectoryLine(mrpt::Clock::fromDouble(1416537600.0 + x), CPose3D(x, -2, 0.5, 1, 0, 0)); };
	test::writeFile(file, line(0) + line(0.25) + line(0.5));
	EXPECT_EQ(placesOfTrajectory(file), (std::vector<Eigen::Vector3d>{{0, -2, 0.5}, {0.25, -2, 0.5}, {0.5, -2, 0.5}}));
	EXPECT_TRUE(placesOfTrajectory(file.parent_path() / "missing").empty());
	EXPECT_THROW(writeScene(COpenGLScene(), file.parent_path() / "missing" / "s"), OutputError);
}
