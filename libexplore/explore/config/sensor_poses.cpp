#include <explore/config/ini_document.h>
#include <explore/config/ini_file.h>
#include <explore/config/ini_text.h>
#include <explore/config/number_text.h>
#include <explore/config/sensor_poses.h>
#include <explore/core/errors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace explore
{
namespace
{
/** The constructor's order of CPose3D; the last three are angles. */
constexpr std::array<std::string_view, 6> kPoseKeys{"pose_x",   "pose_y",     "pose_z",
                                                    "pose_yaw", "pose_pitch", "pose_roll"};
constexpr std::size_t kFirstAngle = 3;
constexpr std::string_view kLabelKey = "sensorLabel";

/** What the sections of a grabber file say about one sensor. */
struct SensorSection
{
	std::string name;
	std::optional<std::string> label;
	std::array<std::optional<double>, kPoseKeys.size()> pose;

	[[nodiscard]] bool hasPose() const
	{
		return std::any_of(pose.begin(), pose.end(), [](const auto& value) { return value.has_value(); });
	}
	[[nodiscard]] mrpt::poses::CPose3D robotFromSensor() const
	{
		const auto get = [this](std::size_t i) { return pose[i].value_or(0.0); };
		return {get(0), get(1), get(2), get(3), get(4), get(5)};
	}
};

[[noreturn]] void refuse(const std::string& file, const IniEntry& entry, const std::string& what)
{
	throw ConfigError(placeOf(file, entry.line) + "[" + entry.section + "] " + entry.key + " = " +
	                  inQuotes(entry.value) + ": " + what);
}

template <class Value>
void setOnce(std::optional<Value>& target, Value value, const std::string& file, const IniEntry& entry)
{
	if (target) refuse(file, entry, "the key was given before in this section");
	target = std::move(value);
}

void readEntry(SensorSection& sensor, const std::string& file, const IniEntry& entry)
{
	if (sameName(entry.key, kLabelKey)) return setOnce(sensor.label, entry.value, file, entry);
	for (std::size_t i = 0; i < kPoseKeys.size(); ++i)
	{
		if (!sameName(entry.key, kPoseKeys[i])) continue;
		const auto text = withoutRemark(entry.value);
		const auto value = i < kFirstAngle ? parseNumber(text) : parseDegrees(text);
		if (!value)
			refuse(file, entry,
			       std::string("not a number; accepted: a number in ") + (i < kFirstAngle ? "metres" : "degrees") +
			           ", behind which only a // comment may stand");
		setOnce(sensor.pose[i], *value, file, entry);
	}
}

std::vector<SensorSection> readSections(const std::string& file, const IniDocument& document)
{
	std::vector<SensorSection> sections;
	for (const auto& entry : document.entries)
	{
		auto section = std::find_if(sections.begin(), sections.end(),
		                            [&](const SensorSection& known) { return sameName(known.name, entry.section); });
		if (section == sections.end()) section = sections.insert(sections.end(), {entry.section, {}, {}});
		readEntry(*section, file, entry);
	}
	return sections;
}
}  // namespace

SensorPoses loadSensorPoses(const std::filesystem::path& path)
{
	const std::string file = path.string();
	SensorPoses poses;
	for (const auto& section : readSections(file, parseIni(file, readIniFile(path))))
	{
		if (section.name.empty() || !section.hasPose()) continue;
		const std::string label = section.label.value_or(section.name);
		const auto [known, is_new] = poses.emplace(label, section.robotFromSensor());
		if (!is_new && known->second != section.robotFromSensor())
			throw ConfigError(file + ": two sections give different poses of the sensor " + inQuotes(label) +
			                  "; sensorLabel must differ");
	}
	if (poses.empty())
		throw ConfigError(file +
		                  ": no section holds a sensor pose; accepted: sensorLabel with pose_x, pose_y, pose_z "
		                  "[m] and pose_yaw, pose_pitch, pose_roll [deg]");
	return poses;
}
}  // namespace explore
