// The text of one value: what each kind of field accepts, and which texts can be kept in an ini file.
#include <explore/config/field_value.h>
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

TEST(FieldValue, flagsInAllSpellings)
{
	for (const std::string text : {"true", "TRUE", "yes", "On", "1"})
		EXPECT_TRUE(loaded("[paint]\nenabled = " + text).enabled) << text;
	for (const std::string text : {"false", "False", "NO", "off", "0"})
		EXPECT_FALSE(loaded("[paint]\nenabled = " + text).enabled) << text;
	EXPECT_THAT(refusal("[paint]\nenabled = maybe"), HasSubstr("accepted: true or false"));
}

TEST(FieldValue, choicesByNameInAnyCase)
{
	EXPECT_EQ(loaded("[paint]\ncolour = Dark_Blue").colour, test::Colour::dark_blue);
	EXPECT_THAT(refusal("[paint]\ncolour = pink"),
	            AllOf(HasSubstr("\"pink\""), HasSubstr("accepted: one of red, green, dark_blue")));
}

TEST(FieldValue, wholeNumbers)
{
	EXPECT_EQ(loaded("[shape]\ncount = -7").count, -7);
	EXPECT_EQ(loaded("[shape]\ncount = 6.000000e+00").count, 6);  // as $eval{} writes it
	EXPECT_THAT(refusal("[shape]\ncount = 1.5"), HasSubstr("not a whole number"));
	EXPECT_THAT(refusal("[shape]\ncount = 1e30"), HasSubstr("too large"));
}

TEST(FieldValue, boundsAreInclusive)
{
	EXPECT_EQ(loaded("[shape]\nlength = 10\ntilt_deg = -180").length_m, 10);
	EXPECT_THAT(refusal("[shape]\nlength = 10.000000000000002"),
	            AllOf(HasSubstr("too large"), HasSubstr("accepted: a number from -10 to 10 m")));
	EXPECT_THAT(refusal("[shape]\ntilt_deg = -181"), AllOf(HasSubstr("too small"), HasSubstr("-180 to 180 deg")));
	EXPECT_THAT(refusal("[shape]\nspin_deg = 1000"), HasSubstr("-720 to 720 deg/s"));
	EXPECT_THAT(refusal("[shape]\ncount = 101"), HasSubstr("a whole number from -100 to 100 pieces"));
}

TEST(FieldValue, wrongTypesAreRefused)
{
	for (const std::string text : {"abc", "2,5", "nan", "inf", "1 m", "1e999", "\"1\"", "0.1;"})
		EXPECT_THAT(refusal("[shape]\nlength = " + text),
		            HasSubstr("not a number; accepted: a number from -10 to 10 m"))
		    << text;
	EXPECT_THAT(refusal("[shape]\nlength ="), HasSubstr("the value is missing; accepted: a number"));
	EXPECT_THAT(refusal("[shape]\nlength = // metres"), HasSubstr("the value is missing"));
}

TEST(FieldValue, onlyADoubleSlashMayTrail)
{
	EXPECT_EQ(loaded("[shape]\nlength = 2 // metres # really").length_m, 2);
	EXPECT_EQ(loaded("[shape]\nlength = 2// metres").length_m, 2);
	for (const std::string ini :
	     {"[shape]\nlength = 2 # metres", "[shape]\ncount = 2 ; pieces", "[paint]\nenabled = 1 # x",
	      "[paint]\ncolour = red # x", "[paint]\npath = a.png # x", "[paint]\npath = # none"})
		EXPECT_THAT(refusal(ini), HasSubstr("only // may trail a value")) << ini;
}

TEST(FieldValue, textsAreTakenAsTheyAre)
{
	EXPECT_EQ(loaded("[paint]\npath =   a b/c=d.png  // the picture").path, "a b/c=d.png");
	EXPECT_EQ(loaded("[paint]\npath = http://host/a.png").path, "http://host/a.png");
	EXPECT_EQ(loaded("[paint]\npath = // none").path, "");
	EXPECT_EQ(loaded("[paint]\npath = run#2.png").path, "run#2.png");
}

TEST(FieldValue, quotesKeepWhatWouldBeAComment)
{
	EXPECT_EQ(loaded("[paint]\npath = \" run #2 // b.png \" // the picture").path, " run #2 // b.png ");
	EXPECT_THAT(refusal("[paint]\npath = \"a"), HasSubstr("closing double quote"));
	EXPECT_THAT(refusal("[paint]\npath = \"a\" b"), HasSubstr("closing double quote"));
}

TEST(FieldValue, textsThatNoIniCanHoldAreRefused)
{
	for (const std::string text : {"a${b}", "$env{b}", "$eval{1}", "x@define y", "a\nb", "a\x01"})
		EXPECT_THAT(refusal("", {"paint.path=" + text}), HasSubstr("paint.path")) << text;
}
}  // namespace
}  // namespace explore
