// The report's page from frames with known results: sizes, texts, counts, and going on.
#include "sinks/results_maker.h"
#include "support/analytic_scene.h"
#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/sinks/report/report_page.h>
#include <explore/sinks/report/report_recorder.h>
#include <gmock/gmock.h>
#include <malloc.h>

#include <chrono>

using namespace explore;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;
using mrpt::poses::CPose3D;

namespace
{
/** A drive along a corridor, with the explorer's own state and results. */
class Drive
{
public:
	explicit Drive(PoseOrigin origin = PoseOrigin::odometry) : m_origin(origin) {}

	void go(ReportRecorder& recorder, std::size_t frames)
	{
		for (std::size_t i = 0; i < frames; ++i, ++m_index)
		{
			const CPose3D map_from_robot(0.1 * static_cast<double>(m_index), 0, 0, 0, 0, 0);
			DepthFrame frame = test::renderFrame(m_scene, map_from_robot, CPose3D(0.1, 0, 0.5, 0, 0, 0),
			                                     test::xtionIntrinsics(160, 120), {.axial_scale = 1.0});
			frame.index = m_index;
			frame.timestamp += m_index * std::chrono::milliseconds(250);
			frame.pose_origin = m_origin;
			const StepResult result = step(frame, state, {});
			summary.tally.add(frame, result);
			recorder.add(frame, result, state, 0.01 * double(m_index));
		}
	}
	[[nodiscard]] std::string page(const ReportRecorder& recorder) { return recorder.page(summary, timing, state); }

	ExplorerState state;
	RunSummary summary;
	TimingRecord timing;

private:
	test::Scene m_scene = test::corridorScene(9.0, {3.0}, {});
	PoseOrigin m_origin;
	std::size_t m_index = 0;
};

Json dataOf(const std::string& page, const std::string& id)
{
	const std::string begin = "id=\"" + id + "\">";
	const auto from = page.find(begin);
	if (from == std::string::npos) throw std::runtime_error("no element " + id);
	return Json::parse(page.substr(from + begin.size(), page.find("</script>", from) - from - begin.size()));
}

std::size_t count(const std::string& text, const std::string& part)
{
	std::size_t found = 0;
	for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
	return found;
}
}  // namespace

TEST(Report, ShowsEveryFrameOfAShortRun)
{
	Drive drive;
	ReportRecorder recorder(test::freshFolder() / "state" / "report", {});
	drive.go(recorder, 22);
	const Json run = dataOf(drive.page(recorder), "run");
	ASSERT_EQ(run["cameras"].size(), 22U);
	ASSERT_EQ(run["poses"].size(), 22U);
	EXPECT_EQ(run["cameras"][21]["i"], 21);
	EXPECT_EQ(run["cameras"][4]["t"], 1.0);
	EXPECT_EQ(run["poses"][4], Json::parse("[4, 1.0, 0.4, 0.0, 0.0, 0]"));
	for (const Json& camera : run["cameras"]) EXPECT_GT(camera["img"].get<std::string>().size(), 500U);
	std::vector<std::size_t> plans;
	for (const Json& plan : run["plans"]) plans.push_back(plan["i"]);
	EXPECT_EQ(plans, (std::vector<std::size_t>{0, 4, 8, 12, 16, 20, 21})) << "every fourth, and the last";
	EXPECT_FALSE(run["goals"].empty());
}

TEST(Report, ThePlansTellTheMapAsItIsInTheEnd)
{
	Drive drive;
	ReportRecorder recorder(test::freshFolder() / "state" / "report", {});
	drive.go(recorder, 30);
	PlanSnapshot told;
	const Json run = dataOf(drive.page(recorder), "run");
	for (const Json& plan : run["plans"]) applyPlanRecord(plan.dump(), told);
	const PlanSnapshot now = planSnapshotOf(*drive.state.memory);
	EXPECT_EQ(told.grid, now.grid);
	EXPECT_EQ(told.doors, now.doors);
	EXPECT_EQ(told.corridors, now.corridors);
	EXPECT_NEAR(told.known_free_m2, now.known_free_m2, 0.006);
	EXPECT_GT(now.known_free_m2, 5.0);
	EXPECT_EQ(run["plans"][0]["cover"], 0.0);
	EXPECT_EQ(run["plans"][4]["cover"], 0.16);
	EXPECT_TRUE(run["plans"].back()["cover"].is_null()) << "the summary knows no truth";
}

