// How long each stage of a frame takes, and the median and 99th percentile over a run.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace explore
{
/** Milliseconds by stage; `total` is a stage of its own and the sum of the others. */
using StageTimes = std::map<std::string, double, std::less<>>;

inline constexpr std::string_view kTotalStage = "total";

/** Splits the time of one frame into stages, one after the other. */
class StageClock
{
public:
	/** A frame begins now. */
	void start();
	/** The time since start(), or since the last stage ended, was spent in `stage`. */
	void ended(std::string_view stage);
	/** Everything since start(). */
	[[nodiscard]] const StageTimes& times() const { return m_times_ms; }

private:
	std::chrono::steady_clock::time_point m_mark;
	StageTimes m_times_ms;
};

struct StageStatistics
{
	double median_ms = 0, p99_ms = 0;
};

/** Keeps all times of a run (4 bytes a stage and frame). */
class TimingRecord
{
public:
	void add(const StageTimes& times_ms);
	/** Median (mean of the middle two) and 99th percentile (nearest rank) by stage. */
	[[nodiscard]] std::map<std::string, StageStatistics> statistics() const;
	/** By stage, frame after frame. */
	[[nodiscard]] const std::map<std::string, std::vector<float>, std::less<>>& times() const { return m_times_ms; }
	/** Writes or reads all of it. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_times_ms);
	}

private:
	std::map<std::string, std::vector<float>, std::less<>> m_times_ms;
};

/** The largest resident set of this process so far [MB = 10⁶ bytes]. */
double peakResidentMegabytes();

struct ProcessorUse
{
	double cpu_s = 0;   ///< of all threads of this process
	double wall_s = 0;  ///< since `since`
};
/** So far. */
ProcessorUse processorUse(std::chrono::steady_clock::time_point since);
}  // namespace explore
