// The nearest name: the edit distance against a slow reference, and what is made of it.
#include <explore/config/suggestions.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <string>

#include "every_kind.h"

namespace explore
{
namespace
{
using testing::HasSubstr;

/** The definition, without a table. */
std::size_t slowDistance(const std::string& a, const std::string& b)
{
	if (a.empty() || b.empty()) return a.size() + b.size();
	const std::string a_rest = a.substr(1), b_rest = b.substr(1);
	std::size_t least = slowDistance(a_rest, b_rest) + (a[0] == b[0] ? 0 : 1);
	least = std::min({least, slowDistance(a_rest, b) + 1, slowDistance(a, b_rest) + 1});
	if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
		least = std::min(least, slowDistance(a.substr(2), b.substr(2)) + 1);
	return least;
}

TEST(EditDistance, agreesWithItsDefinition)
{
	std::mt19937 random(3);
	const auto word = [&]
	{
		std::string letters(random() % 7, ' ');
		for (char& c : letters) c = static_cast<char>('a' + random() % 3);
		return letters;
	};
	for (int i = 0; i < 500; ++i)
	{
		const std::string a = word(), b = word();
		ASSERT_EQ(editDistance(a, b), slowDistance(a, b)) << a << " " << b;
	}
}

TEST(EditDistance, ignoresLetterCase)
{
	EXPECT_EQ(editDistance("Radius", "rAdIUS"), 0U);
}

class Suggestions : public testing::Test
{
protected:
	test::EveryKind m_config;
	std::vector<Section> m_sections = listSections(test::fieldsOf(m_config));
};

TEST_F(Suggestions, aTypoInItsOwnSection)
{
	EXPECT_EQ(suggestKey(m_sections, "shape", "lenght"), "did you mean length?");
	EXPECT_EQ(suggestKey(m_sections, "shape", "TILT"), "did you mean tilt_deg?");
	EXPECT_EQ(suggestKey(m_sections, "shape", "length_m"), "did you mean length?");
}

TEST_F(Suggestions, theRightKeyInTheWrongSection)
{
	EXPECT_EQ(suggestKey(m_sections, "shape", "colour"), "did you mean [paint] colour?");
	EXPECT_EQ(suggestKey(m_sections, "", "gain"), "did you mean [shape] gain?");
}

TEST_F(Suggestions, nothingNearListsTheKeysOfTheSection)
{
	EXPECT_EQ(suggestKey(m_sections, "paint", "zzzzzzzzzz"), "accepted: enabled, path, colour");
}

TEST_F(Suggestions, sections)
{
	EXPECT_EQ(suggestSection(m_sections, "Shpae"), "did you mean [shape]? accepted: [shape], [paint]");
	EXPECT_EQ(suggestSection(m_sections, "wheels-and-axles"), "accepted: [shape], [paint]");
	EXPECT_THAT(suggestKey(m_sections, "", "zzzzzzzzzz"), HasSubstr("[shape], [paint]"));
}
}  // namespace
}  // namespace explore
