// Whatever bytes an ini file holds, loading ends with a config or a ConfigError; and where MRPT's own reader and ours
// both accept a file, they read the same.
#include <explore/config/ini_document.h>
#include <explore/config/ini_text.h>
#include <gmock/gmock.h>
#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/config/config_parser.h>

#include <array>
#include <map>
#include <random>

#include "every_kind.h"

namespace explore
{
namespace
{
std::string randomBytes(std::mt19937& random)
{
	std::string bytes(random() % 200, ' ');
	for (char& c : bytes) c = static_cast<char>(random() % 256);
	return bytes;
}

/** Pieces of the syntax in any order. */
std::string randomSyntax(std::mt19937& random)
{
	static constexpr std::array<std::string_view, 30> kPieces{
	    "[",  "]",    "shape", "paint", "length", "count", "path",     "=",  " = ",    "\n",
	    "\n", "\r\n", "\\\n",  "//",    " // ",   "# ",    "@define ", "${", "$eval{", "$env{",
	    "}",  "\"",   "1",     "-.5",   "1e999",  "a",     " ",        "\t", "((",     "HOME"};
	std::string text;
	for (std::size_t i = random() % 40; i > 0; --i) text += kPieces[random() % kPieces.size()];
	return text;
}

/** An ini with some of its bytes changed, removed or doubled. */
std::string mutated(std::mt19937& random, std::string text)
{
	for (std::size_t i = random() % 6 + 1; i > 0 && !text.empty(); --i)
	{
		const std::size_t at = random() % text.size();
		switch (random() % 3)
		{
			case 0:
				text[at] = static_cast<char>(random() % 256);
				break;
			case 1:
				text.erase(at, random() % 5);
				break;
			default:
				text.insert(at, text.substr(random() % text.size(), 5));
				break;
		}
	}
	return text;
}

/** Anything but a ConfigError escapes and fails the test. A config that was accepted can be saved and loaded again. */
void checkSurvives(const std::string& text)
{
	SCOPED_TRACE(testing::PrintToString(text));
	try
	{
		test::EveryKind config = test::loaded(text);
		EXPECT_EQ(test::loaded(dumpIni(test::fieldsOf(config))), config);
	}
	catch (const ConfigError& error)
	{
		EXPECT_STRNE(error.what(), "");
	}
}

TEST(IniFuzz, anyBytesAreLoadedOrRefused)
{
	std::mt19937 random(6);
	test::EveryKind config;
	const std::string ini = dumpIni(test::fieldsOf(config));
	for (int i = 0; i < 2000; ++i)
	{
		checkSurvives(randomBytes(random));
		checkSurvives(randomSyntax(random));
		if (i % 4 == 0) checkSurvives(mutated(random, ini));
	}
}

TEST(IniFuzz, deeplyNestedFormulasAreRefused)
{
	EXPECT_NE(test::refusal("[shape]\nlength = $eval{" + std::string(100000, '(') + "}"), "");
}

TEST(IniFuzz, acceptedFilesReadAsWithMrpt)
{
	std::mt19937 random(7);
	static constexpr std::array<std::string_view, 12> kLines{
	    "[shape]\n",       "[ Paint ] \r\n", "@define A 0.5\n", "a = ${A} // x\n", "b=\\\n 2\n", "\n",
	    "c = p q  // r\n", "# c = 4\n",      "; d = 5\n",       "e = $eval{2}\n",  "f = x//y\n", "\tg\t=\t7\t\n"};
	for (int i = 0; i < 500; ++i)
	{
		std::string text = "@define A 1\n[start]\n";
		for (std::size_t n = random() % 12; n > 0; --n) text += kLines[random() % kLines.size()];
		const mrpt::config::CConfigFileMemory mrpt_ini(mrpt::config::config_parser(text));
		std::map<std::string, std::string> ours, theirs;  // for a key given twice the last value counts
		for (const auto& entry : parseIni("a.ini", text).entries)
		{
			ours[entry.section + "." + entry.key] = entry.value;
			theirs[entry.section + "." + entry.key] =
			    trimmed(mrpt_ini.read_string(entry.section, entry.key, "missing"));
		}
		ASSERT_EQ(ours, theirs) << text;
	}
}
}  // namespace
}  // namespace explore
