#include <explore-mrpt/run_outputs.h>
#include <explore/core/errors.h>
#include <explore/sinks/doors_geojson.h>
#include <explore/sinks/json_lines.h>
#include <explore/sinks/scene/run_scene.h>
#include <explore/sinks/trajectory.h>

namespace explore::app
{
namespace
{
std::optional<OutputPaths> makeFolder(const Options& options, const AnnotatedInput& input, bool continues)
{
	if (options.toStandardOutput()) return std::nullopt;
	std::error_code not_there;
	if (std::filesystem::equivalent(outputPaths(options.out).annotated, input.rawlog, not_there))
		throw ConfigError(input.rawlog.string() +
		                  ": is the recording to be read and would be replaced; name another folder with --out");
	return continues ? continueOutputFolder(options.out) : prepareOutputFolder(options.out);
}

/** A new file, or the one that is there. */
OutputFile open(const std::filesystem::path& path, const std::optional<OutputSizes>& continued,
                std::uint64_t OutputSizes::*bytes)
{
	return continued ? OutputFile::continued(path, (*continued).*bytes) : OutputFile(path);
}

TimingCsv openTiming(const std::filesystem::path& path, const std::optional<OutputSizes>& continued)
{
	const std::vector<std::string> stages{"read", "perceive", "remember", "choose", "avoid", "heading", "write"};
	return continued ? TimingCsv(path, stages, continued->timing) : TimingCsv(path, stages);
}

AnnotatedLog openAnnotated(const OutputPaths& paths, const AnnotatedInput& input, const RobotConfig& robot,
                           const std::optional<OutputSizes>& continued)
{
	const AnnotatedLog::Files files{paths.annotated, paths.annotated_images};
	if (!continued) return {files, input, robot};
	return {files, input, robot, {continued->annotated, continued->annotated_inputs}};
}

ReportRecorder openReport(const std::filesystem::path& log, const ExplorerConfig& config,
                          const std::optional<OutputSizes>& continued)
{
	ReportConfig report;
	report.camera.max_range_m = config.perception.range_filter.max_range_m;
	report.robot_radius_m = config.robot.radius_m;
	return continued ? ReportRecorder(log, report, continued->report) : ReportRecorder(log, report);
}
}  // namespace

RunOutputs::RunOutputs(const Options& options, const AppConfig& config, const AnnotatedInput& input,
                       const std::optional<OutputSizes>& continued)
    : m_config(config.explorer),
      m_paths(makeFolder(options, input, continued.has_value())),
      m_frames(m_paths ? open(m_paths->frames, continued, &OutputSizes::frames) : OutputFile::standardOutput())
{
	if (!m_paths) return;
	const OutputConfig& output = config.output;
	m_scene = output.scene;
	if (output.annotated) m_annotated.emplace(openAnnotated(*m_paths, input, config.explorer.robot, continued));
	if (output.timing) m_timing.emplace(openTiming(m_paths->timing, continued));
	if (output.trajectory) m_trajectory.emplace(open(m_paths->trajectory, continued, &OutputSizes::trajectory));
	if (output.trajectory && config.source.kind == SourceKind::simulator)
		m_truth.emplace(open(m_paths->truth, continued, &OutputSizes::truth));
	if (output.report) m_report.emplace(openReport(m_paths->report_log, config.explorer, continued));
	if (output.pictures_every > 0)
		m_pictures.emplace(m_paths->pictures, output.pictures_every,
		                   PictureConfig{config.explorer.perception.range_filter.max_range_m, config.explorer.robot});
}

OutputSizes RunOutputs::sizes() const
{
	OutputSizes sizes;
	sizes.frames = m_frames.bytes();
	if (m_timing) sizes.timing = m_timing->bytes();
	if (m_trajectory) sizes.trajectory = m_trajectory->bytes();
	if (m_truth) sizes.truth = m_truth->bytes();
	if (m_report) sizes.report = m_report->bytes();
	if (m_annotated)
	{
		sizes.annotated = m_annotated->place().bytes;
		sizes.annotated_inputs = m_annotated->place().inputs;
	}
	return sizes;
}

void RunOutputs::write(const DepthFrame& frame, const StepResult& result)
{
	m_frames.write(frameLine(frame, result));
	if (m_trajectory) m_trajectory->write(trajectoryLine(frame));
	if (m_pictures) m_pictures->write(frame, result);
	if (m_scene || m_annotated) m_last = sketchOf(frame, result, m_config.perception.range_filter.max_range_m);
	if (m_annotated) m_annotated->add(frame, *m_last);
}

void RunOutputs::writeRestOfInput()
{
	if (m_annotated) m_annotated->addRest();
}

void RunOutputs::writeReport(const DepthFrame& frame, const StepResult& result, const ExplorerState& state,
                             const std::optional<double>& coverage)
{
	if (m_report) m_report->add(frame, result, state, coverage);
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

void RunOutputs::writeScene(const ExplorerState& state)
{
	if (!m_scene || !m_last) return;
	RunSceneParts parts;
	parts.last = &*m_last;
	if (state.memory)
	{
		parts.map = &state.memory->map.tree();
		parts.memory = state.memory.get();
		parts.mission = &state.mission;
		if (m_trajectory) parts.path_in_map = placesOfTrajectory(m_paths->trajectory);
	}
	RunSceneConfig config;
	config.robot = m_config.robot;
	config.floor_z_m = m_config.memory.layers.floor_z_m;
	explore::writeScene(runScene(parts, config), m_paths->scene);
}

void RunOutputs::finish(const RunSummary& summary, const TimingRecord& timing, const ExplorerState& state)
{
	m_frames.close();
	if (m_timing) m_timing->close();
	if (m_trajectory) m_trajectory->close();
	if (m_truth) m_truth->close();
	if (m_annotated) m_annotated->close();
	if (m_paths) writeFileAtomically(m_paths->summary, summaryJson(summary));
	if (m_paths && state.memory) writeFileAtomically(m_paths->doors, doorsGeoJson(*state.memory));
	if (m_report) writeFileAtomically(m_paths->report, m_report->page(summary, timing, state));
}

void RunOutputs::forgetReportLog()
{
	if (!m_report) return;
	removeOldFiles(m_paths->report_log.parent_path(),
	               [this](const std::filesystem::path& path) { return path == m_paths->report_log; });
}
}  // namespace explore::app
