// Overrides from the command line: they win over the file and are checked as strictly.
#include <gmock/gmock.h>

#include "every_kind.h"

namespace explore
{
namespace
{
using test::loaded;
using test::refusal;
using testing::HasSubstr;
using testing::StartsWith;

TEST(IniOverride, winsOverTheFileAndTheLastWins)
{
	EXPECT_EQ(loaded("[shape]\nlength=2", {"shape.length=3", "SHAPE.Length = 4"}).length_m, 4);
}

TEST(IniOverride, theValueIsTakenLiterally)
{
	EXPECT_EQ(loaded("", {"paint.path=a=b.c//d"}).path, "a=b.c//d");
	EXPECT_EQ(loaded("", {"paint.path=a // b"}).path, "a // b");
	EXPECT_EQ(loaded("", {"paint.path="}).path, "");
}

TEST(IniOverride, errorsNameTheArgument)
{
	EXPECT_EQ(refusal("", {"shape.length=abc"}),
	          "--set shape.length=abc: not a number; accepted: a number from -10 to 10 m");
	EXPECT_EQ(refusal("", {"shape.lenght=1"}), "--set shape.lenght=1: unknown key; did you mean length?");
	EXPECT_THAT(refusal("", {"shap.length=1"}),
	            StartsWith("--set shap.length=1: unknown section; did you mean [shape]?"));
}

TEST(IniOverride, malformedArgumentsAreRefused)
{
	for (const std::string argument :
	     {"", "shape", "shape.length", "length=1", "=", ".=", "shape=1.5", "shape.=1", ".x=1"})
		EXPECT_THAT(refusal("", {argument}), StartsWith("--set " + argument + ": ")) << argument;
	EXPECT_THAT(refusal("", {"length=1.5"}), HasSubstr("accepted: section.key=value"));
}

TEST(IniOverride, doesNotExcuseAMistakeInTheFile)
{
	EXPECT_THAT(refusal("[shape]\nlength=x", {"shape.length=3"}), StartsWith("a.ini:2: "));
}
}  // namespace
}  // namespace explore