TEST(Report, MarksLieWhereThePictureShowsThem)
{
	const auto scene = test::corridorScene(8.0, {2.0}, {});
	DepthFrame frame = test::renderFrame(scene, {}, CPose3D(0, 0, 0.5, 0, 0, 0), test::xtionIntrinsics(160, 120));
	const Json record = Json::parse(cameraRecord(frame, test::fullResult(), 0.0, {}));
	// xtionIntrinsics: fx = 0.919 · width, the middle at half the width; fullResult's door is 0.92 m wide and 2 m away,
	// in a wall 1 m to the left that the robot looks along.
	const Json& door = record["doors"].at(0);
	ASSERT_EQ(door["q"].size(), 4U);
	std::vector<long> columns;
	for (const Json& side : door["q"]) columns.push_back(side[0].get<long>());
	std::ranges::sort(columns);
	EXPECT_NEAR(static_cast<double>(columns.front()), 497 - 919 / 1.54, 4);
	EXPECT_NEAR(static_cast<double>(columns.back()), 497 - 919 / 2.46, 4);
	EXPECT_EQ(door["v"], "open");
	EXPECT_EQ(door["n"], 3);
	EXPECT_FALSE(record["walls"].empty());
	EXPECT_NEAR(record["vp"].at(0).at(0).get<double>(), 497, 4);
	for (const char* arrow : {"vp", "door", "avoid", "go"}) EXPECT_TRUE(record["arrows"].contains(arrow)) << arrow;
	EXPECT_LT(record["arrows"]["door"][2], record["arrows"]["vp"][2]) << "positive headings are to the left";
}

