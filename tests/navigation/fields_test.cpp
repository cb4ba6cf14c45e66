#include <explore/navigation/avoider.h>
#include <explore/navigation/heading.h>
#include <explore/navigation/mission_config.h>
#include <explore/navigation/near_field_guard.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

namespace explore
{
namespace
{
/** Writes down each field as "section.key" with its value in the unit of the ini file, and checks what all must keep.
 */
class Recorder : public FieldVisitor
{
public:
	void section(std::string_view name, std::string_view /*help*/) override { m_section = name; }
	void real(std::string_view key, double& value, Bounds bounds, std::string_view /*unit*/,
	          std::string_view help) override
	{
		note(key, value, bounds, help);
	}
	void angle(std::string_view key, double& value_rad, Bounds bounds_deg, std::string_view unit,
	           std::string_view help) override
	{
		EXPECT_TRUE(key.ends_with("_deg")) << key;
		EXPECT_EQ(unit, "deg") << key;
		note(key, value_rad * 180.0 / std::numbers::pi, bounds_deg, help);
	}
	void integer(std::string_view key, int& value, Bounds bounds, std::string_view /*unit*/,
	             std::string_view help) override
	{
		note(key, value, bounds, help);
	}
	void flag(std::string_view key, bool& value, std::string_view help) override
	{
		note(key, value ? 1 : 0, {0, 1}, help);
	}
	void text(std::string_view key, std::string& value, std::string_view help) override
	{
		EXPECT_FALSE(help.empty()) << key;
		EXPECT_TRUE(m_texts.emplace(m_section + "." + std::string(key), value).second) << key << " twice";
	}
	void choiceIndex(std::string_view key, int& index, std::span<const std::string_view> names,
	                 std::string_view help) override
	{
		note(key, index, {0.0, static_cast<double>(names.size()) - 1.0}, help);
		m_names.assign(names.begin(), names.end());
	}

	[[nodiscard]] const std::map<std::string, double>& values() const { return m_values; }
	[[nodiscard]] const std::map<std::string, std::string>& texts() const { return m_texts; }
	/** Of the last choice. */
	[[nodiscard]] const std::vector<std::string>& names() const { return m_names; }

private:
	void note(std::string_view key, double value, Bounds bounds, std::string_view help)
	{
		EXPECT_GE(value, bounds.min) << key;
		EXPECT_LE(value, bounds.max) << key;
		EXPECT_FALSE(help.empty()) << key;
		const bool fresh = m_values.emplace(m_section + "." + std::string(key), value).second;
		EXPECT_TRUE(fresh) << key << " twice";
	}

	std::string m_section;
	std::map<std::string, double> m_values;
	std::map<std::string, std::string> m_texts;
	std::vector<std::string> m_names;
};

using testing::DoubleNear;
using testing::Pair;
using testing::UnorderedElementsAre;

TEST(Fields, AvoiderHasThePapersDefaults)
{
	Recorder recorder;
	AvoiderConfig config;
	describe(recorder, config);
	EXPECT_THAT(
	    recorder.values(),
	    UnorderedElementsAre(Pair("avoider.method", 0), Pair("avoider.leave_out", 0),
	                         Pair("avoider.sector_deg", DoubleNear(45, 1e-9)),
	                         Pair("avoider.resolution_deg", DoubleNear(0.5, 1e-9)), Pair("avoider.max_range", 5),
	                         Pair("avoider.clearance", 0.05), Pair("avoider.clearance_range", 1.0),
	                         Pair("avoider.step_height", 0.05), Pair("avoider.max_elevation_deg", DoubleNear(30, 1e-9)),
	                         Pair("avoider.elevation_step_deg", DoubleNear(10, 1e-9))));
	EXPECT_THAT(recorder.names(), testing::ElementsAre("none", "swept_corridor", "unseen_blocks"));
}

TEST(Fields, HeadingAndGuardShareASection)
{
	Recorder recorder;
	HeadingConfig heading;
	NearFieldGuardConfig guard;
	describe(recorder, heading);
	describe(recorder, guard);
	EXPECT_THAT(recorder.values(),
	            UnorderedElementsAre(Pair("heading.stop_margin", 0.10), Pair("heading.reaction_time", 0.3),
	                                 Pair("heading.max_frame_gap", 0.5), Pair("heading.min_valid_pixels", 500),
	                                 Pair("heading.near_warn_distance", 0.3), Pair("heading.no_return_rise", 0.3)));
}

TEST(Fields, TheMissionExploresEverywhereAndForAsLongAsItTakes)
{
	Recorder recorder;
	MissionConfig config;
	describe(recorder, config);
	EXPECT_THAT(recorder.names(), testing::ElementsAre("paper", "nearest_frontier", "explore"));
	using testing::_;
	EXPECT_THAT(recorder.values(),
	            UnorderedElementsAre(Pair("goal.policy", 2), Pair("plan.clearance", _), Pair("plan.squeeze", _),
	                                 Pair("plan.comfort", _), Pair("plan.clearance_cost", _),
	                                 Pair("plan.view_range", _), Pair("plan.view_angle_deg", DoubleNear(57, 1e-6)),
	                                 Pair("plan.view_height_deg", DoubleNear(45, 1e-6)), Pair("plan.view_depth", _),
	                                 Pair("plan.min_gain", _), Pair("plan.pocket_worth", _), Pair("plan.turn_cost", _),
	                                 Pair("plan.arrive", _), Pair("plan.home", _), Pair("plan.switch_gain", _),
	                                 Pair("plan.return_gain", _), Pair("plan.period", _), Pair("bounds.enabled", 0),
	                                 Pair("bounds.min_x", _), Pair("bounds.max_x", _), Pair("bounds.min_y", _),
	                                 Pair("bounds.max_y", _), Pair("budget.time", 0), Pair("budget.path", 0),
	                                 Pair("budget.reserve", 0.3)));
	EXPECT_THAT(recorder.texts(), testing::ElementsAre(Pair("bounds.keep_out", "")));
}
}  // namespace
}  // namespace explore
