// One field list per struct: the same `describe()` drives load, save, bounds, units and documentation.
#pragma once

#include <explore/core/robot.h>

#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace explore
{
/** Accepted interval of a number, ends included, in the unit of the ini file. */
struct Bounds
{
	double min, max;
};

/** A visitor over the fields of a config struct. Every struct has a free function
 *  `void describe(FieldVisitor&, Struct&)` next to it that names each field once. */
class FieldVisitor
{
public:
	virtual ~FieldVisitor() = default;

	/** The fields that follow belong to [name]. Several structs may share a section; their keys may not clash. */
	virtual void section(std::string_view name, std::string_view help) = 0;
	/** A number stored in the unit of the ini file. `unit` is "" for a pure number. */
	virtual void real(std::string_view key, double& value, Bounds bounds, std::string_view unit,
	                  std::string_view help) = 0;
	/** An angle, or a rate of one: radians in the struct, degrees in the ini; `unit` is that of the ini. */
	virtual void angle(std::string_view key, double& value_rad, Bounds bounds_deg, std::string_view unit,
	                   std::string_view help) = 0;
	virtual void integer(std::string_view key, int& value, Bounds bounds, std::string_view unit,
	                     std::string_view help) = 0;
	virtual void flag(std::string_view key, bool& value, std::string_view help) = 0;
	virtual void text(std::string_view key, std::string& value, std::string_view help) = 0;
	/** One of `names`; `index` is its place in the list. */
	virtual void choiceIndex(std::string_view key, int& index, std::span<const std::string_view> names,
	                         std::string_view help) = 0;

	/** An angle; `key` ends in _deg (or is rawlog-grabber's pose_yaw/pitch/roll). */
	void degrees(std::string_view key, double& value_rad, Bounds bounds_deg, std::string_view help)
	{
		angle(key, value_rad, bounds_deg, "deg", help);
	}
	/** A turning rate; `key` ends in _deg. */
	void degreesPerSecond(std::string_view key, double& value_radps, Bounds bounds_degps, std::string_view help)
	{
		angle(key, value_radps, bounds_degps, "deg/s", help);
	}

	/** An enum whose values count 0, 1, … in the order of `names`. */
	template <class Enum>
	void choice(std::string_view key, Enum& value, std::span<const std::string_view> names, std::string_view help)
	{
		static_assert(std::is_enum_v<Enum>);
		int index = static_cast<int>(value);
		choiceIndex(key, index, names, help);
		value = static_cast<Enum>(index);
	}
};

/** [robot] */
void describe(FieldVisitor& fields, RobotConfig& robot);
}  // namespace explore
