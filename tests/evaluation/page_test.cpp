#include <explore/evaluation/csv.h>
#include <explore/evaluation/page.h>
#include <explore/evaluation/text_table.h>
#include <gmock/gmock.h>

#include <algorithm>

using namespace explore::evaluation;
using testing::HasSubstr;
using testing::Not;

namespace
{
/** Logs with bad frames of several kinds. */
std::vector<LogScore> badLogs(std::size_t logs, std::size_t frames)
{
	std::vector<LogScore> result;
	for (std::size_t i = 0; i < logs; ++i)
	{
		LogScore log;
		log.log = "log" + std::to_string(10 + i);
		log.family = "family" + std::to_string(i % 3);
		log.platform = "ground";
		for (std::size_t j = 0; j < frames; ++j)
			log.worst.push_back(
			    {j, static_cast<int>(j), double((i * 7 + j * 13) % 9), "kind" + std::to_string(j % 5), {"remark"}});
		result.push_back(log);
	}
	return result;
}

std::vector<std::pair<std::string, std::size_t>> namesOf(const std::vector<LogScore>& logs)
{
	std::vector<std::pair<std::string, std::size_t>> names;
	for (const Selected& selected : selectWorst(logs)) names.emplace_back(logs[selected.log].log, selected.frame.frame);
	return names;
}
}  // namespace

TEST(Page, EscapesWhatItShowsAndStaysSmall)
{
	Evaluation evaluation;
	evaluation.logs = badLogs(1, 1);
	evaluation.logs[0].log = "<b>&\"";
	const std::string picture(6'000'000, 'x');
	const Selected selected{0, evaluation.logs[0].worst[0]};
	const std::string page = pageText(evaluation, {"a < b", {}}, {{selected, picture}, {selected, picture}});
	EXPECT_THAT(page, HasSubstr("<pre>a &lt; b</pre>"));
	EXPECT_THAT(page, HasSubstr("&lt;b&gt;&amp;&quot;"));
	EXPECT_THAT(page, Not(HasSubstr("<b>")));
	EXPECT_LT(page.size(), 15'000'000U);
	EXPECT_THAT(page, HasSubstr("1 more are in the folder pictures"));
}

TEST(Page, DrawsTheReliabilityOfTheConfidences)
{
	const std::vector<ReliabilityBin> bins{{0.1, 0.3, 50, 0.25, 0.0}, {0.9, 1.0, 200, 0.95, 1.0}};
	const std::string page = pageText({}, {"tables", bins}, {});
	EXPECT_THAT(page, HasSubstr("<svg role=\"img\""));
	EXPECT_THAT(page, HasSubstr("<circle cx=\"140.0\" cy=\"376.0\""));  // 50 + 360 · 0.25, at the foot
	EXPECT_THAT(page, HasSubstr("<circle cx=\"392.0\" cy=\"16.0\""));   // 50 + 360 · 0.95, at the top
	EXPECT_THAT(page, HasSubstr("0.900 to 1.000: 1.000 right of 200"));
	EXPECT_THAT(page, Not(HasSubstr("http")));
	EXPECT_THAT(pageText({}, {"tables", {}}, {}), Not(HasSubstr("<svg")));
}

TEST(WorstFrames, AreTheWorstButFewOfAKind)
{
	const auto logs = badLogs(6, 30);
	const auto selected = selectWorst(logs);
	EXPECT_EQ(selected.size(), 3U * 5U * 2U);
	for (std::size_t i = 1; i < selected.size(); ++i)
		EXPECT_GE(selected[i - 1].frame.badness, selected[i].frame.badness);
}

TEST(WorstFrames, EverySceneryHasItsShare)
{
	auto logs = badLogs(60, 3);
	for (std::size_t i = 0; i < logs.size(); ++i) logs[i].family = "family" + std::to_string(i);
	for (WorstFrame& frame : logs[17].worst) frame.badness = 0.5;
	const auto selected = selectWorst(logs);
	EXPECT_EQ(selected.size(), 96U);
	EXPECT_TRUE(std::ranges::any_of(selected, [](const Selected& frame) { return frame.log == 17; }));
}

/** What merging relies on: the choice among all logs is within the choices among the parts. */
TEST(WorstFrames, TheChoiceAmongAllIsWithinThatOfEachPart)
{
	auto logs = badLogs(40, 40);
	for (std::size_t i = 0; i < logs.size(); ++i) logs[i].noise = std::to_string(i % 5);
	const auto all = namesOf(logs);
	for (LogScore& log : logs) keepWorst(log);
	EXPECT_EQ(namesOf(logs), all);
	for (std::size_t split = 1; split < logs.size(); ++split)
	{
		const std::vector<LogScore> first(logs.begin(), logs.begin() + static_cast<std::ptrdiff_t>(split));
		const std::vector<LogScore> second(logs.begin() + static_cast<std::ptrdiff_t>(split), logs.end());
		auto chosen = namesOf(first);
		const auto more = namesOf(second);
		chosen.insert(chosen.end(), more.begin(), more.end());
		EXPECT_THAT(all, testing::Each(testing::AnyOfArray(chosen)));
	}
}

TEST(WorstFrames, PicturesOfDifferentFramesHaveDifferentNames)
{
	EXPECT_NE(pictureName("a/b.rawlog", 3), pictureName("a_b.rawlog", 3));
	EXPECT_NE(pictureName("a/b.rawlog", 3), pictureName("a/b.rawlog", 4));
	EXPECT_EQ(pictureName("../a b.rawlog", 12).parent_path(), "");
	EXPECT_THAT(pictureName("a/b.rawlog", 12).string(), testing::EndsWith("-000012.jpg"));
}

TEST(Csv, QuotesWhatNeedsIt)
{
	EXPECT_EQ(CsvRow().text("a,b").text("say \"x\"\n").number(0.12344).number(std::nullopt).number(-1e-9).line(),
	          "\"a,b\",\"say \"\"x\"\" \",0.1234,,0\n");
	EXPECT_EQ(CsvRow().number(1.5e9).flag(true).flag(std::nullopt).count(7).blanks(2).line(), "1500000000,1,,7,,\n");
	EXPECT_EQ(CsvRow().blanks(2).line(), ",\n");
}

TEST(TextTable, ColumnsLineUp)
{
	TextTable table({"<name", "hits"});
	table.row({"ä", "7"});
	table.row({"longer", "12345"});
	EXPECT_EQ(table.text(), "  name     hits\n  ä           7\n  longer  12345\n");
}
