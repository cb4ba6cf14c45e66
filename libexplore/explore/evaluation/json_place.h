// Reading JSON strictly: every value asked for must be there, of its type and in bounds; errors name file and place.
#pragma once

#include <explore/sinks/json_values.h>

#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace explore::evaluation
{
/** What a number may be, ends included. */
struct NumberRange
{
	double low = std::numeric_limits<double>::lowest(), high = std::numeric_limits<double>::max();
};

/** The document in the file at `path`. Throws InputError that names the file, and line and column of what is no JSON.
 */
Json readJson(const std::filesystem::path& path);

/** One value of a document, which outlives it. All methods throw InputError: "FILE: at frames[3].t: …". */
class JsonPlace
{
public:
	JsonPlace(const Json& document, std::string file) : m_value(&document), m_file(std::move(file)) {}

	/** The value of a key that must be there. */
	[[nodiscard]] JsonPlace at(std::string_view key) const;
	/** Whether there is that key. */
	[[nodiscard]] bool has(std::string_view key) const { return m_value->is_object() && m_value->contains(key); }
	/** The elements of an array. */
	[[nodiscard]] std::vector<JsonPlace> items() const;
	[[nodiscard]] bool isNull() const { return m_value->is_null(); }
	/** The keys of an object with their values, in the order of the file. */
	[[nodiscard]] std::vector<std::pair<std::string, JsonPlace>> entries() const;

	[[nodiscard]] double number(const NumberRange& range = {}) const;
	/** A whole number from 0 to `high`. */
	[[nodiscard]] std::uint64_t count(std::uint64_t high = std::numeric_limits<std::uint64_t>::max()) const;
	[[nodiscard]] bool boolean() const;
	[[nodiscard]] std::string text() const;
	/** An array of numbers; of `size` elements where that is given. */
	[[nodiscard]] std::vector<double> numbers(const NumberRange& range = {}) const;
	[[nodiscard]] std::vector<double> numbers(std::size_t size, const NumberRange& range) const;
	[[nodiscard]] Eigen::Vector3d vector() const;
	/** The one of `values` whose nameOf() is the text. */
	template <class Enum>
	[[nodiscard]] Enum choice(std::span<const Enum> values) const;

	/** For rules of the caller: what is accepted here. */
	[[noreturn]] void refuse(const std::string& accepted) const;

private:
	JsonPlace(const Json& value, std::string file, std::string way)
	    : m_value(&value), m_file(std::move(file)), m_way(std::move(way))
	{
	}
	[[noreturn]] void refuse(const Json& value, const std::string& way, const std::string& accepted) const;

	const Json* m_value;
	std::string m_file, m_way;
};

template <class Enum>
Enum JsonPlace::choice(std::span<const Enum> values) const
{
	const std::string name = text();
	std::string accepted = "one of";
	for (const Enum value : values)
	{
		if (nameOf(value) == name) return value;
		accepted.append(" ").append(nameOf(value));
	}
	refuse(accepted);
}
}  // namespace explore::evaluation
