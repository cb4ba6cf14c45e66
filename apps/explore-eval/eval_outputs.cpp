#include <explore-eval/eval_outputs.h>
#include <explore/core/errors.h>
#include <explore/evaluation/page.h>
#include <explore/sinks/output_file.h>
#include <explore/sinks/output_folder.h>

#include <cerrno>
#include <fstream>
#include <regex>
#include <sstream>
#include <system_error>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;
using namespace evaluation;

bool isPictureOfOurs(const fs::path& path)
{
	static const std::regex kName(R"(.*-[0-9a-f]{8}-[0-9]{6,}\.jpg)");
	return std::regex_match(path.filename().string(), kName);
}

std::string readAll(const fs::path& path)
{
	std::ifstream file(path, std::ios::binary);
	if (!file) throw InputError(path.string() + ": cannot open: " + std::generic_category().message(errno));
	std::ostringstream text;
	text << file.rdbuf();
	return text.str();
}

/** `counts[i]` lines for each i, after the header. */
std::vector<std::string> slices(const fs::path& path, const std::string& header, const std::vector<Count>& counts)
{
	const std::string text = readAll(path);
	if (!text.starts_with(header)) throw InputError(path.string() + ": its first line is not that of this version");
	std::vector<std::string> result;
	std::size_t at = header.size();
	for (const Count count : counts)
	{
		const std::size_t start = at;
		for (Count i = 0; i < count; ++i)
		{
			const std::size_t end = text.find('\n', at);
			if (end == std::string::npos) throw InputError(path.string() + ": has fewer lines than eval.json says");
			at = end + 1;
		}
		result.push_back(text.substr(start, at - start));
	}
	if (at != text.size()) throw InputError(path.string() + ": has more lines than eval.json says");
	return result;
}

std::string joined(const std::string& header, const std::vector<std::string>& rows)
{
	std::string text = header;
	for (const std::string& row : rows) text += row;
	return text;
}

/** An encoder that runs out of disk may not say so; a whole JPEG ends in its EOI marker. */
std::string wholePicture(const fs::path& path)
{
	std::string bytes = readAll(path);
	if (!bytes.ends_with("\xFF\xD9")) throw OutputError(path.string() + ": is not whole (disk full?)");
	return bytes;
}
}  // namespace

EvalPaths::EvalPaths(const fs::path& folder)
    : eval(folder / "eval.json"),
      frames(folder / "frames.csv"),
      doors(folder / "doors.csv"),
      table(folder / "table.txt"),
      page(folder / "index.html"),
      pictures(folder / "pictures")
{
}

EvalPaths prepareEvalFolder(const fs::path& folder)
{
	makeFolder(folder);
	EvalPaths paths(folder);
	for (const fs::path* file : {&paths.eval, &paths.frames, &paths.doors, &paths.table, &paths.page})
		removeOldFile(*file);
	removeOldFiles(paths.pictures, isPictureOfOurs);
	return paths;
}

EvalRows readRows(const EvalPaths& part, const std::vector<LogScore>& logs)
{
	std::vector<Count> frames, doors;
	for (const LogScore& log : logs)
	{
		frames.push_back(log.frame_rows);
		doors.push_back(log.door_rows);
	}
	return {slices(part.frames, frameHeader(), frames), slices(part.doors, doorHeader(), doors)};
}

void writeEvaluated(const EvalPaths& paths, const Evaluated& evaluated, const std::vector<Selected>& worst)
{
	std::vector<PagePicture> pictures;
	for (const Selected& selected : worst)
	{
		const auto name = pictureName(evaluated.evaluation.logs[selected.log].log, selected.frame.frame);
		pictures.push_back({selected, wholePicture(paths.pictures / name)});
	}
	writeFileAtomically(paths.frames, joined(frameHeader(), evaluated.rows.frames));
	writeFileAtomically(paths.doors, joined(doorHeader(), evaluated.rows.doors));
	writeFileAtomically(paths.table, evaluated.tables);
	const auto& everything = evaluated.results.everything;
	const PageTables tables{evaluated.tables, everything ? everything->confidence.bins : std::vector<ReliabilityBin>()};
	writeFileAtomically(paths.page, pageText(evaluated.evaluation, tables, pictures));
	writeFileAtomically(paths.eval, evalText(evaluated.evaluation, evaluated.results));
}
}  // namespace explore::app
