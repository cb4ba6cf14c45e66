#include <common/mounted_source.h>
#include <explore-eval/log_input.h>
#include <explore/core/errors.h>
#include <explore/evaluation/truth_file.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace explore::app
{
namespace
{
std::optional<TruthLog> truthBeside(const std::string& log)
{
	const auto path = evaluation::truthPathOf(log);
	std::error_code error;
	if (!std::filesystem::exists(path, error)) return std::nullopt;
	return evaluation::readTruth(path);
}

AppConfig configFor(const std::string& log, const std::optional<TruthLog>& truth, const LoadedConfig& loaded,
                    const EvalOptions& options)
{
	AppConfig config = loaded.config;
	config.source.kind = SourceKind::rawlog;
	config.source.rawlog = log;
	if (!truth || options.robot) return config;
	config.explorer.robot = truth->robot;
	applyOverrides(config, options.overrides());
	return config;
}
}  // namespace

LoadedConfig loadScoredConfig(const EvalOptions& options)
{
	EvalOptions framewise = options;
	framewise.set.insert(framewise.set.begin(), "memory.enabled=false");
	return loadConfig(framewise);
}

MessageList::MessageList() : COutputLogger("explore-eval")
{
	logging_enable_console_output = false;
	setMinLoggingLevel(mrpt::system::LVL_WARN);
	logRegisterCallback(
	    [this](std::string_view message, mrpt::system::VerbosityLevel /*level*/, std::string_view /*logger*/,
	           mrpt::Clock::time_point /*time*/)
	    {
		    std::string text(message.substr(0, message.find_last_not_of("\r\n") + 1));
		    if (std::ranges::find(m_messages, text) == m_messages.end()) m_messages.push_back(std::move(text));
	    });
}

LogInput::LogInput(std::string log, const LoadedConfig& loaded, const EvalOptions& options)
    : m_log(std::move(log)), m_truth(truthBeside(m_log)), m_config(configFor(m_log, m_truth, loaded, options))
{
	m_source = makeSource(m_config.source, m_messages);
	// The mount of a simulated camera is what the log says, and may differ from scene to scene.
	if (m_truth && m_config.source.camera.mount == MountPolicy::log) return;
	m_source = std::make_unique<MountedSource>(std::move(m_source), m_config.source.camera.mount,
	                                           m_config.explorer.perception, m_messages);
}

const TruthFrame* LogInput::truthOf(const DepthFrame& frame) const
{
	constexpr double kSameTime_s = 0.5e-3;
	if (!m_truth) return nullptr;
	const double t = mrpt::Clock::toDouble(frame.timestamp);
	const auto found = std::ranges::lower_bound(m_truth->frames, t - kSameTime_s, {}, &TruthFrame::t);
	const bool same = found != m_truth->frames.end() && found->t <= t + kSameTime_s;
	return same ? &*found : nullptr;
}

void LogInput::replay(const std::function<bool(int scene)>& wanted,
                      const std::function<bool(const ReplayedFrame&)>& visit)
{
	ExplorerState state;
	std::optional<int> scene;
	while (const auto frame = m_source->next())
	{
		const TruthFrame* truth = truthOf(*frame);
		// A frame that the truth does not know belongs to the scene it comes in.
		const int next = truth != nullptr ? truth->scene : scene.value_or(-1);
		if (scene != next) state = {};
		scene = next;
		if (wanted(next) && !visit({*frame, truth, step(*frame, state, m_config.explorer)})) return;
	}
}
}  // namespace explore::app
