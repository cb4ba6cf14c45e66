// explore-rawlog as a user runs it: import a recording, look at it, and see its exit codes.
#include "apps/program.h"
#include "apps/rawlog_maker.h"
#include "apps/rawlog_program.h"

#include <gmock/gmock.h>

using namespace explore::test;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
fs::path sharedFolder(const std::string& name)
{
	return fs::path(EXPLORE_SOURCE_DIR) / ".." / "shared" / "data" / name;
}

const std::vector<std::string> kImportKinect = {
    "import", "--png", sharedFolder("kinect_stills").string(), "--intrinsics", "525,525,319.5,239.5", "--out"};

std::vector<std::string> importKinectTo(const fs::path& out)
{
	auto arguments = kImportKinect;
	arguments.push_back(out.string());
	return arguments;
}
}  // namespace

TEST(RawlogInfo, DescribesALogAndFindsItIntact)
{
	writeCorridorRawlog(freshFolder() / "log.rawlog", {10});
	const auto result = exploreRawlog({"info", (testFolder() / "log.rawlog").string()});
	EXPECT_EQ(result.exit_code, 0) << result.err;
	EXPECT_THAT(result.out,
	            AllOf(HasSubstr("gzipped"), HasSubstr("CObservation3DRangeScan"), HasSubstr(": 10, 10 Hz"),
	                  HasSubstr("160x120"), HasSubstr("robot poses:   odometry"), HasSubstr("damage:        none")));
}

TEST(RawlogInfo, OfADamagedLogExitsWith3AndTellsWhatWasRead)
{
	writeCorridorRawlog(freshFolder() / "log.rawlog", {10});
	const std::string bytes = readFile(testFolder() / "log.rawlog");
	writeFile(testFolder() / "cut.rawlog", bytes.substr(0, bytes.size() / 2));
	const auto result = exploreRawlog({"info", (testFolder() / "cut.rawlog").string()});
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.out, AllOf(HasSubstr("CObservation3DRangeScan"), HasSubstr("damaged after")));
}

TEST(RawlogInfo, OfWhatIsNoRawlogExitsWith3AndNamesIt)
{
	writeFile(freshFolder() / "text.rawlog", "just some text\n");
	writeFile(testFolder() / "empty.rawlog", "");
	for (const char* name : {"text.rawlog", "empty.rawlog", "missing.rawlog", "."})
	{
		const auto result = exploreRawlog({"info", (testFolder() / name).string()});
		EXPECT_EQ(result.exit_code, 3) << name;
		EXPECT_THAT(result.err, HasSubstr(name));
	}
}

TEST(RawlogUsage, ThatIsWrongExitsWith2)
{
	freshFolder();
	const std::string out = (testFolder() / "a.rawlog").string(), png = testFolder().string();
	for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
	         {},
	         {"info"},
	         {"destroy"},
	         {"import", "--out", out},
	         {"import", "--png", png, "--out", out},
	         {"import", "--png", png, "--tum", png, "--out", out},
	         {"import", "--png", png, "--intrinsics", "1,2,3", "--out", out},
	         {"import", "--png", png, "--intrinsics", "1,2,3,nan", "--out", out},
	         {"import", "--png", png, "--intrinsics", "0,500,300,200", "--out", out},
	         {"import", "--png", png, "--intrinsics", "500,500,300,200", "--depth-scale", "-1", "--out", out},
	         {"import", "--png", png, "--intrinsics", "500,500,300,200", "--pose", "nan,0,0,0,0,0", "--out", out},
	         {"import", "--png", png, "--intrinsics", "500,500,300,200"}})
	{
		const auto result = exploreRawlog(arguments);
		EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(arguments);
		EXPECT_NE(result.err, "");
	}
	EXPECT_FALSE(fs::exists(out));
}

TEST(RawlogUsage, HelpAndVersionExitWith0)
{
	freshFolder();
	EXPECT_EQ(exploreRawlog({"--help"}).exit_code, 0);
	EXPECT_EQ(exploreRawlog({"import", "--help"}).exit_code, 0);
	EXPECT_THAT(exploreRawlog({"--version"}).out, HasSubstr("explore-rawlog"));
}

TEST(RawlogImport, OfPngFilesIsDescribedByInfoAndTheSameEachTime)
{
	if (!fs::exists(sharedFolder("kinect_stills"))) GTEST_SKIP() << sharedFolder("kinect_stills") << " is not there";
	const auto folder = freshFolder();
	for (const char* name : {"a.rawlog", "b.rawlog"})
	{
		auto arguments = importKinectTo(folder / name);
		arguments.insert(arguments.end(), {"--pose", "0.1,0,0.5,0,10,0", "--sensor-label", "KINECT", "--rate", "20"});
		const auto result = exploreRawlog(arguments);
		ASSERT_EQ(result.exit_code, 0) << result.err;
		EXPECT_THAT(result.out, HasSubstr("5 frames"));
	}
	EXPECT_EQ(readFile(folder / "a.rawlog"), readFile(folder / "b.rawlog"));
	EXPECT_THAT(exploreRawlog({"info", (folder / "a.rawlog").string()}).out,
	            AllOf(HasSubstr("'KINECT': 5, 20 Hz"), HasSubstr("640x480, fx 525"),
	                  HasSubstr("x 0.1, y 0, z 0.5 m, yaw 0, pitch 10")));
}

TEST(RawlogImport, ThatCannotBeWrittenExitsWith5)
{
	if (!fs::exists(sharedFolder("kinect_stills"))) GTEST_SKIP() << sharedFolder("kinect_stills") << " is not there";
	const auto folder = freshFolder();
	EXPECT_EQ(exploreRawlog(importKinectTo(folder / "missing" / "a.rawlog")).exit_code, 5);
	const auto full = exploreRawlog(importKinectTo(fs::path("/dev/full")));
	EXPECT_EQ(full.exit_code, 5);
	EXPECT_THAT(full.err, HasSubstr("No space left on device"));
}

TEST(RawlogImport, OfAFolderThatIsNoneOrEmptyExitsWith3)
{
	const auto folder = freshFolder();
	for (const char* name : {".", "missing"})
		for (const char* layout : {"--png", "--tum"})
		{
			const auto result = exploreRawlog({"import", layout, (folder / name).string(), "--intrinsics",
			                                   "500,500,300,200", "--out", (folder / "a.rawlog").string()});
			EXPECT_EQ(result.exit_code, 3) << layout << ' ' << name;
			EXPECT_FALSE(fs::exists(folder / "a.rawlog"));
		}
}
