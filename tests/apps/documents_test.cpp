#include "support/test_files.h"

#include <common/app_config.h>
#include <explore/config/ini.h>
#include <gtest/gtest.h>

#include <cstdlib>

using namespace explore;
using namespace explore::app;
namespace fs = std::filesystem;

namespace
{
const fs::path kSource = EXPLORE_SOURCE_DIR;

/** Compares, or writes the file anew where EXPLORE_UPDATE_DOCS=1 asks for it. */
void expectCurrent(const fs::path& path, const std::string& expected)
{
	if (std::getenv("EXPLORE_UPDATE_DOCS") != nullptr) test::writeFile(path, expected);
	EXPECT_EQ(test::readFile(path), expected)
	    << path << " is out of date; write it anew with: EXPLORE_UPDATE_DOCS=1 ctest -R apps.Documents";
}

AppConfig shipped(const std::string& name)
{
	ConfigChoices options;
	options.ini = (kSource / "ini" / name).string();
	return loadConfig(options).config;
}

/** The comment that opens the file, up to the first empty line. */
std::string headerOf(const fs::path& path)
{
	const std::string text = test::readFile(path);
	return text.substr(0, text.find("\n\n") + 2);
}
}  // namespace

TEST(Documents, IniReferenceIsCurrent)
{
	AppConfig defaults;
	expectCurrent(kSource / "doc" / "ini-reference.md",
	              iniReference([&](FieldVisitor& fields) { describe(fields, defaults); }));
}

TEST(Documents, ShippedConfigurationsAreCompleteAndCommented)
{
	std::size_t found = 0;
	for (const auto& entry : fs::directory_iterator(kSource / "ini"))
	{
		++found;
		const std::string header = headerOf(entry.path());
		EXPECT_EQ(header.rfind("# " + entry.path().filename().string() + ": ", 0), 0U) << "opens with what it is for";
		expectCurrent(entry.path(), header + dumpConfig(shipped(entry.path().filename().string())));
	}
	EXPECT_GE(found, 4U);
}

TEST(Documents, CorridorHasThePapersParameters)
{
	const auto config = shipped("corridor.ini");
	const auto& perception = config.explorer.perception;
	EXPECT_EQ(config.source.kind, SourceKind::simulator);
	EXPECT_EQ(config.source.simulator.world, "corridor.sdf");
	EXPECT_EQ(config.source.rawlog, "corridor.rawlog");
	EXPECT_EQ(perception.range_filter.max_range_m, 5.0);
	EXPECT_EQ(perception.voxel_grid.voxel_size_m, 0.05);
	EXPECT_EQ(perception.planes.alpha, 0.2);
	EXPECT_EQ(perception.door_gaps.scan_height_m, 0.8);
	EXPECT_EQ(perception.door_gaps.scan_band_m, 0.05);
	EXPECT_EQ(perception.door_gaps.min_gap_m, 0.8);
	EXPECT_EQ(perception.door_gaps.max_gap_m, 1.6);
	EXPECT_NEAR(config.explorer.avoider.sector_rad, 0.7853981633974483, 1e-12);
}

TEST(Documents, WarehouseIsTheMavOfThePapersSecondScenario)
{
	const auto config = shipped("warehouse.ini");
	EXPECT_EQ(config.explorer.perception.range_filter.max_range_m, 8.0);
	EXPECT_EQ(config.explorer.perception.door_gaps.scan_band_m, 0.15);
	EXPECT_EQ(config.explorer.robot.kind, RobotKind::mav);
	EXPECT_EQ(config.explorer.robot.radius_m, 0.30);
	EXPECT_EQ(config.explorer.robot.height_m, 0.25);
	EXPECT_EQ(config.explorer.robot.max_speed_mps, 0.8);
	EXPECT_EQ(config.explorer.robot.min_altitude_m, 0.5);
	EXPECT_EQ(config.explorer.robot.max_altitude_m, 2.0);
}

TEST(Documents, XtionEstimatesTheMount)
{
	EXPECT_EQ(shipped("xtion.ini").source.camera.mount, MountPolicy::estimate);
}
