#include <explore/sinks/robot_link/robot_message.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

namespace explore
{
namespace
{
using Parsed = nlohmann::json;
using mrpt::obs::CObservation2DRangeScan;
using mrpt::poses::CPose3D;
using Time = mrpt::Clock::time_point;

/** What a message of the wrong form is left by; it does not leave this file. */
struct Malformed
{
};

void require(bool condition)
{
	if (!condition) throw Malformed();
}

double number(const Parsed& value, double most)
{
	require(value.is_number());
	const auto result = value.get<double>();
	require(std::isfinite(result) && std::abs(result) <= most);
	return result;
}

bool truth(const Parsed& value)
{
	require(value.is_boolean());
	return value.get<bool>();
}

/** The object's `key`, which has to be there. */
const Parsed& at(const Parsed& object, const char* key)
{
	require(object.is_object());
	const auto found = object.find(key);
	require(found != object.end());
	return *found;
}

double numberOr(const Parsed& object, const char* key, double otherwise, double most)
{
	return object.contains(key) ? number(object[key], most) : otherwise;
}

/** Names that nobody reads are mistakes of writing. */
void requireOnly(const Parsed& object, const std::vector<std::string>& names)
{
	require(object.is_object());
	for (const auto& [name, value] : object.items()) require(std::ranges::find(names, name) != names.end());
}

Time timeOf(const Parsed& object, Time received)
{
	constexpr double kLatest_s = 4e9;  // a century from the epoch
	const auto found = object.find("t");
	if (found == object.end() || found->is_null()) return received;
	const double t_s = number(*found, kLatest_s);
	require(t_s > 0.0);
	return mrpt::Clock::fromDouble(t_s);
}

constexpr double kFarthest_m = 1e6, kAngle_rad = 100.0;

CPose3D pose(const Parsed& object)
{
	requireOnly(object, {"t", "x", "y", "z", "yaw", "pitch", "roll"});
	return {number(at(object, "x"), kFarthest_m),       number(at(object, "y"), kFarthest_m),
	        numberOr(object, "z", 0.0, kFarthest_m),    number(at(object, "yaw"), kAngle_rad),
	        numberOr(object, "pitch", 0.0, kAngle_rad), numberOr(object, "roll", 0.0, kAngle_rad)};
}

Eigen::Vector3d acceleration(const Parsed& object)
{
	constexpr double kStrongest_mps2 = 1000.0;
	requireOnly(object, {"t", "acceleration"});
	const Parsed& values = at(object, "acceleration");
	require(values.is_array() && values.size() == 3);
	return {number(values[0], kStrongest_mps2), number(values[1], kStrongest_mps2), number(values[2], kStrongest_mps2)};
}

CPose3D sensorPose(const Parsed& values)
{
	constexpr double kReach_m = 100.0;
	require(values.is_array() && values.size() == 6);
	return {number(values[0], kReach_m),   number(values[1], kReach_m),   number(values[2], kReach_m),
	        number(values[3], kAngle_rad), number(values[4], kAngle_rad), number(values[5], kAngle_rad)};
}

CObservation2DRangeScan scan(const Parsed& object)
{
	constexpr std::size_t kMost = 10'000;
	constexpr double kRange_m = 1e4;
	requireOnly(object, {"t", "aperture", "ranges", "max_range", "pose"});
	CObservation2DRangeScan result;
	result.aperture = static_cast<float>(number(at(object, "aperture"), 2.0 * std::numbers::pi + 1e-6));
	result.maxRange = static_cast<float>(number(at(object, "max_range"), kRange_m));
	require(result.aperture > 0.0F && result.maxRange > 0.0F);
	result.rightToLeft = true;
	if (object.contains("pose")) result.sensorPose = sensorPose(object["pose"]);

	const Parsed& ranges = at(object, "ranges");
	require(ranges.is_array() && ranges.size() >= 2 && ranges.size() <= kMost);
	result.resizeScan(ranges.size());
	for (std::size_t i = 0; i < ranges.size(); ++i)
	{
		const double range_m = ranges[i].is_null() ? 0.0 : number(ranges[i], kRange_m);
		result.setScanRange(i, static_cast<float>(range_m));
		result.setScanRangeValidity(i, range_m > 0.0 && range_m < result.maxRange);
	}
	return result;
}

RobotMessage message(const Parsed& object, Time received)
{
	requireOnly(object, {"pose", "imu", "bumper", "cliff", "scan"});
	require(!object.empty());
	RobotMessage result;
	const auto take = [&](const char* name, auto& place, const auto& read)
	{
		const auto found = object.find(name);
		if (found == object.end()) return;
		auto value = read(*found);  // first: it sees to it that there is an object
		place = {timeOf(*found, received), std::move(value)};
	};
	take("pose", result.map_from_robot, pose);
	take("imu", result.acceleration_mps2, acceleration);
	take("bumper", result.bumper_pressed,
	     [](const Parsed& bumper)
	     {
		     requireOnly(bumper, {"t", "pressed"});
		     return truth(at(bumper, "pressed"));
	     });
	take("cliff", result.cliff_seen,
	     [](const Parsed& cliff)
	     {
		     requireOnly(cliff, {"t", "seen"});
		     return truth(at(cliff, "seen"));
	     });
	take("scan", result.scan, scan);
	if (result.scan) result.scan->value.timestamp = result.scan->time;
	return result;
}
}  // namespace

std::optional<RobotMessage> parseRobotMessage(std::string_view text, Time received)
{
	const Parsed object = Parsed::parse(text, nullptr, false);
	if (object.is_discarded()) return std::nullopt;
	try
	{
		return message(object, received);
	}
	catch (const Malformed&)
	{
		return std::nullopt;
	}
}
}  // namespace explore