TEST(Report, StaysBelowItsSize)
{
	ReportConfig config;
	config.page_bytes = 250'000;
	config.cameras = {100'000, 40, 1};
	config.plans = {20'000, 10, 4};
	config.most_poses = 50;
	Drive drive;
	ReportRecorder recorder(test::freshFolder() / "state" / "report", config);
	drive.go(recorder, 120);
	const std::string page = drive.page(recorder);
	EXPECT_LE(page.size(), config.page_bytes);
	const Json run = dataOf(page, "run");
	const std::size_t every = run["sampling"]["every"];
	EXPECT_GE(every, 4U);
	EXPECT_EQ(run["cameras"].size(), (120 + every - 1) / every);
	for (std::size_t i = 0; i < run["cameras"].size(); ++i) EXPECT_EQ(run["cameras"][i]["i"], i * every);
	EXPECT_LE(run["poses"].size(), 51U);
	EXPECT_EQ(run["poses"].back()[0], 119) << "the last place is always there";
	EXPECT_LE(run["plans"].size(), 11U);
	EXPECT_EQ(run["plans"].back()["i"], 119);
}

TEST(Report, APageThatIsStillTooLargeShowsLess)
{
	ReportConfig config;
	config.page_bytes = 120'000;  // the scripts alone are 40'000
	Drive drive;
	ReportRecorder recorder(test::freshFolder() / "state" / "report", config);
	drive.go(recorder, 60);
	const std::string page = drive.page(recorder);
	EXPECT_LE(page.size(), config.page_bytes);
	EXPECT_GE(dataOf(page, "run")["cameras"].size(), 4U);
}

TEST(Report, DoesNotPileUpInMemory)
{
	ReportConfig config;
	config.cameras = {200'000, 100, 1};
	ReportRecorder recorder(test::freshFolder() / "state" / "report", config);
	DepthFrame frame = test::fullFrame();
	const StepResult result = test::fullResult();
	const ExplorerState state;
	const auto go = [&](std::size_t from, std::size_t to)
	{
		for (frame.index = from; frame.index < to; ++frame.index)
		{
			frame.timestamp += std::chrono::milliseconds(100);
			recorder.add(frame, result, state, {});
		}
	};
	go(0, 1000);
	const std::size_t before = mallinfo2().uordblks;
	go(1000, 60'000);
	EXPECT_LT(mallinfo2().uordblks, before + 50'000);
	EXPECT_LT(recorder.bytes(), 60'000U * 100U) << "a line a frame, and few more";
}

TEST(Report, TextsCannotBreakThePage)
{
	Drive drive;
	drive.summary.input.path = "</script><b onclick=\"x\">&'";
	drive.summary.warnings = {"<!--<script>"};
	ReportRecorder recorder(test::freshFolder() / "state" / "report", {});
	drive.go(recorder, 2);
	const std::string page = drive.page(recorder);
	EXPECT_EQ(count(page, "</script>"), 4U) << "summary, timing, run and the scripts";
	EXPECT_EQ(count(page, "<script"), 4U);
	EXPECT_THAT(page, Not(HasSubstr("<b onclick")));
	EXPECT_THAT(page, Not(HasSubstr("<!--")));
	EXPECT_EQ(dataOf(page, "summary")["source"]["path"], drive.summary.input.path);
	EXPECT_EQ(dataOf(page, "summary")["warnings"][0], "<!--<script>");
}

TEST(Report, NeedsNoOtherFile)
{
	Drive drive;
	ReportRecorder recorder(test::freshFolder() / "state" / "report", {});
	drive.go(recorder, 2);
	const std::string page = drive.page(recorder);
	for (const char* outside : {"<link", "src=\"", "@import", "url(", "fetch(", "import(", "https:"})
		EXPECT_THAT(page, Not(HasSubstr(outside)));
	EXPECT_EQ(count(page, "http:"), count(page, "http://www.w3.org/2000/svg")) << "a name, nothing to load";
}

TEST(Report, GoesOnFromItsLogAsIfItHadNeverStopped)
{
	const fs::path folder = test::freshFolder();
	ReportConfig config;
	config.cameras = {30'000, 15, 1};
	config.plans = {1'000'000, 6, 4};
	Drive whole;
	ReportRecorder one(folder / "whole", config);
	whole.go(one, 60);

	Drive parts;
	std::uintmax_t kept = 0;
	{
		ReportRecorder first(folder / "parts", config);
		parts.go(first, 33);
		kept = first.bytes();
		first.add(test::fullFrame(), test::fullResult(), {}, {});  // after the state was kept: comes again, otherwise
	}
	ReportRecorder second(folder / "parts", config, kept);
	parts.go(second, 27);
	EXPECT_TRUE(test::readFile(folder / "whole") == test::readFile(folder / "parts"));
	EXPECT_TRUE(whole.page(one) == parts.page(second));
}

TEST(Report, ALogThatIsNotTheRunsIsRefused)
{
	const fs::path log = test::freshFolder() / "report";
	EXPECT_THROW(ReportRecorder(log, {}, 10), InputError);
	test::writeFile(log, "m 0 {\"i\":0}\n");
	EXPECT_THROW(ReportRecorder(log, {}, 12), InputError);
	test::writeFile(log, "nonsense at all");
	EXPECT_THROW(ReportRecorder(log, {}, 15), InputError);
}

TEST(Report, ALogThatWasDamagedOnTheWayIsNoticed)
{
	const fs::path log = test::freshFolder() / "report";
	Drive drive;
	ReportRecorder recorder(log, {});
	drive.go(recorder, 3);
	std::string bytes = test::readFile(log);
	bytes.replace(bytes.find("\"cells\":\"") + 9, 1, "!");
	test::writeFile(log, bytes);
	EXPECT_THROW(static_cast<void>(drive.page(recorder)), OutputError);
}

TEST(Report, WithoutPosesOrFramesThereIsAPageToo)
{
	Drive blind(PoseOrigin::none), none;
	const fs::path folder = test::freshFolder();
	ReportRecorder recorder(folder / "blind", {}), empty(folder / "none", {});
	blind.go(recorder, 3);
	const Json run = dataOf(blind.page(recorder), "run");
	EXPECT_EQ(run["cameras"].size(), 3U);
	EXPECT_TRUE(run["plans"].empty());
	EXPECT_TRUE(run["poses"][1][2].is_null());
	EXPECT_TRUE(dataOf(none.page(empty), "run")["cameras"].empty());
	EXPECT_TRUE(dataOf(none.page(empty), "run")["beginning"].is_null());
}

TEST(TimingCurve, IsShortAndTellsTheLargest)
{
	TimingRecord timing;
	for (int i = 0; i < 1000; ++i) timing.add({{"total", i == 777 ? 90.0 : 10.0}});
	const Json curve = timingCurve(timing);
	EXPECT_EQ(curve["frames"], 4);
	ASSERT_EQ(curve["stages"]["total"]["max"].size(), 250U);
	EXPECT_EQ(curve["stages"]["total"]["max"][194], 90.0);
	EXPECT_EQ(curve["stages"]["total"]["median"][194], 10.0);
}
