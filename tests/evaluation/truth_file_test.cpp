#include "evaluation/truth_maker.h"
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/evaluation/truth_file.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace explore;
using namespace explore::evaluation;
using testing::AllOf;
using testing::HasSubstr;

namespace
{
TruthLog twoFrames()
{
	TruthLog log;
	log.world = "synth";
	log.family = "frontal_door";
	log.configuration = "single wall single door";
	log.robot.kind = RobotKind::mav;
	log.robot.radius_m = 0.1 + 0.2;
	log.noise = "kinect";
	log.seed = 18446744073709551615ULL;
	log.command = "explore-rawlog synth --family \"frontal_door\" // ü";
	log.intrinsics = {640, 480, 588.0, 588.5, 319.5, 239.5};
	log.robot_from_camera = mrpt::poses::CPose3D(0.1, 0, 0.05, 0, 0.02, 0);
	TruthFrame frame;
	frame.t = 1416537600.123456;
	frame.map_from_robot = mrpt::poses::CPose3D(1.0 / 3.0, -2e-9, 1.2, 3.0, -0.1, 0.05);
	frame.doors = {test::openDoor("a", 3.1, 0.2, 0.9), test::openDoor("b", 3.1, 1.7, 1.1)};
	frame.doors[1].height_m.reset();
	frame.doors[1].verdict = Verdict::passage;
	frame.doors[1].visibility = Visibility::ignored;
	frame.corridor = {CorridorState::corridor, Eigen::Vector3d(0.6, 0.8, 0), 2.0};
	frame.obstacles = {{"person", {1, 2, 0}, 0.25, 1.8}};
	frame.free_paths = test::evenPaths(3.14159F, {-0.5, 0.0, 0.5});
	log.frames.push_back(frame);
	frame.index = 1;
	frame.t += 0.1;
	frame.scene = 1;
	frame.free_paths.reset();
	log.frames.push_back(frame);
	return log;
}

std::string messageFor(const std::string& text)
{
	const auto path = test::testFolder() / "log.truth.json";
	std::filesystem::create_directories(path.parent_path());
	test::writeFile(path, text);
	try
	{
		(void)readTruth(path);
		return "accepted";
	}
	catch (const InputError& error)
	{
		EXPECT_THAT(error.what(), testing::StartsWith(path.string() + ": "));
		return error.what();
	}
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
	const auto at = text.find(what);
	EXPECT_NE(at, std::string::npos) << what;
	return text.replace(at, what.size(), by);
}
}  // namespace

TEST(TruthFile, StandsBesideItsLog)
{
	EXPECT_EQ(truthPathOf("a.b/frontal.door.rawlog"), "a.b/frontal.door.truth.json");
}

TEST(TruthFile, ReadsBackWhatWasWritten)
{
	const auto path = test::freshFolder() / "log.truth.json";
	const TruthLog written = twoFrames();
	writeTruth(path, written);
	const TruthLog read = readTruth(path);
	EXPECT_EQ(truthText(read), truthText(written));
	EXPECT_EQ(test::readFile(path), truthText(written));

	EXPECT_EQ(read.seed, written.seed);
	EXPECT_EQ(read.command, written.command);
	EXPECT_EQ(read.configuration, written.configuration);
	EXPECT_EQ(read.robot.kind, RobotKind::mav);
	EXPECT_EQ(read.robot.radius_m, written.robot.radius_m);
	EXPECT_EQ(read.intrinsics, written.intrinsics);
	ASSERT_EQ(read.frames.size(), 2U);
	const TruthFrame &frame = read.frames[0], &expected = written.frames[0];
	EXPECT_EQ(frame.t, expected.t);
	EXPECT_EQ(frame.map_from_robot.x(), expected.map_from_robot.x());
	EXPECT_EQ(frame.map_from_robot.yaw(), expected.map_from_robot.yaw());
	ASSERT_EQ(frame.doors.size(), 2U);
	EXPECT_EQ(frame.doors[0].center_in_map, expected.doors[0].center_in_map);
	EXPECT_EQ(frame.doors[1].height_m, std::nullopt);
	EXPECT_EQ(frame.doors[1].verdict, Verdict::passage);
	EXPECT_EQ(frame.doors[1].visibility, Visibility::ignored);
	EXPECT_EQ(frame.corridor.direction_in_map, expected.corridor.direction_in_map);
	ASSERT_EQ(frame.obstacles.size(), 1U);
	EXPECT_EQ(frame.obstacles[0].kind, "person");
	ASSERT_TRUE(frame.free_paths);
	EXPECT_EQ(frame.free_paths->elevations_rad, expected.free_paths->elevations_rad);
	ASSERT_EQ(frame.free_paths->free_m.size(), 3U * 360U);
	EXPECT_EQ(frame.free_paths->free_m[700], 3.14F);
	EXPECT_FALSE(read.frames[1].free_paths);
	EXPECT_EQ(read.frames[1].scene, 1);
}

TEST(TruthFile, IsCompact)
{
	TruthLog log = twoFrames();
	log.frames.resize(1);
	log.frames[0].free_paths = test::evenPaths(8.0F);
	EXPECT_LT(truthText(log).size(), 2500U);
	EXPECT_THAT(truthText(log), HasSubstr("[8,8,8,"));
}

