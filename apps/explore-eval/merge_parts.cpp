#include <explore-eval/merge_parts.h>
#include <explore/core/errors.h>

#include <algorithm>
#include <system_error>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;
using namespace evaluation;

/** A log with all that belongs to it. */
struct PartLog
{
	LogScore score;
	std::string frame_rows, door_rows;
	fs::path pictures;
};

std::vector<PartLog> logsOf(const fs::path& folder, Evaluation& part)
{
	const EvalPaths paths(folder);
	part = readEval(paths.eval);
	EvalRows rows = readRows(paths, part.logs);
	std::vector<PartLog> logs;
	for (std::size_t i = 0; i < part.logs.size(); ++i)
		logs.push_back({std::move(part.logs[i]), std::move(rows.frames[i]), std::move(rows.doors[i]), paths.pictures});
	return logs;
}

std::string differenceOf(const EvalSetup& a, const EvalSetup& b)
{
	if (a.version != b.version) return "version " + a.version + " and " + b.version;
	if (a.ini != b.ini) return "--ini " + a.ini + " and " + b.ini;
	if (a.robot != b.robot || a.set != b.set) return "options --robot, --set or --seed";
	return "the contents of the ini";
}
}  // namespace

MergedParts mergeParts(const std::vector<std::string>& parts)
{
	MergedParts merged;
	std::vector<PartLog> logs;
	for (const std::string& folder : parts)
	{
		Evaluation part;
		for (PartLog& log : logsOf(folder, part)) logs.push_back(std::move(log));
		if (&folder == &parts.front()) merged.evaluation.setup = part.setup;
		if (part.setup != merged.evaluation.setup)
			throw InputError(folder + ": was not made with the configuration of " + parts.front() +
			                 "; different: " + differenceOf(merged.evaluation.setup, part.setup));
	}
	std::ranges::stable_sort(logs, {}, [](const PartLog& log) -> const std::string& { return log.score.log; });
	for (PartLog& log : logs)
	{
		merged.evaluation.logs.push_back(std::move(log.score));
		merged.rows.frames.push_back(std::move(log.frame_rows));
		merged.rows.doors.push_back(std::move(log.door_rows));
		merged.pictures.push_back(std::move(log.pictures));
	}
	checkOrder(merged.evaluation.logs);
	return merged;
}

void copyPictures(const MergedParts& merged, const std::vector<Selected>& worst, const fs::path& folder)
{
	std::error_code error;
	if (!worst.empty()) fs::create_directories(folder, error);
	for (const Selected& selected : worst)
	{
		const auto name = pictureName(merged.evaluation.logs[selected.log].log, selected.frame.frame);
		const fs::path from = merged.pictures[selected.log] / name;
		if (!fs::exists(from, error)) throw InputError(from.string() + ": the picture of a worst frame is missing");
		fs::copy_file(from, folder / name, fs::copy_options::overwrite_existing, error);
		if (error) throw OutputError((folder / name).string() + ": cannot copy: " + error.message());
	}
}
}  // namespace explore::app
