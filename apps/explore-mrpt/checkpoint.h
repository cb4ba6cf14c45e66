// What --resume goes on from: the state of a run in one file, kept from time to time while it runs.
#pragma once

#include <common/app_config.h>
#include <explore-mrpt/options.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <string>

namespace explore::app
{
/** How a run was begun: what it is to be continued with. */
struct RunBeginning
{
	std::string ini, rawlog, oni, world;  ///< as given
	std::optional<std::uint64_t> max_frames;
	bool realtime = false;
	std::string working_folder;  ///< that relative names are below
	std::string loaded_ini;      ///< the file that was read
	std::string config;          ///< all values, as an ini
	SensorPoses sensor_poses;    ///< which no ini holds
};
RunBeginning beginningOf(const Options& options, const LoadedConfig& loaded);
/** Its configuration. Throws ConfigError where this program does not know a key. */
LoadedConfig loadedConfig(const RunBeginning& beginning);
/** `given` with --resume, and all else as the run was begun; --max-frames, where it is given, counts from the run's
 *  first frame. */
Options continuedOptions(const Options& given, const RunBeginning& beginning);

/** So many bytes of each file belong to the frames before the checkpoint. */
struct OutputSizes
{
	std::uint64_t frames = 0, timing = 0, trajectory = 0, truth = 0, report = 0, annotated = 0;
	std::uint64_t annotated_inputs = 0;  ///< objects of the input in annotated.rawlog
};

struct Checkpoint
{
	RunBeginning beginning;
	std::string end;  ///< why the run was over; empty = it can go on
	OutputSizes files;
	std::string state;  ///< of all that goes on from frame to frame
};

/** The checkpoint of the run in `folder`. Throws InputError where there is none, or another version's, or a damaged
 * one.
 */
Checkpoint readCheckpoint(const std::filesystem::path& folder);

/** Keeps checkpoints, one in place of the other; each is whole on disk before the one before it is gone. */
class CheckpointKeeper
{
public:
	/** No checkpoint is due without a file, or with a period of 0. */
	CheckpointKeeper(std::optional<std::filesystem::path> file, double period_s);

	/** Whether it is time for another one and the one before is on disk. */
	[[nodiscard]] bool due() const;
	[[nodiscard]] bool keeps() const { return m_file && m_period_s > 0.0; }
	/** Packs and writes it beside the run; the files that it counts bytes of come to the disk before it. Throws
	 *  OutputError for the one before. */
	void keep(Checkpoint checkpoint);
	/** Returns when all is on disk. Throws OutputError. */
	void finish();

private:
	std::optional<std::filesystem::path> m_file;
	double m_period_s;
	std::optional<std::chrono::steady_clock::time_point> m_kept_at;
	std::future<void> m_writing;
};
}  // namespace explore::app
