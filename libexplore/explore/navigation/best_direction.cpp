#include <explore/navigation/best_direction.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace explore
{
namespace
{
constexpr double kSideTolerance = 0.05;
constexpr double kEqual = 1e-9;

struct Candidate
{
	Direction direction;
	int side = 0;  ///< of θ_d: −1 right, +1 left, 0 none
	double open_m = 0, score = 0;
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

/** The scored candidates of one elevation. */
void addCandidates(const OpenPath& open_path, const AvoiderInput& input, const Direction& desired, double cap_m,
                   double elevation_rad, const AvoiderConfig& config, std::vector<Candidate>& candidates)
{
	const std::vector<double> offsets = gridThrough(0.0, config.resolution_rad, config.sector_rad);
	const DirectionFan fan{input.desired_rad + offsets.front(), config.resolution_rad, offsets.size(), elevation_rad};
	const std::vector<double> open_m = open_path.along(fan);
	const double level = std::cos(elevation_rad) * std::cos(desired.elevation_rad);
	const double upright = std::sin(elevation_rad) * std::sin(desired.elevation_rad);
	const int middle = static_cast<int>(offsets.size() / 2);
	for (std::size_t k = 0; k < offsets.size(); ++k)
	{
		const int side = std::clamp(static_cast<int>(k) - middle, -1, 1);
		const double nearness = level * std::cos(offsets[k]) + upright;
		const double score = std::min(open_m[k], cap_m) * nearness;
		candidates.push_back({{wrapToPi(fan.at(k).azimuth_rad), elevation_rad}, side, open_m[k], score, nearness});
	}
}

/** The best candidate among those for which `allowed` holds; null when none has a free way. */
template <class Allowed>
const Candidate* best(const std::vector<Candidate>& candidates, const Allowed& allowed)
{
	const Candidate* found = nullptr;
	for (const Candidate& candidate : candidates)
	{
		if (!(candidate.score > 0.0) || !allowed(candidate)) continue;
		const double lead = found == nullptr ? 1.0 : candidate.score - found->score;
		const bool nearer = found == nullptr || candidate.nearness >= found->nearness - kEqual;
		if (lead > kEqual || (lead >= -kEqual && nearer)) found = &candidate;
	}
	return found;
}

double turnTo(const Candidate& candidate)
{
	return std::abs(candidate.direction.azimuth_rad);
}

const Candidate* choose(const std::vector<Candidate>& candidates)
{
	const Candidate* found = best(candidates, [](const Candidate&) { return true; });
	if (found == nullptr || found->side == 0) return found;
	const Candidate* other =
	    best(candidates, [&](const Candidate& candidate) { return candidate.side == -found->side; });
	const bool as_good = other != nullptr && other->score >= (1.0 - kSideTolerance) * found->score;
	const double less_turn = as_good ? turnTo(*found) - turnTo(*other) : 0.0;
	return less_turn > kEqual ? other : found;
}
}  // namespace

Avoidance bestDirection(const OpenPath& open_path, const AvoiderInput& input, const RobotConfig& robot,
                        const AvoiderConfig& config)
{
	const std::vector<double> heights = elevations(input, robot, config);
	const bool has_goal = input.goal_distance_m > 0.0;
	const double cap_m =
	    std::min(config.max_range_m, has_goal ? input.goal_distance_m + robot.radius_m : config.max_range_m);
	const double max_elevation = heights.size() > 1 ? config.max_elevation_rad : 0.0;
	const Direction desired{input.desired_rad, std::clamp(input.desired_elevation_rad, -max_elevation, max_elevation)};

	std::vector<Candidate> candidates;
	for (const double elevation : heights)
		addCandidates(open_path, input, desired, cap_m, elevation, config, candidates);
	const Candidate* chosen = choose(candidates);
	if (chosen == nullptr) return {.heading_rad = std::nullopt, .open_path_m = open_path.along(desired)};
	return {.heading_rad = chosen->direction.azimuth_rad,
	        .elevation_rad = chosen->direction.elevation_rad,
	        .open_path_m = chosen->open_m,
	        .deviates = chosen->nearness < 1.0 - kEqual};
}
}  // namespace explore
