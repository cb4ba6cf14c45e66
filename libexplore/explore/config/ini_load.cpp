#include <explore/config/ini.h>
#include <explore/config/ini_check.h>
#include <explore/config/ini_file.h>
#include <explore/config/ini_text.h>
#include <explore/core/errors.h>

#include <cstddef>

namespace explore
{
namespace
{
/** Writes the values into the fields that they belong to. */
class Assigner : public FieldVisitor
{
public:
	explicit Assigner(const FieldValues& values) : m_values(values) {}

	void section(std::string_view name, std::string_view) override { m_section = name; }
	void real(std::string_view key, double& value, Bounds, std::string_view, std::string_view) override
	{
		assign(key, value);
	}
	void angle(std::string_view key, double& value_rad, Bounds, std::string_view, std::string_view) override
	{
		assign(key, value_rad);
	}
	void integer(std::string_view key, int& value, Bounds, std::string_view, std::string_view) override
	{
		assign(key, value);
	}
	void flag(std::string_view key, bool& value, std::string_view) override { assign(key, value); }
	void text(std::string_view key, std::string& value, std::string_view) override { assign(key, value); }
	void choiceIndex(std::string_view key, int& index, std::span<const std::string_view>, std::string_view) override
	{
		assign(key, index);
	}

private:
	template <class Value>
	void assign(std::string_view key, Value& value)
	{
		const auto given = m_values.find({m_section, std::string(key)});
		if (given != m_values.end()) value = std::get<Value>(given->second);
	}

	const FieldValues& m_values;
	std::string m_section;
};

/** All problems in one message, one a line; what goes beyond the first few is only counted. */
void throwIfAny(const std::vector<std::string>& problems)
{
	constexpr std::size_t kMost = 20;
	if (problems.empty()) return;
	std::string message = problems.front();
	for (std::size_t i = 1; i < problems.size() && i < kMost; ++i) message.append("\n").append(problems[i]);
	if (problems.size() > kMost) message += "\n... and " + std::to_string(problems.size() - kMost) + " more";
	throw ConfigError(message);
}
}  // namespace

void loadIni(const std::filesystem::path& path, const std::vector<std::string>& overrides, const DescribeFields& fields)
{
	loadIniText(path.string(), readIniFile(path), overrides, fields);
}

void loadIniText(const std::string& name, const std::string& text, const std::vector<std::string>& overrides,
                 const DescribeFields& fields)
{
	IniChecker checker(fields);
	std::vector<std::string> problems;
	for (const auto& [line, what] : checker.checkDocument(parseIni(name, text)))
		problems.push_back(placeOf(name, line) + what);
	for (const auto& assignment : overrides)
		if (const std::string what = checker.checkOverride(assignment); !what.empty())
			problems.push_back("--set " + shown(assignment) + ": " + what);
	throwIfAny(problems);

	Assigner assigner(checker.values());
	fields(assigner);
}
}  // namespace explore
