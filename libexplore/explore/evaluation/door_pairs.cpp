#include <explore/core/geometry.h>
#include <explore/core/matching.h>
#include <explore/evaluation/door_pairs.h>
#include <explore/navigation/goal_choice.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace explore::evaluation
{
namespace
{
using Pairing = std::vector<std::optional<std::size_t>>;

/** The true door of each report, among those that `allowed(report, door)`. */
Pairing pairing(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                const std::function<bool(const Report&, const TruthDoor&)>& allowed)
{
	constexpr double kFarthest_m = 100.0;
	DistanceTable distances(reports.size(), truth.size());
	for (std::size_t i = 0; i < reports.size(); ++i)
		for (std::size_t j = 0; j < truth.size(); ++j)
			if (const double distance_m = centerDistance(reports[i], truth[j]);
			    distance_m < kFarthest_m && allowed(reports[i], truth[j]))
				distances.allow(i, j, distance_m);
	return bestMatching(distances);
}

bool mustBeFound(const TruthDoor& door)
{
	return isPositive(door) && door.visibility == Visibility::visible;
}

bool liesAtIgnored(const Report& report, const std::vector<TruthDoor>& truth, double tolerance_m,
                   const DoorRule& neither_way)
{
	return std::ranges::any_of(truth,
	                           [&](const TruthDoor& door)
	                           {
		                           const double reach_m = std::max(tolerance_m, 0.5 * door.width_m);
		                           return neither_way(door) && centerDistance(report, door) <= reach_m;
	                           });
}

/** The doors of `truth` that no pair holds yet. */
std::vector<bool> unpaired(const std::vector<TruthDoor>& truth, const std::vector<DoorPair>& pairs)
{
	std::vector<bool> free(truth.size(), true);
	for (const DoorPair& pair : pairs)
		if (pair.truth) free[*pair.truth] = false;
	return free;
}

bool isOpening(Verdict verdict)
{
	return verdict == Verdict::open || verdict == Verdict::passage;
}

bool sameVerdict(const TruthDoor& door, Verdict reported)
{
	if (door.verdict == reported) return true;
	if (!door.lintel_in_view && isOpening(door.verdict) && isOpening(reported)) return true;
	return door.verdict == Verdict::blocked && door.passable && isOpening(reported);
}
}  // namespace

std::vector<Report> reportsOf(const std::vector<Door>& doors, const mrpt::poses::CPose3D& map_from_robot,
                              const RobotConfig& robot)
{
	const Eigen::Isometry3d transform = isometryOf(map_from_robot);
	std::vector<Report> reports;
	for (const Door& door : doors)
	{
		const Eigen::Vector3d center = transform * door.center, normal = transform.linear() * door.normal;
		reports.push_back({door, center.head<2>(), normal.head<2>().normalized(), fitsThrough(door, robot)});
	}
	return reports;
}

bool isPositive(const TruthDoor& door)
{
	return door.passable && (isOpening(door.verdict) || door.verdict == Verdict::ajar);
}

bool countsNeitherWay(const TruthDoor& door)
{
	const bool flown_over = door.passable && door.verdict == Verdict::blocked;
	return flown_over ? door.visibility != Visibility::hidden
	                  : isPositive(door) && door.visibility == Visibility::ignored;
}

bool isFarDrop(const TruthDoor& door, const Eigen::Vector2d& camera_in_map)
{
	return door.verdict == Verdict::drop && (door.center_in_map.head<2>() - camera_in_map).norm() > kNearDoor_m;
}

CenterError centerError(const Report& report, const TruthDoor& door)
{
	const Eigen::Vector2d normal = door.normal_in_map.head<2>().normalized(), left(normal.y(), -normal.x());
	const Eigen::Vector2d error = report.center_in_map - door.center_in_map.head<2>();
	return {error.dot(left), error.dot(normal)};
}

double centerDistance(const Report& report, const TruthDoor& door)
{
	return (report.center_in_map - door.center_in_map.head<2>()).norm();
}

double widthError(const Report& report, const TruthDoor& door)
{
	return door.verdict == Verdict::ajar ? report.door.clear_width_m - door.clear_width_m
	                                     : report.door.width_m - door.width_m;
}

bool agrees(const Report& report, const TruthDoor& door, double tolerance_m)
{
	return centerDistance(report, door) <= tolerance_m && std::abs(widthError(report, door)) <= kWidthTolerance_m;
}

std::string_view nameOf(Outcome outcome)
{
	static constexpr std::array<std::string_view, 5> kNames{"hit", "miss", "false_alarm", "ignored", "other"};
	return kNames.at(static_cast<std::size_t>(outcome));
}

std::vector<DoorPair> pairDoors(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                                double tolerance_m, const DoorRule& neither_way)
{
	std::vector<DoorPair> pairs;
	const auto hits = pairing(reports, truth,
	                          [&](const Report& report, const TruthDoor& door)
	                          { return report.positive && mustBeFound(door) && agrees(report, door, tolerance_m); });
	for (std::size_t i = 0; i < reports.size(); ++i)
		if (hits[i]) pairs.push_back({Outcome::hit, i, hits[i]});
	const auto free = unpaired(truth, pairs);
	const auto others = pairing(reports, truth,
	                            [&](const Report& report, const TruthDoor& door)
	                            {
		                            return !report.positive && free[static_cast<std::size_t>(&door - truth.data())] &&
		                                   centerDistance(report, door) <= tolerance_m;
	                            });
	for (std::size_t i = 0; i < reports.size(); ++i)
	{
		if (hits[i]) continue;
		if (!reports[i].positive)
			pairs.push_back(
			    {others[i] && mustBeFound(truth[*others[i]]) ? Outcome::miss : Outcome::other, i, others[i]});
		else
			pairs.push_back(
			    {liesAtIgnored(reports[i], truth, tolerance_m, neither_way) ? Outcome::ignored : Outcome::false_alarm,
			     i, std::nullopt});
	}
	const auto left = unpaired(truth, pairs);
	for (std::size_t j = 0; j < truth.size(); ++j)
		if (left[j]) pairs.push_back({mustBeFound(truth[j]) ? Outcome::miss : Outcome::other, std::nullopt, j});
	return pairs;
}

std::size_t openWhereNothing(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                             const std::vector<DoorPair>& pairs, const DoorRule& neither_way)
{
	const auto counts = [&](const DoorPair& pair)
	{
		if (!pair.report || pair.outcome == Outcome::hit || pair.outcome == Outcome::ignored) return false;
		const Report& report = reports[*pair.report];
		if (report.door.verdict != Verdict::open) return false;
		if (pair.truth && isPositive(truth[*pair.truth])) return false;
		return !liesAtIgnored(report, truth, kCenterTolerances_m[kMainTolerance], neither_way);
	};
	return static_cast<std::size_t>(std::ranges::count_if(pairs, counts));
}

Confusion confusionOf(const std::vector<Report>& reports, const std::vector<TruthDoor>& truth,
                      const DoorRule& neither_way)
{
	const double tolerance_m = kCenterTolerances_m[kMainTolerance];
	const auto at =
	    pairing(reports, truth,
	            [&](const Report& report, const TruthDoor& door)
	            { return door.visibility != Visibility::hidden && centerDistance(report, door) <= tolerance_m; });
	Confusion confusion{};
	std::vector<bool> reported(truth.size(), false);
	const auto index = [](Verdict verdict) { return static_cast<std::size_t>(verdict); };
	for (std::size_t i = 0; i < reports.size(); ++i)
	{
		const Verdict verdict = reports[i].door.verdict;
		if (!at[i])
		{
			if (!liesAtIgnored(reports[i], truth, tolerance_m, neither_way)) ++confusion[kVerdicts][index(verdict)];
			continue;
		}
		const TruthDoor& door = truth[*at[i]];
		reported[*at[i]] = true;
		if (door.visibility == Visibility::visible)
			++confusion[index(door.verdict)][index(sameVerdict(door, verdict) ? door.verdict : verdict)];
	}
	for (std::size_t j = 0; j < truth.size(); ++j)
		if (truth[j].visibility == Visibility::visible && !reported[j]) ++confusion[index(truth[j].verdict)][kVerdicts];
	return confusion;
}
}  // namespace explore::evaluation
