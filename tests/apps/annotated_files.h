// Runs that write annotated.rawlog, and their logs read back by MRPT alone.
#pragma once

#include "apps/program.h"

#include <mrpt/obs/CObservation.h>

#include <memory>
#include <nlohmann/json.hpp>

namespace explore::test
{
using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

/** Of a plain or gzipped file. */
Objects objectsIn(const std::filesystem::path& file);
bool isAnnotation(const mrpt::obs::CObservation& observation);

/** A run of corridor.ini over a log, with `[output] annotated`. */
ProgramResult annotate(const std::filesystem::path& log, const std::filesystem::path& out,
                       const std::vector<std::string>& more = {}, const Program::Setup& setup = {});
/** The lines of frames.jsonl. */
std::vector<nlohmann::json> framesOf(const std::filesystem::path& out);

/** Beside odometry and depth a laser, an IMU, another depth camera, and a comment at its beginning. */
void writeManySensors(const std::filesystem::path& path, std::size_t frames);

/** The annotations in the order of the log, a list for each of its frames. */
template <class Observation>
std::vector<std::shared_ptr<Observation>> annotationsIn(const std::filesystem::path& out)
{
	std::vector<std::shared_ptr<Observation>> found;
	for (const auto& object : objectsIn(out / "annotated.rawlog"))
		if (const auto one = std::dynamic_pointer_cast<Observation>(object); one && isAnnotation(*one))
			found.push_back(one);
	return found;
}

/** All of the input is in the log, in its order and unchanged, and nothing else but annotations and a comment. */
void expectInputUnchanged(const std::filesystem::path& log, const std::filesystem::path& annotated);
}  // namespace explore::test
