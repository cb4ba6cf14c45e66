// Macros, comments and continued lines: as MRPT resolves them, with line numbers that stay true.
#include <explore/config/ini_lines.h>
#include <gmock/gmock.h>

#include <cstdlib>

#include "every_kind.h"

namespace explore
{
namespace
{
using test::loaded;
using test::refusal;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(IniLines, define)
{
	const auto config = loaded("@define SIZE 2.5 // metres\n@define N 4\n[shape]\nlength = ${SIZE}\ncount=${N}");
	EXPECT_EQ(config.length_m, 2.5);
	EXPECT_EQ(config.count, 4);
}

TEST(IniLines, eval)
{
	EXPECT_NEAR(loaded("@define R 0.25\n[shape]\nlength = $eval{2*R + sqrt(4)}").length_m, 2.5, 1e-6);
	EXPECT_EQ(loaded("[shape]\ncount = $eval{2*3}").count, 6);
}

TEST(IniLines, environment)
{
	setenv("EXPLORE_TEST_FOLDER", "/some/folder", 1);
	EXPECT_EQ(loaded("[paint]\npath = $env{EXPLORE_TEST_FOLDER}/a.png").path, "/some/folder/a.png");
}

TEST(IniLines, anUnsetVariableIsNoEmptyText)
{
	unsetenv("EXPLORE_TEST_UNSET");
	EXPECT_THAT(refusal("\n[paint]\npath = $env{EXPLORE_TEST_UNSET}/a.png"),
	            AllOf(StartsWith("a.ini:3: "), HasSubstr("EXPLORE_TEST_UNSET"), HasSubstr("not set")));
	EXPECT_THAT(refusal("[shape]\nlength = $env{EXPLORE_TEST_UNSET}"), Not(HasSubstr("\n")));
	EXPECT_EQ(refusal("# $env{EXPLORE_TEST_UNSET}\n[paint]\npath = a // or $env{EXPLORE_TEST_UNSET}"), "");
}

TEST(IniLines, aVariableThatHoldsMacrosIsRefused)
{
	setenv("EXPLORE_TEST_LOOP", "$env{EXPLORE_TEST_LOOP}", 1);
	EXPECT_THAT(refusal("[paint]\npath = $env{EXPLORE_TEST_LOOP}"),
	            AllOf(StartsWith("a.ini:2: "), HasSubstr("EXPLORE_TEST_LOOP")));
	setenv("EXPLORE_TEST_LOOP", "a\n[shape]\ncount=1", 1);
	EXPECT_THAT(refusal("[paint]\npath = $env{EXPLORE_TEST_LOOP}"), HasSubstr("control characters"));
}

TEST(IniLines, lineNumbersAreThoseOfTheFile)
{
	const std::string head = "@define A 1\n\n# comment\n[shape]\ncount = \\\n  ${A}\n// comment\r\n";
	EXPECT_EQ(loaded(head).count, 1);
	EXPECT_THAT(refusal(head + "length = abc"), StartsWith("a.ini:8: [shape] length = \"abc\""));
	EXPECT_THAT(refusal("[shape]\rcount = 1\rlength = x\r"), StartsWith("a.ini:3: "));
}

TEST(IniLines, brokenMacrosNameTheirLineAndNotTheCallStack)
{
	EXPECT_THAT(refusal("[shape]\n\nlength = ${NONE}"), AllOf(StartsWith("a.ini:3: "), HasSubstr("NONE")));
	EXPECT_THAT(refusal("[shape]\nlength = ${NONE"), AllOf(StartsWith("a.ini:2: "), HasSubstr("closing")));
	EXPECT_THAT(refusal("[shape]\nlength = $eval{1+foo}"),
	            AllOf(StartsWith("a.ini:2: "), HasSubstr("1+foo"), HasSubstr("foo"), Not(HasSubstr("\n"))));
	EXPECT_THAT(refusal("[shape]\nlength = 1 @define A 2"), AllOf(StartsWith("a.ini:2: "), HasSubstr("@define")));
}

TEST(IniLines, commentsHaveNoEffect)
{
	const std::string ini =
	    "# C:\\folder\\\n[shape] // ${NONE} \\\n; @define A\ncount = 5 // $eval{(} \\\n  // count = 7\n [paint] # "
	    "old\n";
	EXPECT_EQ(loaded(ini).count, 5);
}

TEST(IniLines, aByteOrderMarkIsSkipped)
{
	EXPECT_EQ(loaded("\xEF\xBB\xBF[shape]\r\ncount = 5\r\n").count, 5);
}

TEST(IniLines, binaryFilesAreRefused)
{
	EXPECT_THAT(refusal(std::string("[shape]\ncount\0=1", 16)),
	            AllOf(StartsWith("a.ini:2: "), HasSubstr("the byte 0")));
	EXPECT_THAT(refusal("\x1f\x8b\x08 gz"), HasSubstr("not an ini file"));
}
}  // namespace
}  // namespace explore
