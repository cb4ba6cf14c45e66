#include <explore/sinks/html_text.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

using namespace explore;

TEST(Base64, AsTheStandardsExamples)
{
	for (const auto& [bytes, text] :
	     {std::pair{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}})
	{
		EXPECT_EQ(base64(bytes), text);
		EXPECT_EQ(bytesOfBase64(text), bytes);
	}
	const std::string bytes("\xFF\x00\xFE", 3);
	EXPECT_EQ(base64(bytes), "/wD+");
	EXPECT_EQ(bytesOfBase64("/wD+"), bytes);
	EXPECT_THROW(bytesOfBase64("Zg="), std::invalid_argument);
	EXPECT_THROW(bytesOfBase64("Zg!="), std::invalid_argument);
}

TEST(HtmlText, IsEscaped)
{
	EXPECT_EQ(escapedHtml(R"(a < b & "c" > d &lt;)"), "a &lt; b &amp; &quot;c&quot; &gt; d &amp;lt;");
}

TEST(HtmlText, JsonInAScriptCannotEndIt)
{
	const nlohmann::json value{{"path", "</script><!--<script>"}};
	const std::string text = jsonInScript(value.dump());
	EXPECT_EQ(text.find('<'), std::string::npos);
	EXPECT_EQ(nlohmann::json::parse(text), value);
}
