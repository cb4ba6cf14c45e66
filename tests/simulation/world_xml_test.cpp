#include <explore/core/errors.h>
#include <explore/simulation/sdf/xml.h>
#include <gmock/gmock.h>

#include <random>

namespace explore::simulation
{
namespace
{
using testing::HasSubstr;

std::string refusalOf(const std::string& text)
{
	try
	{
		parseXml(text, "f.xml");
		return "accepted";
	}
	catch (const InputError& error)
	{
		return error.what();
	}
}

TEST(Xml, ElementsAttributesAndText)
{
	const XmlNode root = parseXml(
	    "\xEF\xBB\xBF<?xml version='1.0'?>\n<!DOCTYPE a [ <!ELEMENT a (b)> ]>\n<!-- <no> -->\n"
	    "<a x='1' y = \"&lt;&amp;&quot;'&#65;&#x20AC;\">\n one <b/> two<!-- not this -->\n"
	    "<b-c:d.e><![CDATA[<raw> & ]]></b-c:d.e ></a>\n<!-- end -->\n",
	    "f.xml");
	EXPECT_EQ(root.name, "a");
	EXPECT_EQ(root.line, 4);
	EXPECT_EQ(root.attribute("x"), "1");
	EXPECT_EQ(root.attribute("y"), "<&\"'A\xE2\x82\xAC");
	EXPECT_EQ(root.attribute("z"), "");
	EXPECT_FALSE(root.hasAttribute("z"));
	EXPECT_EQ(root.text, "one  two");
	ASSERT_EQ(root.children.size(), 2U);
	EXPECT_EQ(root.children[0].line, 5);
	EXPECT_EQ(root.children[1].name, "b-c:d.e");
	EXPECT_EQ(root.children[1].line, 6);
	EXPECT_EQ(root.children[1].text, "<raw> &");
}

TEST(Xml, DescendantsAreFoundByPath)
{
	const XmlNode root = parseXml("<a><b><c>1</c></b><b><c>2</c></b></a>", "f.xml");
	EXPECT_EQ(root.textAt("b/c"), "1");
	EXPECT_EQ(root.textAt("b/d"), "");
	EXPECT_EQ(root.descendant("d/c"), nullptr);
}

TEST(Xml, WhatIsNotWellFormedIsRefusedWithItsLine)
{
	for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
	         {"", "f.xml:1: "},
	         {"\n\nhello", "f.xml:3: "},
	         {"<a>\n<b>\n</a>", "f.xml:3: not well-formed XML: </a> closes <b> of line 2"},
	         {"<a>\n<b/>", "<a> of line 1 is not closed"},
	         {"<a x=1/>", "not in quotes"},
	         {"<a x='1' x='2'/>", "twice"},
	         {"<a x='<'/>", "'<'"},
	         {"<a>\n&nbsp;</a>", "f.xml:2: "},
	         {"<a>&#0;</a>", "&#0;"},
	         {"<a>&#x110000;</a>", "&#x110000;"},
	         {"<a>a & b</a>", "&amp;"},
	         {"<a/><b/>", "something follows"},
	         {"<a><!-- </a>", "-->"},
	         {"<a", "name"},
	         {"<a x=", "too early"},
	         {"<1a/>", "name"}})
		EXPECT_THAT(refusalOf(text), HasSubstr(reason)) << text;
}

TEST(Xml, DepthIsLimited)
{
	const auto nested = [](int depth)
	{
		std::string open, close;
		for (int i = 0; i < depth; ++i) open += "<a>", close += "</a>";
		return open + close;
	};
	EXPECT_EQ(refusalOf(nested(150)), "accepted");
	EXPECT_THAT(refusalOf(nested(100'000)), HasSubstr("nested deeper"));
}

TEST(Xml, EscapedTextReadsBack)
{
	const std::string text = "a<b>&\"c'd";
	EXPECT_EQ(parseXml("<a>" + escapeXml(text) + "</a>", "f").text, text);
	EXPECT_EQ(parseXml("<a x=\"" + escapeXml(text) + "\"/>", "f").attribute("x"), text);
}

TEST(Xml, DamagedDocumentsAreReadOrRefusedButNeverWorse)
{
	const std::string sound =
	    "<?xml version='1.0'?><!-- c --><sdf version='1.6'><world name=\"w&amp;\">"
	    "<model name='m'><![CDATA[x]]><pose>1 2 3</pose></model></world></sdf>";
	std::mt19937_64 random(3);
	int accepted = 0;
	for (int round = 0; round < 20'000; ++round)
	{
		std::string text = sound;
		for (std::uint64_t i = 0, changes = 1 + random() % 3; i < changes; ++i)
		{
			const std::size_t place = random() % text.size();
			if (random() % 3 == 0)
				text.erase(place, 1 + random() % 5);
			else
				text[place] = random() % 2 == 0 ? "<>&/'\"!?-[] ="[random() % 13] : static_cast<char>(random() % 256);
			if (text.empty()) break;
		}
		if (refusalOf(text) == "accepted") ++accepted;
	}
	EXPECT_GT(accepted, 100);
	EXPECT_LT(accepted, 15'000);
}
}  // namespace
}  // namespace explore::simulation
