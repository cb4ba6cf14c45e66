// report.html as a browser shows it: no script fails, the slider moves, what is counted is what summary.json counts.
#include "apps/headless_browser.h"
#include "apps/program.h"
#include "apps/rawlog_maker.h"

#include <gmock/gmock.h>

#include <memory>

using namespace explore::test;
using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
namespace fs = std::filesystem;

namespace
{
constexpr int kEnd = 35, kHome = 36, kLeft = 37, kRight = 39, kSpace = 32;

class ReportInBrowser : public testing::Test
{
protected:
	void SetUp() override
	{
		const auto program = HeadlessBrowser::find();
		if (!program) GTEST_SKIP() << "chromium is not installed (package chromium): the page cannot be tried";
		m_folder = freshFolder();
		m_browser = std::make_unique<HeadlessBrowser>(*program, processFolder() / "browser");
	}

	/** A short exploration, or what else `arguments` say. */
	fs::path explored(const std::vector<std::string>& arguments)
	{
		const fs::path out = m_folder / "o";
		std::vector<std::string> all{"--quiet", "--out", out.string()};
		all.insert(all.end(), arguments.begin(), arguments.end());
		const auto result = exploreMrpt(all);
		EXPECT_EQ(result.exit_code, 0) << result.err;
		return out;
	}
	void open(const fs::path& out) { m_browser->open(out / "report.html"); }
	json js(const std::string& expression) { return m_browser->evaluate(expression); }
	std::string text(const std::string& id) { return js("document.getElementById('" + id + "').textContent"); }
	/** What is drawn, when it is. */
	std::string picture(const std::string& id)
	{
		return js("new Promise(done => setTimeout(() => done(document.getElementById('" + id +
		          "').toDataURL()), 300))");
	}
	json rows(const std::string& table) { return js("document.querySelectorAll('#" + table + " tbody tr').length"); }

	fs::path m_folder;
	std::unique_ptr<HeadlessBrowser> m_browser;
};
}  // namespace

