// Strict loading: whatever MRPT would accept without a word is refused with its place and what would be right.
#include <gmock/gmock.h>

#include "every_kind.h"

namespace explore
{
namespace
{
using test::loaded;
using test::refusal;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(IniLoad, setsWhatIsGivenAndKeepsTheRest)
{
	test::EveryKind expected;
	expected.length_m = 2;
	expected.path = "a.png";
	EXPECT_EQ(loaded("[shape]\nlength=2\n[paint]\npath = a.png\n"), expected);
	EXPECT_EQ(loaded(""), test::EveryKind());
}

TEST(IniLoad, letterCaseOfNamesDoesNotMatterAndSectionsMayReopen)
{
	EXPECT_EQ(loaded("[SHAPE]\nLength = 2\n[paint]\nenabled=0\n[ Shape ]\ncount=1").count, 1);
}

TEST(IniLoad, anUnknownKeyNamesTheNearest)
{
	EXPECT_EQ(refusal("[shape]\n\nlenght = 2\n"), "a.ini:3: [shape] lenght = \"2\": unknown key; did you mean length?");
	EXPECT_EQ(refusal("[shape]\ncolour = red\n"),
	          "a.ini:2: [shape] colour = \"red\": unknown key; did you mean [paint] colour?");
}

TEST(IniLoad, anUnknownSectionIsReportedOnce)
{
	EXPECT_EQ(refusal("[shpe]\nlength = 2\nfoo = 3\n"),
	          "a.ini:1: unknown section [shpe]; did you mean [shape]? accepted: [shape], [paint]");
}

TEST(IniLoad, aWrongValueNamesFileLineSectionKeyValueAndWhatIsAccepted)
{
	EXPECT_EQ(refusal("[shape]\nlength = 2,5\n"),
	          "a.ini:2: [shape] length = \"2,5\": not a number; accepted: a number from -10 to 10 m");
}

TEST(IniLoad, aKeyGivenTwiceNamesBothLines)
{
	EXPECT_EQ(refusal("[shape]\nlength = 2\n[paint]\n[shape]\nLENGTH = 2\n"),
	          "a.ini:5: [shape] LENGTH = \"2\": the key was given before, in line 2");
}

TEST(IniLoad, aKeyWithoutSectionIsToldWhereItBelongs)
{
	EXPECT_EQ(refusal("length = 2\n[shape]\n"),
	          "a.ini:1: length = \"2\": stands in no section; did you mean [shape] length?");
}

TEST(IniLoad, linesThatMrptSkipsAreRefused)
{
	EXPECT_THAT(refusal("[shape]\nlength: 2"),
	            AllOf(StartsWith("a.ini:2: "), HasSubstr("neither [section] nor key = value")));
	EXPECT_THAT(refusal("[shape\nlength = 2"), AllOf(StartsWith("a.ini:1: "), HasSubstr("closing ]")));
	EXPECT_THAT(refusal("[shape]\n = 2"), AllOf(StartsWith("a.ini:2: "), HasSubstr("no key")));
	EXPECT_THAT(refusal("[shape] length = 2"), AllOf(StartsWith("a.ini:1: "), HasSubstr("behind a section name")));
	EXPECT_THAT(refusal("[ ]"), AllOf(StartsWith("a.ini:1: "), HasSubstr("without a name")));
}

TEST(IniLoad, allProblemsAreReportedTogetherInFileOrder)
{
	EXPECT_EQ(refusal("[shape]\ncount = x\nfoobar\n[pant]\n[shape]\nlenth = 1\n", {"shape.gain=2"}),
	          "a.ini:2: [shape] count = \"x\": not a whole number; accepted: a whole number from -100 to 100 pieces\n"
	          "a.ini:3: \"foobar\" is neither [section] nor key = value\n"
	          "a.ini:4: unknown section [pant]; did you mean [paint]? accepted: [shape], [paint]\n"
	          "a.ini:6: [shape] lenth = \"1\": unknown key; did you mean length?\n"
	          "--set shape.gain=2: too large; accepted: a number from 0 to 1");
}

TEST(IniLoad, hundredsOfProblemsStayReadable)
{
	std::string ini = "[shape]\n";
	for (int i = 0; i < 500; ++i) ini += "bad" + std::to_string(i) + " = 1\n";
	const std::string message = refusal(ini);
	EXPECT_THAT(message, HasSubstr("... and 480 more"));
	EXPECT_LT(message.size(), 5000U);
}

TEST(IniLoad, longValuesAreCutInMessages)
{
	const std::string message = refusal("[shape]\nlength = " + std::string(100000, 'x'));
	EXPECT_THAT(message, HasSubstr("xxx...\""));
	EXPECT_LT(message.size(), 300U);
}

TEST(IniLoad, aRefusedFileLeavesTheConfigAsItWas)
{
	test::EveryKind config;
	EXPECT_THROW(loadIniText("a.ini", "[shape]\nlength=2\ncount=x", {}, test::fieldsOf(config)), ConfigError);
	EXPECT_EQ(config, test::EveryKind());
}
}  // namespace
}  // namespace explore