TEST(TruthFile, RefusesToWriteWhatIsNoNumber)
{
	TruthLog log = twoFrames();
	log.frames[0].free_paths->free_m[3] = std::numeric_limits<float>::quiet_NaN();
	EXPECT_THROW(truthText(log), std::logic_error);
	log = twoFrames();
	log.frames[0].free_paths->free_m.pop_back();
	EXPECT_THROW(truthText(log), std::logic_error);
}

TEST(TruthFile, MistakesAreNamedWithTheirPlace)
{
	const std::string good = truthText(twoFrames());
	EXPECT_EQ(messageFor(good), "accepted");
	const auto broken = [&](const char* what, const char* by) { return messageFor(replaced(good, what, by)); };

	EXPECT_THAT(broken("\"schema\":1", "\"schema\":2"), AllOf(HasSubstr("at schema"), HasSubstr("accepted: 1")));
	EXPECT_THAT(broken("\"seed\"", "\"sead\""), HasSubstr("\"seed\" is missing"));
	EXPECT_THAT(broken("\"radius\":0.30000000000000004", "\"radius\":-1"),
	            AllOf(HasSubstr("at robot.radius: -1;"), HasSubstr("accepted: a number from 1e-06 to 10000")));
	EXPECT_THAT(broken("\"passable\":true", "\"passable\":1"),
	            AllOf(HasSubstr("frames[0].doors[0].passable"), HasSubstr("true or false")));
	EXPECT_THAT(broken("\"verdict\":\"passage\"", "\"verdict\":\"pasage\""),
	            AllOf(HasSubstr("frames[0].doors[1].verdict: \"pasage\""), HasSubstr("passage")));
	EXPECT_THAT(broken("\"normal\":[-1.0", "\"normal\":[-2.0"), HasSubstr("a vector of length 1"));
	EXPECT_THAT(broken("[3.14,", "[-3.14,"), AllOf(HasSubstr("frames[0].free_paths.free[0]"), HasSubstr("from 0 to")));
	EXPECT_THAT(broken("[3.14,", "[3.14,3.14,"), HasSubstr("1080"));
	EXPECT_THAT(broken("\"index\":1", "\"index\":0"), HasSubstr("frames[1].index"));
	EXPECT_THAT(broken("\"scene\":0", "\"scene\":-1"), HasSubstr("frames[0].scene"));
	EXPECT_THAT(broken("\"t\":1416537600.123456", "\"t\":NaN"), HasSubstr("line 2, column"));
	EXPECT_THAT(broken("\"t\":1416537600.123456", "\"t\":1e999"), HasSubstr("1e999"));
	EXPECT_THAT(broken("\"t\":1416537600.123456", "\"t\":null"), HasSubstr("frames[0].t: null"));
	EXPECT_THAT(messageFor(""), HasSubstr("line 1, column 1"));
	EXPECT_THAT(messageFor("[]"), HasSubstr("at the top: an array of 0; accepted: an object"));
	EXPECT_THAT(messageFor(std::string(100000, '[')), HasSubstr("column"));
}

TEST(TruthFile, AMissingFileIsNamed)
{
	const auto folder = test::freshFolder();
	for (const auto& path : {folder / "none.truth.json", folder}) try
		{
			(void)readTruth(path);
			FAIL() << path;
		}
		catch (const InputError& error)
		{
			EXPECT_THAT(error.what(), HasSubstr(path.string()));
		}
}

/** Whatever the bytes are, the reader either says what is wrong or returns a truth that can be written again. */
TEST(TruthFile, DamagedBytesNeverPassForSomethingElse)
{
	TruthLog log = twoFrames();
	log.frames[0].free_paths = test::evenPaths(2.5F);
	const std::string good = truthText(log);
	const auto path = test::freshFolder() / "log.truth.json";
	std::mt19937_64 random(7);
	int refused = 0;
	for (int round = 0; round < 600; ++round)
	{
		std::string bytes = good;
		const std::size_t at = random() % bytes.size();
		switch (round % 4)
		{
			case 0:
				bytes[at] = static_cast<char>(random());
				break;
			case 1:
				bytes.resize(at);
				break;
			case 2:
				bytes.erase(at, 1 + random() % 20);
				break;
			default:
				bytes.insert(at, bytes.substr(random() % bytes.size(), 1 + random() % 20));
		}
		test::writeFile(path, bytes);
		try
		{
			const TruthLog read = readTruth(path);
			EXPECT_FALSE(truthText(read).empty());
		}
		catch (const InputError& error)
		{
			++refused;
			EXPECT_THAT(error.what(), testing::StartsWith(path.string() + ": "));
		}
	}
	EXPECT_GT(refused, 300);
}

TEST(TruthFile, EveryKeyIsNeeded)
{
	const auto good = nlohmann::ordered_json::parse(truthText(twoFrames()));
	const auto path = test::freshFolder() / "log.truth.json";
	const auto flat = good.flatten();
	for (const auto& [pointer, value] : flat.items())
	{
		if (pointer.find("/free/") != std::string::npos) continue;
		auto document = good;
		const nlohmann::ordered_json::json_pointer at(pointer);
		auto& parent = document[at.parent_pointer()];
		if (!parent.is_object()) continue;
		parent.erase(at.back());
		test::writeFile(path, document.dump());
		EXPECT_THROW((void)readTruth(path), InputError) << pointer;
	}
}
