// explore-rawlog info of a simulated world, as a user runs it.
#include "apps/rawlog_program.h"

#include <gmock/gmock.h>

using namespace explore::test;
using testing::AllOf;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace
{
/** What the program says; its cache goes into the test's folder. */
ProgramResult infoOf(const fs::path& file)
{
	::setenv("XDG_CACHE_HOME", (testFolder() / "cache").c_str(), 1);
	return exploreRawlog({"info", file.string()});
}
}  // namespace

TEST(WorldInfo, TellsGeometryLabelsAndSurfaces)
{
	freshFolder();
	const fs::path world = fs::path(EXPLORE_SOURCE_DIR) / "rawlogs" / "worlds" / "door_gallery.sdf";
	const ProgramResult first = infoOf(world);
	EXPECT_EQ(first.exit_code, 0) << first.err;
	EXPECT_THAT(first.out,
	            AllOf(HasSubstr("world:         door_gallery"), HasSubstr("triangles:"), HasSubstr("mirror 'mirror'"),
	                  HasSubstr("glass 'glass'"), HasSubstr("black 'black'"),
	                  HasSubstr("'ajar_30' ajar at 6 1.56 0, width 0.9"), HasSubstr("corridors:     1"),
	                  HasSubstr("'west_end'"), HasSubstr("routes:        2"), HasSubstr("warnings:      none")));
	EXPECT_FALSE(fs::is_empty(testFolder() / "cache" / "explore-mrpt"));
	EXPECT_EQ(infoOf(world).out, first.out);
}

TEST(WorldInfo, NamesWhatIsNotSupported)
{
	writeFile(
	    freshFolder() / "w.world",
	    "<sdf version='1.6'><world name='w'><model name='m'><link name='l'><visual name='v'><geometry><box><size>1 1 "
	    "1</size></box></geometry></visual><visual name='h'><geometry><heightmap/></geometry></visual></link></model>"
	    "</world></sdf>");
	const ProgramResult result = infoOf(testFolder() / "w.world");
	EXPECT_EQ(result.exit_code, 0);
	EXPECT_THAT(result.out, AllOf(HasSubstr("warnings:      1"), HasSubstr("<heightmap> geometry is not supported")));
}

TEST(WorldInfo, OfABrokenWorldExitsWith3AndNamesTheLine)
{
	writeFile(freshFolder() / "w.sdf", "<sdf version='1.6'>\n<world name='w'>\n</sdf>");
	const ProgramResult result = infoOf(testFolder() / "w.sdf");
	EXPECT_EQ(result.exit_code, 3);
	EXPECT_THAT(result.err, HasSubstr("w.sdf:3: not well-formed XML"));
	EXPECT_EQ(infoOf(testFolder() / "none.sdf").exit_code, 3);
}
