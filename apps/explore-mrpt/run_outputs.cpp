#include <explore-mrpt/run_outputs.h>
#include <explore/sinks/json_lines.h>
#include <explore/sinks/trajectory.h>

namespace explore::app
{
namespace
{
std::optional<OutputPaths> makeFolder(const Options& options)
{
	if (options.toStandardOutput()) return std::nullopt;
	return prepareOutputFolder(options.out);
}
}  // namespace

RunOutputs::RunOutputs(const Options& options, const AppConfig& config)
    : m_paths(makeFolder(options)), m_frames(m_paths ? OutputFile(m_paths->frames) : OutputFile::standardOutput())
{
	if (!m_paths) return;
	const OutputConfig& output = config.output;
	if (output.timing)
		m_timing.emplace(m_paths->timing, std::vector<std::string>{"read", "perceive", "remember", "choose", "avoid",
		                                                           "heading", "write"});
	if (output.trajectory) m_trajectory.emplace(m_paths->trajectory);
	if (output.trajectory && config.source.kind == SourceKind::simulator) m_truth.emplace(m_paths->truth);
	if (output.pictures_every > 0)
		m_pictures.emplace(m_paths->pictures, output.pictures_every,
		                   PictureConfig{config.explorer.perception.range_filter.max_range_m, config.explorer.robot});
}

void RunOutputs::write(const DepthFrame& frame, const StepResult& result)
{
	m_frames.write(frameLine(frame, result));
	if (m_trajectory) m_trajectory->write(trajectoryLine(frame));
	if (m_pictures) m_pictures->write(frame, result);
}

void RunOutputs::writeTimes(std::size_t frame, const StageTimes& times_ms)
{
	if (m_timing) m_timing->write(frame, times_ms);
}

void RunOutputs::writeTruth(mrpt::Clock::time_point time, const mrpt::poses::CPose3D& true_map_from_robot)
{
	if (m_truth) m_truth->write(trajectoryLine(time, true_map_from_robot));
}

void RunOutputs::writeMap(const octomap::OcTree& map, const FloorBand& band)
{
	if (!m_paths) return;
	writeOctrees(map, m_paths->folder);
	writeFloorMap(floorMap(map, band), m_paths->folder);
}

void RunOutputs::finish(const RunSummary& summary)
{
	m_frames.close();
	if (m_timing) m_timing->close();
	if (m_trajectory) m_trajectory->close();
	if (m_truth) m_truth->close();
	if (m_paths) writeFileAtomically(m_paths->summary, summaryJson(summary));
}
}  // namespace explore::app
