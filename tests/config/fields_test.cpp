// The robot's fields and the flat list made of a description.
#include <explore/config/field_list.h>
#include <explore/config/ini.h>
#include <gmock/gmock.h>

#include <numbers>
#include <stdexcept>

#include "every_kind.h"

namespace explore
{
namespace
{
TEST(RobotFields, eachKeySetsItsMember)
{
	RobotConfig robot;
	const auto fields = [&](FieldVisitor& visitor) { describe(visitor, robot); };
	loadIniText("a.ini",
	            "[robot]\nkind=MAV\nradius=0.31\nheight=0.9\nmax_speed=1.25\nmax_acceleration=2.5\n"
	            "max_yaw_rate_deg=90\nmin_altitude=0.75\nmax_altitude=3\n",
	            {}, fields);
	EXPECT_EQ(robot.kind, RobotKind::mav);
	EXPECT_EQ(robot.radius_m, 0.31);
	EXPECT_EQ(robot.height_m, 0.9);
	EXPECT_EQ(robot.max_speed_mps, 1.25);
	EXPECT_EQ(robot.max_acceleration_mps2, 2.5);
	EXPECT_DOUBLE_EQ(robot.max_yaw_rate_radps, std::numbers::pi / 2);
	EXPECT_EQ(robot.min_altitude_m, 0.75);
	EXPECT_EQ(robot.max_altitude_m, 3);
}

TEST(RobotFields, theDefaultsLieWithinTheirBounds)
{
	RobotConfig robot;
	const auto fields = [&](FieldVisitor& visitor) { describe(visitor, robot); };
	EXPECT_NO_THROW(loadIniText("dump", dumpIni(fields), {}, fields));
	EXPECT_EQ(robot.max_yaw_rate_radps, RobotConfig().max_yaw_rate_radps);
}

TEST(FieldList, gathersAReopenedSectionUnderItsFirstHelp)
{
	test::EveryKind config;
	const auto sections = listSections(test::fieldsOf(config));
	ASSERT_EQ(sections.size(), 2U);
	EXPECT_EQ(sections[0].name, "shape");
	EXPECT_EQ(sections[0].help, "What it looks like.");
	EXPECT_EQ(sections[0].fields.back().key, "gain");
	EXPECT_EQ(sections[1].fields.size(), 3U);
}

TEST(FieldList, refusesADescriptionThatClashes)
{
	double value = 0;
	const auto twice = [&](FieldVisitor& fields)
	{
		fields.section("a", "");
		fields.real("x", value, {0, 1}, "", "");
		fields.section("b", "");
		fields.section("a", "");
		fields.real("X", value, {0, 1}, "", "");
	};
	EXPECT_THROW(listSections(twice), std::logic_error);
	const auto nowhere = [&](FieldVisitor& fields) { fields.real("x", value, {0, 1}, "", ""); };
	EXPECT_THROW(listSections(nowhere), std::logic_error);
}
}  // namespace
}  // namespace explore
