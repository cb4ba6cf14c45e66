#include "layer_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace explore::test;
using testing::AllOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

namespace
{
/** Two library layers and a program: low is pure, high sees low, app sees both. */
const std::vector<Layer> kLayers{{"low", "libexplore/explore/low/", {}, {"Eigen"}, true},
                                 {"high", "libexplore/explore/high/", {"low"}, {"Eigen", "zlib.h"}, false},
                                 {"app", "apps/", {"low", "high"}, {"CLI"}, false}};

const std::string kLow = "libexplore/explore/low/a.h", kHigh = "libexplore/explore/high/b.h", kApp = "apps/main.cpp";

/** The violations of a tree where `path` has the given text and the other files are empty. */
std::vector<std::string> violationsOf(const std::string& path, const std::string& text)
{
	SourceTree tree{{kLow, ""}, {kHigh, ""}, {kApp, ""}};
	tree[path] = text;
	return includeViolations(tree, kLayers);
}
}  // namespace

TEST(IncludeViolations, AcceptWhatTheOrderAllows)
{
	EXPECT_THAT(violationsOf(kLow, "#include <Eigen/Core>\n#include <vector>\n"), IsEmpty());
	EXPECT_THAT(violationsOf(kHigh, "#include <explore/low/a.h>\n#include <zlib.h>\n#include <fstream>\n"), IsEmpty());
	EXPECT_THAT(violationsOf(kApp, "#include <explore/high/b.h>\n#include <CLI/CLI.hpp>\n"), IsEmpty());
	EXPECT_THAT(violationsOf("apps/b.cpp", "#include \"main.cpp\"\n"), IsEmpty());
}

TEST(IncludeViolations, RefuseAnIncludeAgainstTheOrder)
{
	EXPECT_THAT(violationsOf(kLow, "\n#include <explore/high/b.h>\n"),
	            ElementsAre(AllOf(StartsWith(kLow + ":2:"), HasSubstr("not " + kHigh))));
	EXPECT_THAT(violationsOf(kLow, "#include \"../high/b.h\"\n"), ElementsAre(HasSubstr("not " + kHigh)));
	EXPECT_THAT(violationsOf(kHigh, "#include \"../../../apps/main.cpp\"\n"), ElementsAre(HasSubstr("not " + kApp)));
}

TEST(IncludeViolations, RefuseForeignPackages)
{
	EXPECT_THAT(violationsOf(kLow, "#include <zlib.h>\n"), ElementsAre(HasSubstr("may use Eigen, not <zlib.h>")));
	EXPECT_THAT(violationsOf(kHigh, "#include <CLI/CLI.hpp>\n"), ElementsAre(HasSubstr("not <CLI/CLI.hpp>")));
	EXPECT_THAT(violationsOf(kApp, "#include <Eigen/Core>\n"), SizeIs(1));
}

TEST(IncludeViolations, RefuseSideEffectsInPureLayersOnly)
{
	const std::string text = "#include <fstream>\n#include <unistd.h>\n#include <sys/stat.h>\n";
	EXPECT_THAT(violationsOf(kLow, text), SizeIs(3));
	EXPECT_THAT(violationsOf(kHigh, text), IsEmpty());
}

TEST(IncludeViolations, RefuseWhatTheyCannotJudge)
{
	EXPECT_THAT(violationsOf(kLow, "#include HEADER\n"), ElementsAre(HasSubstr("through a macro")));
	EXPECT_THAT(violationsOf(kLow, "#include \"absent.h\"\n"), ElementsAre(HasSubstr("no file of the project")));
	EXPECT_THAT(violationsOf("libexplore/explore/novel/c.h", ""), ElementsAre(HasSubstr("belongs to no layer")));
	EXPECT_THAT(violationsOf(kHigh, "#include <explore/absent.h>\n"), ElementsAre(HasSubstr("<explore/absent.h>")));
}

TEST(LinkViolations, RefuseATargetAgainstTheOrder)
{
	const std::string low = "libexplore/explore/low/layer.cmake", high = "libexplore/explore/high/layer.cmake";
	EXPECT_THAT(linkViolations({{high, "explore_layer(high LINKS explore::low ZLIB::ZLIB)"}}, kLayers), IsEmpty());
	EXPECT_THAT(linkViolations({{low, "explore_layer(low LINKS explore::high)"}}, kLayers),
	            ElementsAre(AllOf(StartsWith(low), HasSubstr("explore::high"))));
}

TEST(ClockViolations, RefuseAClockInPureLayersOnly)
{
	const std::string text = "\n// Clock::now() is for others\nauto t = mrpt::Clock::now();\n";
	EXPECT_THAT(clockViolations({{kLow, text}}, kLayers), ElementsAre(StartsWith(kLow + ":3:")));
	EXPECT_THAT(clockViolations({{kHigh, text}}, kLayers), IsEmpty());
	EXPECT_THAT(clockViolations({{kLow, "auto t = std::chrono::steady_clock::now();"}}, kLayers), SizeIs(1));
}

TEST(IncludeCycles, AreFoundOnceEach)
{
	const auto header = [](const std::string& name) { return "libexplore/explore/low/" + name + ".h"; };
	const auto including = [](const std::string& name) { return "#include <explore/low/" + name + ".h>\n"; };
	const SourceTree chain{
	    {header("a"), including("b") + including("c")}, {header("b"), including("c")}, {header("c"), ""}};
	EXPECT_THAT(includeCycles(chain), IsEmpty());

	SourceTree ring = chain;
	ring[header("c")] = including("a");
	EXPECT_THAT(includeCycles(ring), Each(AllOf(StartsWith(header("a")), testing::EndsWith(header("a")))));
	EXPECT_THAT(includeCycles(ring), testing::Contains(HasSubstr(header("b") + " -> " + header("c"))));

	EXPECT_THAT(includeCycles({{header("self"), "#include \"self.h\"\n"}}),
	            ElementsAre(header("self") + " -> " + header("self")));
}

TEST(ShapeViolations, RefuseHeadersWithoutPurposeOrGuardAndLongFiles)
{
	EXPECT_THAT(shapeViolations({{kLow, "// What it is for.\n#pragma once\n"}}, 250), IsEmpty());
	EXPECT_THAT(shapeViolations({{kLow, "// A purpose on\n// two lines.\n#pragma once\n"}}, 250), IsEmpty());
	EXPECT_THAT(shapeViolations({{kLow, "#pragma once\n"}}, 250), ElementsAre(HasSubstr("does not open")));
	EXPECT_THAT(shapeViolations({{kLow, "// What it is for.\n"}}, 250), ElementsAre(HasSubstr("#pragma once")));
	EXPECT_THAT(shapeViolations({{kLow, "// Only a sentence."}}, 250), ElementsAre(HasSubstr("#pragma once")));
	EXPECT_THAT(shapeViolations({{kLow, ""}}, 250), SizeIs(2));
	EXPECT_THAT(shapeViolations({{kApp, "a\nb\nc\n"}}, 2), ElementsAre(HasSubstr("3 lines")));
	EXPECT_THAT(shapeViolations({{kApp, "a\nb\n"}}, 2), IsEmpty());
}
