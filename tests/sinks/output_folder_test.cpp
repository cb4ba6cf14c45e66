#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/sinks/output_folder.h>
#include <gmock/gmock.h>

using namespace explore;
namespace fs = std::filesystem;

TEST(OutputFolder, IsCreatedWithItsParents)
{
	const auto folder = test::freshFolder() / "a" / "b";
	prepareOutputFolder(folder);
	EXPECT_TRUE(fs::is_directory(folder));
}

TEST(OutputFolder, AnEarlierRunGoesAndFilesOfOthersStay)
{
	const auto folder = test::freshFolder();
	fs::create_directories(folder / "pictures");
	for (const char* name :
	     {"frames.jsonl", "timing.csv", "summary.json", "trajectory.tum", "truth.tum", "map.ot", "map.bt", "map.pgm",
	      "map.yaml", "doors.geojson", "scene.3Dscene", "annotated.rawlog", "pictures/000010.png"})
		test::writeFile(folder / name, "old");
	for (const char* name : {"notes.txt", "frames.csv", "pictures/mine.png", "pictures/000010.txt"})
		test::writeFile(folder / name, "keep");
	prepareOutputFolder(folder);
	for (const char* name :
	     {"frames.jsonl", "timing.csv", "summary.json", "trajectory.tum", "truth.tum", "map.ot", "map.bt", "map.pgm",
	      "map.yaml", "doors.geojson", "scene.3Dscene", "annotated.rawlog", "pictures/000010.png"})
		EXPECT_FALSE(fs::exists(folder / name)) << name;
	for (const char* name : {"notes.txt", "frames.csv", "pictures/mine.png", "pictures/000010.txt"})
		EXPECT_EQ(test::readFile(folder / name), "keep") << name;
}

TEST(OutputFolder, AFileInItsPlaceIsRefusedAndKept)
{
	const auto path = test::freshFolder() / "file";
	test::writeFile(path, "keep");
	EXPECT_THROW(prepareOutputFolder(path), OutputError);
	EXPECT_THROW(prepareOutputFolder(path / "below"), OutputError);
	EXPECT_EQ(test::readFile(path), "keep");
}
