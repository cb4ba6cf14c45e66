#include <explore/sinks/stage_clock.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
StageStatistics statisticsOf(std::vector<float> times_ms)
{
	std::sort(times_ms.begin(), times_ms.end());
	const std::size_t n = times_ms.size();
	const auto rank = static_cast<std::size_t>(std::ceil(0.99 * static_cast<double>(n)));
	return {0.5 * (times_ms[(n - 1) / 2] + times_ms[n / 2]), times_ms[rank - 1]};
}
}  // namespace

void StageClock::start()
{
	m_times_ms.clear();
	m_times_ms.emplace(kTotalStage, 0.0);
	m_mark = std::chrono::steady_clock::now();
}

void StageClock::ended(std::string_view stage)
{
	const auto now = std::chrono::steady_clock::now();
	const double spent_ms = std::chrono::duration<double, std::milli>(now - m_mark).count();
	m_times_ms[std::string(stage)] += spent_ms;
	m_times_ms[std::string(kTotalStage)] += spent_ms;
	m_mark = now;
}

void TimingRecord::add(const StageTimes& times_ms)
{
	for (const auto& [stage, time_ms] : times_ms) m_times_ms[stage].push_back(static_cast<float>(time_ms));
}

std::map<std::string, StageStatistics> TimingRecord::statistics() const
{
	std::map<std::string, StageStatistics> result;
	for (const auto& [stage, times_ms] : m_times_ms) result[stage] = statisticsOf(times_ms);
	return result;
}

double peakResidentMegabytes()
{
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	constexpr double kBytesPerKibibyte = 1024.0;
	return static_cast<double>(usage.ru_maxrss) * kBytesPerKibibyte * 1e-6;
}

ProcessorUse processorUse(std::chrono::steady_clock::time_point since)
{
	rusage usage{};
	getrusage(RUSAGE_SELF, &usage);
	const auto seconds = [](const timeval& time)
	{ return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
	const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - since;
	return {seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count()};
}
}  // namespace explore
