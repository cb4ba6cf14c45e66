#include <explore/evaluation/reliability_diagram.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <cmath>

namespace explore::evaluation
{
namespace
{
constexpr double kSide_px = 360, kLeft_px = 50, kTop_px = 16;
constexpr double kLargest_px = 11, kSmallest_px = 3;

double across(double confidence)
{
	return kLeft_px + kSide_px * confidence;
}

double down(double share)
{
	return kTop_px + kSide_px * (1.0 - share);
}

std::string axes()
{
	std::string text = mrpt::format(
	    R"(<rect x="%.0f" y="%.0f" width="%.0f" height="%.0f" fill="none" stroke="currentColor" stroke-opacity="0.4"/>)"
	    "\n",
	    kLeft_px, kTop_px, kSide_px, kSide_px);
	for (int tick = 0; tick <= 5; ++tick)
	{
		const double value = tick / 5.0;
		text += mrpt::format(R"(<text x="%.0f" y="%.0f" text-anchor="middle">%.1f</text>)", across(value),
		                     kTop_px + kSide_px + 18, value);
		text += mrpt::format(R"(<text x="%.0f" y="%.0f" text-anchor="end">%.1f</text>)"
		                     "\n",
		                     kLeft_px - 6, down(value) + 4, value);
	}
	text += mrpt::format(R"(<line x1="%.0f" y1="%.0f" x2="%.0f" y2="%.0f" stroke="currentColor" )"
	                     R"(stroke-opacity="0.4" stroke-dasharray="4 4"/>)"
	                     "\n",
	                     across(0), down(0), across(1), down(1));
	text += mrpt::format(R"(<text x="%.0f" y="%.0f" text-anchor="middle">mean confidence</text>)"
	                     "\n",
	                     across(0.5), kTop_px + kSide_px + 40);
	return text + mrpt::format(R"svg(<text x="14" y="%.0f" text-anchor="middle" transform="rotate(-90 14 %.0f)">)svg"
	                           "share of right candidates</text>\n",
	                           down(0.5), down(0.5));
}

std::string disc(const ReliabilityBin& bin, double share_of_largest)
{
	const double radius_px = kSmallest_px + (kLargest_px - kSmallest_px) * std::sqrt(share_of_largest);
	return mrpt::format(
	    R"(<circle cx="%.1f" cy="%.1f" r="%.1f"><title>%.3f to %.3f: %.3f right of %zu</title></circle>)"
	    "\n",
	    across(bin.confidence), down(bin.right), radius_px, bin.lowest, bin.highest, bin.right,
	    static_cast<std::size_t>(bin.count));
}
}  // namespace

std::string reliabilitySvg(std::span<const ReliabilityBin> bins)
{
	if (bins.empty()) return "";
	const auto most = static_cast<double>(std::ranges::max_element(bins, {}, &ReliabilityBin::count)->count);
	std::string text =
	    R"(<svg role="img" aria-label="reliability diagram" width="420" height="460" viewBox="0 0 420 460" )"
	    R"(font-size="12" fill="currentColor">)"
	    "\n";
	text += axes() + R"(<polyline fill="none" stroke="#56beff" stroke-width="2" points=")";
	for (const ReliabilityBin& bin : bins) text += mrpt::format("%.1f,%.1f ", across(bin.confidence), down(bin.right));
	text += "\"/>\n<g fill=\"#56beff\">\n";
	for (const ReliabilityBin& bin : bins) text += disc(bin, static_cast<double>(bin.count) / most);
	return text + "</g>\n</svg>\n";
}
}  // namespace explore::evaluation
