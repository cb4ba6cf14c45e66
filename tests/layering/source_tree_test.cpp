#include "source_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

using namespace explore::test;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

namespace
{
std::vector<std::string> targets(std::string_view text)
{
	std::vector<std::string> result;
	for (const Include& include : includesOf(text)) result.push_back(include.target);
	return result;
}
}  // namespace

TEST(Includes, AreFoundWithTheirFormAndLine)
{
	const auto includes = includesOf("#pragma once\n#include <explore/core/a.h>\n\n  #  include\t\"b.h\"  // why\n");
	ASSERT_THAT(includes, SizeIs(2));
	EXPECT_EQ(includes[0].target, "explore/core/a.h");
	EXPECT_EQ(includes[0].form, Include::Form::angled);
	EXPECT_EQ(includes[0].line, 2);
	EXPECT_EQ(includes[1].target, "b.h");
	EXPECT_EQ(includes[1].form, Include::Form::quoted);
	EXPECT_EQ(includes[1].line, 4);
}

TEST(Includes, ThroughAMacroAreComputed)
{
	const auto includes = includesOf("#include HEADER\n#include <unclosed\n");
	ASSERT_THAT(includes, SizeIs(2));
	EXPECT_EQ(includes[0].form, Include::Form::computed);
	EXPECT_EQ(includes[0].target, "HEADER");
	EXPECT_EQ(includes[1].form, Include::Form::computed);
}

TEST(Includes, InCommentsDoNotCount)
{
	EXPECT_THAT(targets("// #include <a>\n/* \n#include <b>\n*/\n/* x */ #include <c>\n"), ElementsAre("c"));
	EXPECT_THAT(targets("/* never closed\n#include <a>\n"), IsEmpty());
}

TEST(Includes, InLiteralsDoNotCount)
{
	EXPECT_THAT(targets("auto s = R\"x(\n#include <a>\n)x\";\n#include <b>\n"), ElementsAre("b"));
	EXPECT_THAT(targets("auto s = \"/*\";\n#include <a>\nauto t = \"*/\";\n"), ElementsAre("a"));
	EXPECT_THAT(targets("auto s = \"\\\"/*\";\n#include <a>\n"), ElementsAre("a"));
	EXPECT_THAT(targets("auto n = 1'000; auto c = '\"';\n#include <a>\nauto m = 1'000;\n"), ElementsAre("a"));
}

TEST(Includes, BehindConditionsCount)
{
	EXPECT_THAT(targets("#ifdef NEVER\n#include <a>\n#endif\n"), ElementsAre("a"));
}

TEST(WithoutComments, KeepsEveryLineBreak)
{
	const std::string text = "int a; // one\n/* two\nthree */ int b;\nauto s = R\"(\n\n)\";\n";
	const std::string code = withoutComments(text);
	EXPECT_EQ(code.size(), text.size());
	EXPECT_EQ(std::count(code.begin(), code.end(), '\n'), 6);
	EXPECT_NE(code.find("int b;"), std::string::npos);
	EXPECT_EQ(code.find("three"), std::string::npos);
}

TEST(Resolve, StartsAtAnIncludeRootOrBesideTheFile)
{
	const SourceTree tree{{"libexplore/explore/core/a.h", ""}, {"apps/x/b.h", ""}, {"apps/x/main.cpp", ""}};
	const auto resolved = [&](const std::string& target, Include::Form form) {
		return resolve(tree, "apps/x/main.cpp", {target, form, 1});
	};
	EXPECT_EQ(resolved("explore/core/a.h", Include::Form::angled), "libexplore/explore/core/a.h");
	EXPECT_EQ(resolved("b.h", Include::Form::quoted), "apps/x/b.h");
	EXPECT_EQ(resolved("../../libexplore/explore/core/a.h", Include::Form::quoted), "libexplore/explore/core/a.h");
	EXPECT_EQ(resolved("x/b.h", Include::Form::angled), "apps/x/b.h");
	EXPECT_EQ(resolved("vector", Include::Form::angled), "");
	EXPECT_EQ(resolved("b.h", Include::Form::angled), "");
}

TEST(ReadSources, ReturnsSourcesByTheirPathBelowTheRoot)
{
	const std::filesystem::path root = std::filesystem::path(testing::TempDir()) / "read_sources_test";
	std::filesystem::create_directories(root / "lib/core");
	std::ofstream(root / "lib/core/a.h") << "one\n";
	std::ofstream(root / "lib/core/notes.md") << "two\n";
	std::ofstream(root / "lib/layer.cmake") << "three\n";
	EXPECT_EQ(readSources(root, {"lib"}), (SourceTree{{"lib/core/a.h", "one\n"}, {"lib/layer.cmake", "three\n"}}));
	std::filesystem::remove_all(root);
}