TEST_F(ReportInBrowser, CountsWhatTheSummaryCounts)
{
	const fs::path out = explored({"--ini", "office.ini", "--set", "source.rawlog=office.rawlog"});
	const json summary = json::parse(readFile(out / "summary.json"));
	open(out);
	EXPECT_EQ(text("fact-frames"), std::to_string(summary["source"]["frames"].get<int>()));
	EXPECT_EQ(text("fact-doors"), std::to_string(summary["doors"].size()));
	EXPECT_EQ(text("fact-corridors"), std::to_string(summary["corridors"].size()));
	EXPECT_EQ(text("fact-left"), std::to_string(summary["exploration"]["left_over"].size()));
	EXPECT_EQ(rows("doors-table"), summary["doors"].size());
	EXPECT_EQ(rows("left-table"), summary["exploration"]["left_over"].size());
	EXPECT_EQ(rows("timing-table"), summary["timing_ms"].size());
	EXPECT_EQ(js("+document.getElementById('slider').max + 1"), summary["source"]["frames"]);
	for (std::size_t i = 0; i < summary["doors"].size(); ++i)
	{
		const std::string row = "document.querySelectorAll('#doors-table tbody tr')[" + std::to_string(i) + "]";
		const json& door = summary["doors"][i];
		EXPECT_EQ(js(row + ".cells[0].textContent"), "Door " + std::to_string(door["track"].get<int>()));
		EXPECT_EQ(js(row + ".cells[1].textContent.trim()"), door["verdict"]);
		EXPECT_NEAR(js("parseFloat(" + row + ".cells[2].textContent)").get<double>(), door["width"], 0.0051);
	}
	EXPECT_THAT(m_browser->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, SliderAndKeysMoveThroughTheRun)
{
	open(explored({"--ini", "corridor.ini", "--max-frames", "40"}));
	EXPECT_THAT(text("now"), StartsWith("Frame 0,"));
	const std::string first_image = picture("camera"), first_plan = picture("plan");
	js("{ const s = document.getElementById('slider'); s.value = 30; s.dispatchEvent(new Event('input')); }");
	EXPECT_THAT(text("now"), StartsWith("Frame 30,"));
	EXPECT_NE(picture("camera"), first_image);
	EXPECT_NE(picture("plan"), first_plan);
	m_browser->press("Home", kHome);
	EXPECT_THAT(text("now"), StartsWith("Frame 0,"));
	EXPECT_EQ(picture("camera"), first_image);
	EXPECT_EQ(picture("plan"), first_plan) << "the way back shows the map as it was";
	m_browser->press("ArrowRight", kRight);
	EXPECT_THAT(text("now"), StartsWith("Frame 1,"));
	m_browser->press("End", kEnd);
	EXPECT_THAT(text("now"), StartsWith("Frame 39,"));
	m_browser->press("ArrowLeft", kLeft);
	EXPECT_THAT(text("now"), StartsWith("Frame 38,"));
	EXPECT_THAT(js("document.getElementById('slider').getAttribute('aria-valuetext')"), StartsWith("Frame 38,"));
	m_browser->press("Home", kHome);
	m_browser->press(" ", kSpace);
	js("new Promise(done => setTimeout(done, 1500))");
	m_browser->press(" ", kSpace);
	EXPECT_GT(js("+document.getElementById('slider').value"), 2) << "it played";
	EXPECT_THAT(m_browser->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, ADoorIsShownInItsBestFrame)
{
	const fs::path out = explored({"--ini", "office.ini", "--set", "source.rawlog=office.rawlog"});
	ASSERT_FALSE(json::parse(readFile(out / "summary.json"))["doors"].empty());
	open(out);
	const std::string before = picture("plan");
	js("document.querySelector('#doors-table button').click()");
	EXPECT_EQ(js("document.querySelectorAll('#doors-table tr.chosen').length"), 1);
	EXPECT_GT(js("+document.getElementById('slider').value"), 0);
	EXPECT_NE(picture("plan"), before);
	EXPECT_THAT(m_browser->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, FitsAPhone)
{
	const fs::path out = explored({"--ini", "office.ini", "--set", "source.rawlog=office.rawlog"});
	for (const int width_px : {360, 320, 1280})
	{
		m_browser->resize(width_px, 740);
		open(out);
		EXPECT_LE(js("document.documentElement.scrollWidth").get<int>(), width_px) << "nothing to scroll sideways";
		EXPECT_GE(js("document.getElementById('slider').getBoundingClientRect().width").get<double>(), 100);
	}
	EXPECT_THAT(m_browser->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, WithoutPosesItSaysThatThereIsNoMap)
{
	writeCorridorRawlog(m_folder / "log.rawlog", {4});
	open(explored({"--rawlog", (m_folder / "log.rawlog").string(), "--set", "source.pose=none"}));
	EXPECT_THAT(text("plan-none"), HasSubstr("without poses"));
	EXPECT_EQ(js("document.getElementById('plan-none').hidden"), false);
	EXPECT_EQ(js("document.getElementById('plan-stage').offsetHeight"), 0);
	EXPECT_EQ(js("document.getElementById('camera-stage').offsetHeight > 100"), true);
	m_browser->press("End", kEnd);
	EXPECT_THAT(text("now"), StartsWith("Frame 3,"));
	EXPECT_THAT(m_browser->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, NamesOfFilesAreTextsAndNothingElse)
{
	const fs::path log = m_folder / "a <img src=x onerror=document.title='bad'> &amp; .rawlog";
	writeCorridorRawlog(log, {2});
	open(explored({"--rawlog", log.string()}));
	EXPECT_EQ(js("document.getElementById('title').textContent"), log.filename().string());
	EXPECT_EQ(js("document.images.length"), 0);
	EXPECT_THAT(js("document.title"), HasSubstr("<img src=x"));
	EXPECT_THAT(m_browser->complaints(), IsEmpty());
}

TEST_F(ReportInBrowser, ABrokenPageIsNoticed)
{
	writeFile(m_folder / "report.html", "<script>nothing.there();</script><img src=\"http://localhost:9/x\">");
	open(m_folder);
	EXPECT_GE(m_browser->complaints().size(), 2U) << "else the tests here could not fail";
}
