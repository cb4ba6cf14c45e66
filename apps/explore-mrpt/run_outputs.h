// All files of one run behind one face: a folder, or JSON lines on standard output alone.
#pragma once

#include <common/app_config.h>
#include <explore-mrpt/annotated_log.h>
#include <explore-mrpt/checkpoint.h>
#include <explore-mrpt/options.h>
#include <explore/sinks/frame_picture.h>
#include <explore/sinks/map_files.h>
#include <explore/sinks/output_file.h>
#include <explore/sinks/output_folder.h>
#include <explore/sinks/report/report_recorder.h>
#include <explore/sinks/scene/frame_sketch.h>
#include <explore/sinks/summary.h>
#include <explore/sinks/timing_csv.h>

namespace explore::app
{
/** Every method throws OutputError when something cannot be written. */
class RunOutputs
{
public:
	/** Makes the folder ready, so that an unwritable one is noticed before any work. With `continued`, goes on in the
	 *  files of the run that is there, after so many bytes of each; throws InputError where they are not there. Throws
	 *  ConfigError where the recording is itself one of the files that are replaced. */
	RunOutputs(const Options& options, const AppConfig& config, const AnnotatedInput& input,
	           const std::optional<OutputSizes>& continued = {});

	/** No value where there is no folder. */
	[[nodiscard]] const std::optional<OutputPaths>& paths() const { return m_paths; }
	[[nodiscard]] OutputSizes sizes() const;

	void write(const DepthFrame& frame, const StepResult& result);
	/** What the report shows of the frame; `state` is that after it, `coverage` that of its map where that is known. */
	void writeReport(const DepthFrame& frame, const StepResult& result, const ExplorerState& state,
	                 const std::optional<double>& coverage);
	/** What of the recording came after its last frame. */
	void writeRestOfInput();
	void writeTimes(std::size_t frame, const StageTimes& times_ms);
	/** A line of truth.tum. */
	void writeTruth(mrpt::Clock::time_point time, const mrpt::poses::CPose3D& true_map_from_robot);
	/** The map as it is in the end: map.ot, map.bt, and what of it is in `band` as map.pgm and map.yaml. */
	void writeMap(const octomap::OcTree& map, const FloorBand& band);
	/** scene.3Dscene, of what is known after the last frame. */
	void writeScene(const ExplorerState& state);
	/** Closes the files and writes the summary and the report, where there is a folder. */
	void finish(const RunSummary& summary, const TimingRecord& timing, const ExplorerState& state);
	/** What only a run that goes on needs is not needed any more. */
	void forgetReportLog();
	/** Writes or reads what goes on from frame to frame and is in none of the files. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_last);
	}

private:
	ExplorerConfig m_config;
	std::optional<OutputPaths> m_paths;
	OutputFile m_frames;
	std::optional<TimingCsv> m_timing;
	std::optional<OutputFile> m_trajectory, m_truth;
	std::optional<FramePictures> m_pictures;
	std::optional<ReportRecorder> m_report;
	std::optional<AnnotatedLog> m_annotated;
	bool m_scene = false;
	std::optional<FrameSketch> m_last;  ///< the last frame
};
}  // namespace explore::app
