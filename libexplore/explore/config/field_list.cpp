#include <explore/config/field_list.h>
#include <explore/config/ini_text.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace explore
{
namespace
{
class FieldLister : public FieldVisitor
{
public:
	void section(std::string_view name, std::string_view help) override
	{
		const auto known = std::find_if(m_sections.begin(), m_sections.end(),
		                                [&](const Section& section) { return sameName(section.name, name); });
		m_current = static_cast<std::size_t>(known - m_sections.begin());
		if (known == m_sections.end()) m_sections.push_back({std::string(name), "", {}});
		if (m_sections[m_current].help.empty()) m_sections[m_current].help = help;
	}
	void real(std::string_view key, double& value, Bounds bounds, std::string_view unit, std::string_view help) override
	{
		add({FieldKind::real, "", std::string(key), value, bounds, std::string(unit), {}, std::string(help)});
	}
	void angle(std::string_view key, double& value_rad, Bounds bounds_deg, std::string_view unit,
	           std::string_view help) override
	{
		add({FieldKind::angle, "", std::string(key), value_rad, bounds_deg, std::string(unit), {}, std::string(help)});
	}
	void integer(std::string_view key, int& value, Bounds bounds, std::string_view unit, std::string_view help) override
	{
		add({FieldKind::integer, "", std::string(key), value, bounds, std::string(unit), {}, std::string(help)});
	}
	void flag(std::string_view key, bool& value, std::string_view help) override
	{
		add({FieldKind::flag, "", std::string(key), value, {0, 0}, "", {}, std::string(help)});
	}
	void text(std::string_view key, std::string& value, std::string_view help) override
	{
		add({FieldKind::text, "", std::string(key), value, {0, 0}, "", {}, std::string(help)});
	}
	void choiceIndex(std::string_view key, int& index, std::span<const std::string_view> names,
	                 std::string_view help) override
	{
		if (index < 0 || static_cast<std::size_t>(index) >= names.size())
			throw std::logic_error("config field " + std::string(key) + ": more values than names");
		std::vector<std::string> copies(names.begin(), names.end());
		add({FieldKind::choice, "", std::string(key), index, {0, 0}, "", std::move(copies), std::string(help)});
	}

	std::vector<Section> take() { return std::move(m_sections); }

private:
	void add(Field field)
	{
		if (m_sections.empty()) throw std::logic_error("config field " + field.key + ": described before its section");
		Section& section = m_sections[m_current];
		if (findField(section, field.key) != nullptr)
			throw std::logic_error("config field [" + section.name + "] " + field.key + ": described twice");
		field.section = section.name;
		section.fields.push_back(std::move(field));
	}

	std::vector<Section> m_sections;
	std::size_t m_current = 0;
};
}  // namespace

std::vector<Section> listSections(const DescribeFields& describe_fields)
{
	FieldLister lister;
	describe_fields(lister);
	return lister.take();
}

const Section* findSection(const std::vector<Section>& sections, std::string_view name)
{
	const auto found = std::find_if(sections.begin(), sections.end(),
	                                [&](const Section& section) { return sameName(section.name, name); });
	return found == sections.end() ? nullptr : &*found;
}

const Field* findField(const Section& section, std::string_view key)
{
	const auto found = std::find_if(section.fields.begin(), section.fields.end(),
	                                [&](const Field& field) { return sameName(field.key, key); });
	return found == section.fields.end() ? nullptr : &*found;
}
}  // namespace explore
