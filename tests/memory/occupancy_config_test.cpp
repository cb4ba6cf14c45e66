#include <explore/config/ini.h>
#include <explore/core/errors.h>
#include <explore/memory/occupancy_config.h>
#include <gtest/gtest.h>

#include <cmath>

namespace explore
{
namespace
{
DescribeFields fieldsOf(OccupancyConfig& config)
{
	return [&](FieldVisitor& fields) { describe(fields, config); };
}

TEST(OccupancyConfig, EveryFieldIsInTheIni)
{
	OccupancyConfig config{.resolution_m = 0.04,
	                       .range_m = 4.5,
	                       .window_margin_m = 2.5,
	                       .hit_probability = 0.75,
	                       .miss_probability = 0.35,
	                       .min_probability = 0.15,
	                       .max_probability = 0.95,
	                       .second_look_range_m = 3.5,
	                       .shadow_baseline_m = 0.06};
	const std::string ini = dumpIni(fieldsOf(config));
	OccupancyConfig loaded;
	loadIniText("test", ini, {}, fieldsOf(loaded));
	EXPECT_EQ(dumpIni(fieldsOf(loaded)), ini);
	EXPECT_EQ(loaded.resolution_m, 0.04);
	EXPECT_EQ(loaded.window_margin_m, 2.5);
	EXPECT_EQ(loaded.shadow_baseline_m, 0.06);
	OccupancyConfig defaults;
	loadIniText("test", dumpIni(fieldsOf(defaults)), {}, fieldsOf(loaded));
	EXPECT_EQ(loaded.max_probability, 0.97);
	EXPECT_THROW(loadIniText("test", "[map]\nresolution = 0\n", {}, fieldsOf(loaded)), ConfigError);
	EXPECT_THROW(loadIniText("test", "[map]\nhit_probability = 0.4\n", {}, fieldsOf(loaded)), ConfigError);
}

TEST(OccupancyConfig, SensorModelIsInLogOdds)
{
	const SensorModel model{OccupancyConfig{}};
	EXPECT_NEAR(model.hit, std::log(0.7 / 0.3), 1e-6);
	EXPECT_NEAR(model.miss, std::log(0.4 / 0.6), 1e-6);
	EXPECT_NEAR(model.lowest, std::log(0.12 / 0.88), 1e-6);
	EXPECT_NEAR(model.highest, std::log(0.97 / 0.03), 1e-6);
}
}  // namespace
}  // namespace explore
