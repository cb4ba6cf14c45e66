#include "support/test_files.h"

#include <common/input_paths.h>
#include <explore/core/errors.h>
#include <gmock/gmock.h>

using namespace explore;
using namespace explore::app;
using testing::HasSubstr;

TEST(InputPaths, RecordingBesideTheIniIsFound)
{
	const auto folder = test::freshFolder();
	test::writeFile(folder / "log.rawlog", "x");
	EXPECT_EQ(findRawlogOfIni("log.rawlog", folder / "my.ini"), folder / "log.rawlog");
	EXPECT_EQ(findRawlogOfIni((folder / "log.rawlog").string(), "elsewhere/my.ini"), folder / "log.rawlog");
}

TEST(InputPaths, AMissListsEveryPlace)
{
	const auto folder = test::freshFolder();
	try
	{
		findRawlogOfIni("none.rawlog", folder / "my.ini");
		FAIL() << "found a recording that does not exist";
	}
	catch (const InputError& error)
	{
		EXPECT_THAT(error.what(), HasSubstr("\n  none.rawlog\n"));
		EXPECT_THAT(error.what(), HasSubstr((folder / "none.rawlog").string()));
		EXPECT_THAT(error.what(), HasSubstr(std::string(EXPLORE_SOURCE_DIR) + "/rawlogs/none.rawlog"));
	}
}

TEST(InputPaths, AWorldOfOursIsFoundByItsName)
{
	const auto folder = test::freshFolder();
	EXPECT_EQ(findWorldOfIni("corridor.sdf", folder / "my.ini"),
	          std::filesystem::path(EXPLORE_SOURCE_DIR) / "rawlogs" / "worlds" / "corridor.sdf");
	test::writeFile(folder / "corridor.sdf", "x");
	EXPECT_EQ(findWorldOfIni("corridor.sdf", folder / "my.ini"), folder / "corridor.sdf");
}
