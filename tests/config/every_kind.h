// A config with every kind of field in two sections, and what its tests say again and again.
#pragma once

#include <explore/config/ini.h>
#include <explore/core/errors.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace explore::test
{
enum class Colour : std::uint8_t
{
	red,
	green,
	dark_blue
};

struct EveryKind
{
	double length_m = 0.1;
	double angle_rad = 0.2617993877991494;  // 15 degrees
	double rate_radps = 1.5707963267948966;
	int count = 3;
	bool enabled = true;
	std::string path;
	Colour colour = Colour::green;
	double gain = 1e-7;

	bool operator==(const EveryKind&) const = default;
};

inline void describe(FieldVisitor& fields, EveryKind& config)
{
	static constexpr std::array<std::string_view, 3> kColours{"red", "green", "dark_blue"};
	fields.section("shape", "What it looks like.");
	fields.real("length", config.length_m, {-10, 10}, "m", "From end to end.");
	fields.degrees("tilt_deg", config.angle_rad, {-180, 180}, "Against the vertical.");
	fields.degreesPerSecond("spin_deg", config.rate_radps, {-720, 720}, "Turning about itself");
	fields.integer("count", config.count, {-100, 100}, "pieces", "How many.");
	fields.section("paint", "How it is painted | and with what.");
	fields.flag("enabled", config.enabled, "Whether it is painted.");
	fields.text("path", config.path, "The picture to paint.");
	fields.choice("colour", config.colour, kColours, "Of the outside.");
	fields.section("shape", "");
	fields.real("gain", config.gain, {0, 1}, "", "A pure number.");
}

/** The described fields of `config`; keep `config` alive. */
inline DescribeFields fieldsOf(EveryKind& config)
{
	return [&config](FieldVisitor& fields) { describe(fields, config); };
}

/** A config loaded from text that stands for the file "a.ini". */
inline EveryKind loaded(const std::string& text, const std::vector<std::string>& overrides = {})
{
	EveryKind config;
	loadIniText("a.ini", text, overrides, fieldsOf(config));
	return config;
}

/** The message with which `text` is refused; "" where it is accepted. */
inline std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {})
{
	try
	{
		loaded(text, overrides);
		return "";
	}
	catch (const ConfigError& error)
	{
		return error.what();
	}
}
}  // namespace explore::test
