#include "compare_with_pcl.h"

#include "frame_times.h"
#include "paper_with_pcl.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <string_view>

namespace explore::test
{
namespace
{
/** Milliseconds per stage and in total, over many frames; its `ended` goes into a pipeline. */
class StageTimes
{
public:
	template <class Work>
	void measure(const Work& work)
	{
		m_start_ms = m_last_ms = threadTime_ms();
		work([this](std::string_view stage) { add(stage, m_last_ms); });
		add("total", m_start_ms);
	}

	[[nodiscard]] double medianOf(const std::string& stage) const { return quantile(m_times_ms.at(stage), 0.5); }

	void print(const char* title) const
	{
		std::printf("%s, median processor ms:", title);
		for (const std::string& stage : m_order) std::printf("  %s %.2f", stage.c_str(), medianOf(stage));
		std::printf("\n");
	}

private:
	void add(std::string_view stage, double since_ms)
	{
		const double now_ms = threadTime_ms();
		const std::string name(stage);
		if (!m_times_ms.contains(name)) m_order.push_back(name);
		m_times_ms[name].push_back(now_ms - since_ms);
		m_last_ms = threadTime_ms();
	}

	double m_start_ms = 0, m_last_ms = 0;
	std::vector<std::string> m_order;
	std::map<std::string, std::vector<double>> m_times_ms;
};
}  // namespace

void compareWithPcl(const std::vector<DepthFrame>& frames, const ExplorerConfig& config)
{
	constexpr int kRounds = 9;
	StageTimes ours, peer;
	for (int round = 0; round < kRounds; ++round)
		for (const DepthFrame& frame : frames)
		{
			ours.measure(
			    [&](const StageEnded& ended)
			    {
				    ExplorerState state;
				    benchmark::DoNotOptimize(step(frame, state, config, ended));
			    });
			peer.measure([&](const StageEnded& ended)
			             { benchmark::DoNotOptimize(exploreWithPcl(frame, config, ended)); });
		}
	peer.print("PCL");
	ours.print("explore");
	std::printf("%zu frames, one core: PCL takes %.1f times as long\n", kRounds * frames.size(),
	            peer.medianOf("total") / ours.medianOf("total"));
}
}  // namespace explore::test
