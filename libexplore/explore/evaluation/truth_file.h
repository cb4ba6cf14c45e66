// LOG.truth.json: the truth beside a log.
#pragma once

#include <explore/core/truth.h>

#include <filesystem>
#include <string>

namespace explore::evaluation
{
/** "a/b.rawlog" → "a/b.truth.json". */
std::filesystem::path truthPathOf(const std::filesystem::path& log);

/** The file's text; the same truth gives the same bytes. */
std::string truthText(const TruthLog& truth);
/** Throws OutputError. */
void writeTruth(const std::filesystem::path& path, const TruthLog& truth);
/** Throws InputError that names the file, the place and what is wrong, for anything that is no complete truth. */
TruthLog readTruth(const std::filesystem::path& path);
}  // namespace explore::evaluation
