#include <explore/config/ini_text.h>
#include <explore/config/suggestions.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace explore
{
namespace
{
/** Longer names are no misspelling of any of ours. */
constexpr std::size_t kLongestTypo = 80;

bool sameLetter(char a, char b)
{
	return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/** Greatest distance at which a name still counts as a misspelling of `wanted`. */
std::size_t typoLimit(std::string_view wanted)
{
	return std::max<std::size_t>(2, wanted.size() / 3);
}

/** How far `wanted` is from `name`; a unit that is missing or too much, as in tilt and tilt_deg, is one mistake. */
std::size_t mistakes(std::string_view wanted, std::string_view name)
{
	const std::size_t shorter = std::min(wanted.size(), name.size());
	const auto longer = wanted.size() > name.size() ? wanted : name;
	const bool is_unit = longer.substr(shorter).starts_with('_') && shorter > 0;
	if (is_unit && sameName(wanted.substr(0, shorter), name.substr(0, shorter))) return 1;
	return editDistance(wanted, name);
}

/** The field that `key` in the section `own` stands for: near in spelling, at equal distance near in place. */
const Field* likeliestField(const std::vector<Section>& sections, const Section* own, std::string_view key)
{
	const Field* likeliest = nullptr;
	std::size_t least = 2 * (typoLimit(key) + 1);
	for (const auto& section : sections)
		for (const auto& field : section.fields)
		{
			const std::size_t cost = 2 * mistakes(key, field.key) + (&section == own ? 0 : 1);
			if (cost >= least) continue;
			least = cost;
			likeliest = &field;
		}
	return likeliest;
}

template <class List, class Name>
std::string listed(const List& list, const Name& name_of)
{
	std::string text;
	for (const auto& item : list) text += (text.empty() ? "" : ", ") + name_of(item);
	return text;
}
}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b)
{
	// Three rows of the usual table: row i holds the distances from the first i letters of a.
	std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
	for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
	for (std::size_t i = 1; i <= a.size(); ++i)
	{
		std::swap(before_last, last);
		std::swap(last, row);
		row[0] = i;
		for (std::size_t j = 1; j <= b.size(); ++j)
		{
			const std::size_t replaced = last[j - 1] + (sameLetter(a[i - 1], b[j - 1]) ? 0 : 1);
			row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
			if (i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]))
				row[j] = std::min(row[j], before_last[j - 2] + 1);
		}
	}
	return row[b.size()];
}

std::string suggestSection(const std::vector<Section>& sections, std::string_view wanted)
{
	wanted = wanted.substr(0, kLongestTypo);
	const auto distance = [&](const Section& section) { return editDistance(wanted, section.name); };
	const auto nearest =
	    std::min_element(sections.begin(), sections.end(),
	                     [&](const Section& a, const Section& b) { return distance(a) < distance(b); });
	const bool is_near = nearest != sections.end() && distance(*nearest) <= typoLimit(wanted);
	const auto bracketed = [](const Section& section) { return "[" + section.name + "]"; };
	return (is_near ? "did you mean " + bracketed(*nearest) + "? " : "") + "accepted: " + listed(sections, bracketed);
}

std::string suggestKey(const std::vector<Section>& sections, std::string_view section, std::string_view wanted)
{
	const Section* const own = findSection(sections, section);
	const Field* const meant = likeliestField(sections, own, wanted.substr(0, kLongestTypo));
	if (meant != nullptr)
	{
		const bool is_own = own != nullptr && meant->section == own->name;
		return "did you mean " + (is_own ? "" : "[" + meant->section + "] ") + meant->key + "?";
	}
	if (own == nullptr) return suggestSection(sections, section);
	return "accepted: " + listed(own->fields, [](const Field& field) { return field.key; });
}
}  // namespace explore
