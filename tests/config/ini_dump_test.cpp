// The dumped ini: complete, commented, loads back bit for bit, and reads the same with MRPT's own reader.
#include <explore/config/field_list.h>
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/config/config_parser.h>

#include <random>
#include <sstream>

#include "every_kind.h"

namespace explore
{
namespace
{
using test::EveryKind;
using test::fieldsOf;
using testing::HasSubstr;

EveryKind randomConfig(std::mt19937& random)
{
	const auto uniform = [&](double min, double max)
	{ return std::uniform_real_distribution<double>(min, max)(random); };
	EveryKind config;
	config.length_m = uniform(-10, 10);
	config.angle_rad = uniform(-3.14159, 3.14159);
	config.rate_radps = uniform(-12, 12);
	config.count = static_cast<int>(random() % 201) - 100;
	config.enabled = random() % 2 == 0;
	config.colour = static_cast<test::Colour>(random() % 3);
	config.gain = uniform(0, 1) * uniform(0, 1e-9);
	const std::string letters = " a/#;=\\[]$@.\t{}%";
	for (std::size_t i = random() % 8; i > 0; --i) config.path += letters[random() % letters.size()];
	return config;
}

bool canBeKept(const std::string& text)
{
	return text.find("${") == std::string::npos;  // the only macro that these letters can spell
}

TEST(IniDump, theDefaultsComeBack)
{
	EveryKind config;
	EXPECT_EQ(test::loaded(dumpIni(fieldsOf(config))), EveryKind());
}

TEST(IniDump, anyValuesComeBackBitForBit)
{
	std::mt19937 random(4);
	int kept = 0;
	for (int i = 0; i < 3000; ++i)
	{
		EveryKind config = randomConfig(random);
		if (!canBeKept(config.path)) continue;
		const std::string ini = dumpIni(fieldsOf(config));
		ASSERT_EQ(test::loaded(ini), config) << ini;
		ASSERT_EQ(dumpIni(fieldsOf(config)), ini);
		++kept;
	}
	EXPECT_GT(kept, 2000);
}

TEST(IniDump, mrptReadsTheSame)
{
	std::mt19937 random(5);
	for (int i = 0; i < 100; ++i)
	{
		EveryKind config = randomConfig(random);
		config.path = "folder/a b.png";
		const mrpt::config::CConfigFileMemory mrpt_ini(mrpt::config::config_parser(dumpIni(fieldsOf(config))));
		EXPECT_EQ(mrpt_ini.read_double("shape", "length", 99), config.length_m);
		EXPECT_NEAR(mrpt_ini.read_double("shape", "tilt_deg", 999), config.angle_rad * 57.29577951308232, 1e-12);
		EXPECT_EQ(mrpt_ini.read_int("shape", "count", 999), config.count);
		EXPECT_EQ(mrpt_ini.read_bool("paint", "enabled", !config.enabled), config.enabled);
		EXPECT_EQ(mrpt_ini.read_string("paint", "path", ""), config.path);
	}
}

TEST(IniDump, everyKeyIsExplainedOnTheLinesBefore)
{
	EveryKind config;
	const std::string ini = dumpIni(fieldsOf(config));
	EXPECT_THAT(ini, HasSubstr("# What it looks like.\n[shape]\n"));
	EXPECT_THAT(ini, HasSubstr("# From end to end. Accepted: a number from -10 to 10 m.\nlength = 0.1\n"));
	EXPECT_THAT(ini, HasSubstr("# Turning about itself. Accepted: a number from -720 to 720 deg/s.\nspin_deg = 90\n"));
	EXPECT_THAT(ini, HasSubstr("# Of the outside. Accepted: one of red, green, dark_blue.\ncolour = green\n"));
	EXPECT_THAT(ini, HasSubstr("\npath =\n"));
}

TEST(IniDump, noLineIsLongAndNoCommentTrails)
{
	EveryKind config;
	std::istringstream lines(dumpIni(fieldsOf(config)));
	for (std::string line; std::getline(lines, line);)
	{
		EXPECT_LE(line.size(), 100U) << line;
		EXPECT_TRUE(line.starts_with('#') || line.find('#') == std::string::npos) << line;
	}
}

TEST(IniDump, aTextThatNoIniCanHoldIsRefused)
{
	for (const std::string path : {"${HOME}", "$env{HOME}", "a\nb", "\"quoted\"", "@define"})
	{
		EveryKind config;
		config.path = path;
		EXPECT_THROW(dumpIni(fieldsOf(config)), ConfigError) << path;
	}
}
}  // namespace
}  // namespace explore
