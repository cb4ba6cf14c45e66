#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/evaluation/json_place.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace explore::evaluation
{
namespace
{
std::string textOfFile(const std::filesystem::path& path)
{
	std::error_code error;
	if (std::filesystem::is_directory(path, error)) throw InputError(path.string() + ": is a folder, not a JSON file");
	std::ifstream file(path, std::ios::binary);
	if (!file) throw InputError(path.string() + ": cannot open: " + std::generic_category().message(errno));
	std::ostringstream text;
	text << file.rdbuf();
	return text.str();
}

/** nlohmann's message without its "[json.exception.…] ". */
std::string reasonOf(const std::exception& error)
{
	const std::string message = error.what();
	const auto end = message.find("] ");
	return end == std::string::npos ? message : message.substr(end + 2);
}

/** A value as a message shows it: short. */
std::string shown(const Json& value)
{
	constexpr std::size_t kLongest = 40;
	if (value.is_object()) return "an object";
	if (value.is_array()) return "an array of " + std::to_string(value.size());
	std::string text = jsonText(value);
	if (text.size() > kLongest) text.replace(kLongest, std::string::npos, "...");
	return text;
}

bool accepts(const NumberRange& range, const Json& value)
{
	return value.is_number() && value.get<double>() >= range.low && value.get<double>() <= range.high;
}

std::string rangeText(const NumberRange& range)
{
	const NumberRange any;
	if (range.low == any.low && range.high == any.high) return "a number";
	if (range.high == any.high) return "a number of at least " + formatNumber(range.low);
	return "a number from " + formatNumber(range.low) + " to " + formatNumber(range.high);
}
}  // namespace

Json readJson(const std::filesystem::path& path)
{
	const std::string text = textOfFile(path);
	try
	{
		return Json::parse(text);
	}
	catch (const Json::exception& error)
	{
		throw InputError(path.string() + ": " + reasonOf(error));
	}
}

JsonPlace JsonPlace::at(std::string_view key) const
{
	const std::string name(key), way = m_way.empty() ? name : m_way + "." + name;
	if (!m_value->is_object()) refuse("an object");
	const auto found = m_value->find(name);
	if (found == m_value->end())
		throw InputError(m_file + ": at " + (m_way.empty() ? "the top" : m_way) + ": the key \"" + name +
		                 "\" is missing");
	return {*found, m_file, way};
}

std::vector<JsonPlace> JsonPlace::items() const
{
	if (!m_value->is_array()) refuse("an array");
	std::vector<JsonPlace> places;
	places.reserve(m_value->size());
	for (const Json& value : *m_value)
		places.push_back({value, m_file, m_way + "[" + std::to_string(places.size()) + "]"});
	return places;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::entries() const
{
	if (!m_value->is_object()) refuse("an object");
	std::vector<std::pair<std::string, JsonPlace>> entries;
	for (const auto& [key, value] : m_value->items()) entries.emplace_back(key, at(key));
	return entries;
}

double JsonPlace::number(const NumberRange& range) const
{
	if (!accepts(range, *m_value)) refuse(rangeText(range));
	return m_value->get<double>();
}

std::uint64_t JsonPlace::count(std::uint64_t high) const
{
	const bool whole = m_value->is_number_unsigned() && m_value->get<std::uint64_t>() <= high;
	if (!whole) refuse("a whole number from 0 to " + std::to_string(high));
	return m_value->get<std::uint64_t>();
}

bool JsonPlace::boolean() const
{
	if (!m_value->is_boolean()) refuse("true or false");
	return m_value->get<bool>();
}

std::string JsonPlace::text() const
{
	if (!m_value->is_string()) refuse("a text");
	return m_value->get<std::string>();
}

std::vector<double> JsonPlace::numbers(const NumberRange& range) const
{
	if (!m_value->is_array()) refuse("an array of numbers");
	std::vector<double> numbers;
	numbers.reserve(m_value->size());
	for (const Json& value : *m_value)
	{
		if (!accepts(range, value)) refuse(value, m_way + "[" + std::to_string(numbers.size()) + "]", rangeText(range));
		numbers.push_back(value.get<double>());
	}
	return numbers;
}

std::vector<double> JsonPlace::numbers(std::size_t size, const NumberRange& range) const
{
	if (!m_value->is_array() || m_value->size() != size) refuse("an array of " + std::to_string(size) + " numbers");
	return numbers(range);
}

Eigen::Vector3d JsonPlace::vector() const
{
	const auto values = numbers(3, {});
	return {values[0], values[1], values[2]};
}

void JsonPlace::refuse(const std::string& accepted) const
{
	refuse(*m_value, m_way, accepted);
}

void JsonPlace::refuse(const Json& value, const std::string& way, const std::string& accepted) const
{
	throw InputError(m_file + ": at " + (way.empty() ? "the top" : way) + ": " + shown(value) +
	                 "; accepted: " + accepted);
}
}  // namespace explore::evaluation
