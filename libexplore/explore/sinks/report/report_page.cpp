#include <explore/sinks/html_text.h>
#include <explore/sinks/report/page_parts.h>
#include <explore/sinks/report/report_page.h>
#include <explore/sinks/report/short_numbers.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace explore
{
namespace
{
/** Appends `"name": [lines]`, lines of JSON that stand in a script. */
void appendList(std::string& page, std::string_view name, const std::vector<std::string>& lines)
{
	page.append(",\n\"").append(name).append("\": [");
	const char* between = "\n";
	for (const std::string& line : lines)
	{
		page.append(between).append(jsonInScript(line));
		between = ",\n";
	}
	page += "]";
}

/** Every second one, and again, until there are few enough. */
void thin(std::vector<std::string>& lines, std::size_t most)
{
	while (lines.size() > std::max<std::size_t>(most, 1))
	{
		std::size_t kept = 0;
		for (std::size_t i = 0; i < lines.size(); i += 2) std::swap(lines[kept++], lines[i]);
		lines.resize(kept);
	}
}

/** The log's plans told again, only every so many frames; the last one always. */
class PlanLines
{
public:
	explicit PlanLines(std::size_t stride) : m_stride(stride) {}
	void add(const ReportEntry& entry)
	{
		m_last = applyPlanRecord(std::string(entry.text), m_now);
		if (entry.frame % m_stride == 0) tell(m_last);
	}
	/** `last` may be null: there is no map. */
	void end(const PlanSnapshot* last, const PlanTime& time)
	{
		if (last == nullptr) return;
		m_now = *last;
		tell(time);
	}
	[[nodiscard]] const std::vector<std::string>& lines() const { return m_lines; }

private:
	void tell(const PlanTime& time)
	{
		m_lines.push_back(planRecord(m_told, m_now, time));
		m_told = m_now;
	}
	std::size_t m_stride;
	PlanSnapshot m_now, m_told;
	PlanTime m_last;
	std::vector<std::string> m_lines;
};

/** The poses of all frames in memory would be many: the list is halved whenever it is twice as long as it may be. */
class PoseLines
{
public:
	explicit PoseLines(std::size_t most) : m_most(std::max<std::size_t>(most, 1)) {}
	void add(const ReportEntry& entry)
	{
		m_last = entry.text;
		if (m_count++ % m_stride != 0) return;
		m_lines.emplace_back(entry.text);
		if (m_lines.size() <= m_most) return;
		thin(m_lines, m_lines.size() - 1);
		m_stride *= 2;
	}
	/** And the last one. */
	[[nodiscard]] std::vector<std::string> lines() const
	{
		std::vector<std::string> all = m_lines;
		if (!m_last.empty() && all.back() != m_last) all.push_back(m_last);
		return all;
	}

private:
	std::size_t m_most, m_stride = 1, m_count = 0;
	std::vector<std::string> m_lines;
	std::string m_last;
};

/** Opens an element with data for the scripts. */
std::string dataElement(std::string_view id)
{
	return std::string(R"(<script type="application/json" id=")").append(id) + "\">";
}
constexpr std::string_view kEndOfData = "</script>\n";

/** Appends what of the log is shown. */
void appendRun(std::string& page, const ReportLog& log, const ReportSizes& sizes, const ReportEnd& end)
{
	std::string beginning = "null";
	std::vector<std::string> cameras;
	PoseLines poses(sizes.most_poses), goals(sizes.most_goals);
	PlanLines plans(sizes.plan_stride);
	log.read(
	    [&](const ReportEntry& entry)
	    {
		    if (entry.kind == ReportLine::beginning) beginning = entry.text;
		    if (entry.kind == ReportLine::pose) poses.add(entry);
		    if (entry.kind == ReportLine::goal) goals.add(entry);
		    if (entry.kind == ReportLine::plan) plans.add(entry);
		    if (entry.kind == ReportLine::camera && entry.frame % sizes.camera_stride == 0)
			    cameras.emplace_back(entry.text);
	    });
	plans.end(end.last_plan, end.last);
	const Json left = {{"every", sizes.camera_stride}, {"planEvery", sizes.plan_stride}};
	page += dataElement("run") + "{\"beginning\": " + jsonInScript(beginning) + ",\n\"sampling\": " + jsonText(left);
	appendList(page, "poses", poses.lines());
	appendList(page, "goals", goals.lines());
	appendList(page, "plans", plans.lines());
	appendList(page, "cameras", cameras);
	page.append("}").append(kEndOfData);
}

std::string pageText(const ReportLog& log, const ReportSizes& sizes, const ReportEnd& end)
{
	const std::string name = end.summary.input.path;
	std::string page =
	    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
	    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
	    "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
	    escapedHtml(name) + " – explore-mrpt</title>\n<style>\n";
	page.append(page_parts::kStyle).append("</style>\n</head>\n<body>\n");
	page += "<noscript><p>This page draws the run by script; without it, in words:</p>\n<pre>" +
	        escapedHtml(summaryText(end.summary)) + "</pre></noscript>\n";
	page.append(dataElement("summary")).append(jsonInScript(summaryJson(end.summary))).append(kEndOfData);
	page.append(dataElement("timing")).append(jsonText(timingCurve(end.timing))).append(kEndOfData);
	appendRun(page, log, sizes, end);
	page.append(page_parts::kBody).append("<script>\n'use strict';\n(() => {\n");
	for (const std::string_view part : page_parts::kScripts) page.append(part);
	return page + "})();\n</script>\n</body>\n</html>\n";
}
}  // namespace

std::string reportPage(const ReportLog& log, const ReportSizes& sizes, const ReportEnd& end)
{
	constexpr std::size_t kMostStride = std::size_t{1} << 40U;
	ReportSizes now = sizes;
	std::string page = pageText(log, now, end);
	for (bool cameras = true; page.size() > sizes.page_bytes && now.plan_stride < kMostStride; cameras = !cameras)
	{
		(cameras ? now.camera_stride : now.plan_stride) *= 2;
		page = pageText(log, now, end);
	}
	return page;
}

Json timingCurve(const TimingRecord& timing)
{
	constexpr std::size_t kMostStretches = 300;
	std::size_t frames = 0;
	for (const auto& [stage, times_ms] : timing.times()) frames = std::max(frames, times_ms.size());
	const std::size_t stretch = std::max<std::size_t>(1, (frames + kMostStretches - 1) / kMostStretches);
	Json stages = Json::object();
	for (const auto& [stage, times_ms] : timing.times())
	{
		Json median = Json::array(), largest = Json::array();
		for (std::size_t begin = 0; begin < times_ms.size(); begin += stretch)
		{
			const std::size_t end = std::min(begin + stretch, times_ms.size());
			std::vector<float> some(times_ms.begin() + static_cast<std::ptrdiff_t>(begin),
			                        times_ms.begin() + static_cast<std::ptrdiff_t>(end));
			std::ranges::sort(some);
			median.push_back(shortNumber(some[some.size() / 2], 2));
			largest.push_back(shortNumber(some.back(), 2));
		}
		stages[stage] = {{"median", median}, {"max", largest}};
	}
	return {{"frames", stretch}, {"stages", stages}};
}
}  // namespace explore
