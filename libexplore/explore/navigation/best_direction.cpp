#include <explore/navigation/best_direction.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace explore
{
namespace
{
constexpr double kAsGood = 0.03;  // what a steadier direction may cost
constexpr double kEqual = 1e-9;

struct Candidate
{
	Direction direction;
	int side = 0;  ///< of θ_d: −1 right, +1 left, 0 none
	double open_m = 0, score = 0;
	double steady = 0;    ///< the least score of the candidate and its neighbours
	double nearness = 0;  ///< cosine of the angle to the desired direction
};

/** base + k · step for all whole k that keep it within ± limit, ascending. */
std::vector<double> gridThrough(double base, double step, double limit)
{
	constexpr double kRounding = 1e-9;
	const double last = std::floor((limit - base) / step + kRounding);
	std::vector<double> values;
	for (double k = std::ceil((-limit - base) / step - kRounding); k <= last; k += 1.0)
		values.push_back(base + k * step);
	return values;
}

std::vector<double> elevations(const AvoiderInput& input, const RobotConfig& robot, const AvoiderConfig& config)
{
	if (robot.kind != RobotKind::mav || !input.ground) return {0.0};
	const double base = std::clamp(input.desired_elevation_rad, -config.max_elevation_rad, config.max_elevation_rad);
	return gridThrough(base, config.elevation_step_rad, config.max_elevation_rad);
}

double leastAround(const std::vector<double>& scores, std::size_t k)
{
	return std::min({scores[k > 0 ? k - 1 : k], scores[k], scores[k + 1 < scores.size() ? k + 1 : k]});
}

/** The scored candidates of one elevation. */
void addCandidates(const Ways& ways, const AvoiderInput& input, const Direction& desired, double cap_m,
                   double elevation_rad, const AvoiderConfig& config, std::vector<Candidate>& candidates)
{
	const double limit_rad = ways.watchesUnseen() ? 0.5 * std::numbers::pi : config.sector_rad;
	const std::vector<double> offsets = gridThrough(0.0, config.resolution_rad, limit_rad);
	const DirectionFan fan{input.desired_rad + offsets.front(), config.resolution_rad, offsets.size(), elevation_rad};
	const WayFan found = ways.along(fan);
	const double level = std::cos(elevation_rad) * std::cos(desired.elevation_rad);
	const double upright = std::sin(elevation_rad) * std::sin(desired.elevation_rad);
	const int middle = static_cast<int>(offsets.size() / 2);
	const bool steady = config.method != AvoiderMethod::paper;
	std::vector<double> scores(fan.count);
	for (std::size_t k = 0; k < fan.count; ++k)
		scores[k] = std::min(found.worth_m[k], cap_m) * (level * std::cos(offsets[k]) + upright);
	for (std::size_t k = 0; k < fan.count; ++k)
		candidates.push_back({.direction = {wrapToPi(fan.at(k).azimuth_rad), elevation_rad},
		                      .side = std::clamp(static_cast<int>(k) - middle, -1, 1),
		                      .open_m = found.open_m[k],
		                      .score = scores[k],
		                      .steady = steady ? leastAround(scores, k) : scores[k],
		                      .nearness = level * std::cos(offsets[k]) + upright});
}

/** The steadiest candidate among those for which `allowed` holds; null when none has a free way. */
template <class Allowed>
const Candidate* steadiest(const std::vector<Candidate>& candidates, const Allowed& allowed)
{
	const Candidate* found = nullptr;
	for (const Candidate& candidate : candidates)
	{
		if (!(candidate.score > 0.0) || !allowed(candidate)) continue;
		const double lead = found == nullptr ? 1.0 : candidate.steady - found->steady;
		const bool nearer = found == nullptr || candidate.nearness >= found->nearness - kEqual;
		if (lead > kEqual || (lead >= -kEqual && nearer)) found = &candidate;
	}
	return found;
}

double turnTo(const Candidate& candidate)
{
	return std::abs(candidate.direction.azimuth_rad);
}

const Candidate* choose(const std::vector<Candidate>& candidates, double tolerance)
{
	double most = 0.0;
	for (const Candidate& candidate : candidates) most = std::max(most, candidate.score);
	const auto as_good = [&](const Candidate& candidate) { return candidate.score >= (1.0 - tolerance) * most; };
	const Candidate* found = steadiest(candidates, as_good);
	if (found == nullptr || found->side == 0) return found;
	const Candidate* other = steadiest(
	    candidates, [&](const Candidate& candidate) { return as_good(candidate) && candidate.side == -found->side; });
	return other != nullptr && turnTo(*found) - turnTo(*other) > kEqual ? other : found;
}
}  // namespace

Avoidance bestDirection(const Ways& ways, const AvoiderInput& input, const RobotConfig& robot,
                        const AvoiderConfig& config)
{
	const std::vector<double> heights = elevations(input, robot, config);
	const bool has_goal = input.goal_distance_m > 0.0;
	const double cap_m =
	    std::min(config.max_range_m, has_goal ? input.goal_distance_m + robot.radius_m : config.max_range_m);
	const double max_elevation = heights.size() > 1 ? config.max_elevation_rad : 0.0;
	const Direction desired{input.desired_rad, std::clamp(input.desired_elevation_rad, -max_elevation, max_elevation)};

	std::vector<Candidate> candidates;
	for (const double elevation : heights) addCandidates(ways, input, desired, cap_m, elevation, config, candidates);
	const Candidate* chosen = choose(candidates, config.method == AvoiderMethod::paper ? 0.0 : kAsGood);
	if (chosen == nullptr) return {.heading_rad = std::nullopt, .open_path_m = ways.along(desired).open_m.front()};
	return {.heading_rad = chosen->direction.azimuth_rad,
	        .elevation_rad = chosen->direction.elevation_rad,
	        .open_path_m = chosen->open_m,
	        .deviates = chosen->nearness < 1.0 - kEqual};
}
}  // namespace explore
