// One log with its truth, replayed through the explorer frame by frame.
#pragma once

#include <common/app_config.h>
#include <explore-eval/options.h>
#include <explore/core/truth.h>
#include <explore/pipeline/explorer.h>
#include <explore/sources/source.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace explore::app
{
/** Log messages of a replay, each once. */
class MessageList : public mrpt::system::COutputLogger
{
public:
	/** Warnings and worse. */
	MessageList();
	[[nodiscard]] const std::vector<std::string>& messages() const { return m_messages; }

private:
	std::vector<std::string> m_messages;
};

/** A frame of the replay. */
struct ReplayedFrame
{
	const DepthFrame& frame;
	const TruthFrame* truth;  ///< null where there is none
	const StepResult& result;
};

/** As loadConfig(), but frames are judged one by one: [memory] enabled is false whatever the ini says, unless --set
 * says otherwise. */
LoadedConfig loadScoredConfig(const EvalOptions& options);

class LogInput
{
public:
	/** Reads the truth, where there is one, and opens the log. The robot is that of the truth, changed by --set, unless
	 *  --robot was given. Throws InputError. */
	LogInput(std::string log, const LoadedConfig& loaded, const EvalOptions& options);

	[[nodiscard]] const std::optional<TruthLog>& truth() const { return m_truth; }
	[[nodiscard]] const ExplorerConfig& config() const { return m_config.explorer; }
	[[nodiscard]] SourceReport report() const { return m_source->report(); }
	[[nodiscard]] const std::vector<std::string>& messages() const { return m_messages.messages(); }

	/** Steps through the log and calls `visit` until it returns false; the explorer starts anew in each scene of the
	 *  truth. Scenes for which `wanted` is false are passed over; a log without truth is scene −1. */
	void replay(const std::function<bool(int scene)>& wanted, const std::function<bool(const ReplayedFrame&)>& visit);

private:
	[[nodiscard]] const TruthFrame* truthOf(const DepthFrame& frame) const;

	std::string m_log;
	MessageList m_messages;
	std::optional<TruthLog> m_truth;
	AppConfig m_config;
	std::unique_ptr<FrameSource> m_source;
};
}  // namespace explore::app
