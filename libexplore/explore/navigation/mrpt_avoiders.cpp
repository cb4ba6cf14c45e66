#include <explore/core/geometry.h>
#include <explore/navigation/mrpt_avoiders.h>
#include <mrpt/nav/holonomic/CHolonomicFullEval.h>
#include <mrpt/nav/holonomic/CHolonomicND.h>
#include <mrpt/nav/registerAllClasses.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace explore
{
namespace
{
using mrpt::nav::CAbstractHolonomicReactiveMethod;

/** Below this a direction is closed [m]; MRPT's own default would be 0.15 of the range. */
constexpr double kTooClose_m = 0.05;

std::string classOf(AvoiderMethod method)
{
	switch (method)
	{
		case AvoiderMethod::holonomic_nd:
			return "CHolonomicND";
		case AvoiderMethod::holonomic_vff:
			return "CHolonomicVFF";
		case AvoiderMethod::holonomic_full_eval:
			return "CHolonomicFullEval";
		case AvoiderMethod::open_path:
		case AvoiderMethod::paper:
			break;
	}
	throw std::logic_error("mrptDirection: the method is not one of MRPT's");
}

/** A fresh object for each call: they remember their last direction, and equal frames must give equal headings. */
CAbstractHolonomicReactiveMethod::Ptr makeMethod(const AvoiderConfig& config)
{
	// The linker may have dropped what registers the classes at start-up.
	static const bool kRegistered = (mrpt::nav::registerAllClasses_mrpt_nav(), true);
	const std::string name = classOf(config.method);
	auto method = kRegistered ? CAbstractHolonomicReactiveMethod::Factory(name) : nullptr;
	if (!method) throw std::runtime_error("this MRPT has no " + name + "; [avoider] method accepts open_path");
	const double too_close = kTooClose_m / config.max_range_m;
	if (auto* nd = dynamic_cast<mrpt::nav::CHolonomicND*>(method.get())) nd->options.TOO_CLOSE_OBSTACLE = too_close;
	if (auto* full = dynamic_cast<mrpt::nav::CHolonomicFullEval*>(method.get()))
		full->options.TOO_CLOSE_OBSTACLE = too_close;
	return method;
}

/** A full turn around θ_d, MRPT's order: −π first. An odd count makes θ_d the middle direction. */
DirectionFan fullTurn(const AvoiderInput& input, const AvoiderConfig& config)
{
	// CHolonomicFullEval looks from every direction at every other.
	constexpr double kFinest_rad = 2.0 * kDegree_rad;
	const double pi = std::numbers::pi;
	const auto count = 2 * static_cast<std::size_t>(pi / std::max(config.resolution_rad, kFinest_rad)) + 1;
	const double step = 2.0 * pi / static_cast<double>(count);
	return {input.desired_rad - pi + 0.5 * step, step, count, 0.0};
}

Eigen::Vector2d endOf(const DirectionFan& fan, std::size_t k, double length)
{
	return length * Eigen::Rotation2Dd(fan.at(k).azimuth_rad).toRotationMatrix().col(0);
}

/** Per direction and distance, how far the robot's centre is from the nearest end of another open path, both in units
 * of the range; 0 beyond its own end. */
mrpt::nav::ClearanceDiagram clearanceOf(const DirectionFan& fan, const std::vector<double>& open)
{
	constexpr int kSteps = 4;
	std::vector<Eigen::Vector2d> ends;
	for (std::size_t k = 0; k < open.size(); ++k)
		if (open[k] < 1.0) ends.push_back(endOf(fan, k, open[k]));
	mrpt::nav::ClearanceDiagram diagram;
	diagram.resize(open.size(), open.size());
	for (std::size_t k = 0; k < open.size(); ++k)
		for (int step = 1; step <= kSteps; ++step)
		{
			const double travel = static_cast<double>(step) / kSteps;
			double clearance2 = travel <= open[k] ? 1.0 : 0.0;
			const Eigen::Vector2d here = endOf(fan, k, travel);
			if (clearance2 > 0.0)
				for (const Eigen::Vector2d& end : ends) clearance2 = std::min(clearance2, (end - here).squaredNorm());
			diagram.get_path_clearance_decimated(k)[travel] = std::sqrt(clearance2);
		}
	return diagram;
}

void closeOutside(const DirectionFan& fan, const AvoiderInput& input, double sector_rad, std::vector<double>& open)
{
	for (std::size_t k = 0; k < open.size(); ++k)
		if (std::abs(wrapToPi(fan.at(k).azimuth_rad - input.desired_rad)) > sector_rad + 0.5 * fan.step_rad)
			open[k] = 0.0;
}

/** The method's direction relative to θ_d; no value when it wants to stand still. */
std::optional<double> ask(const DirectionFan& fan, std::vector<double> open, const AvoiderInput& input,
                          const AvoiderConfig& config)
{
	const auto clearance =
	    config.method == AvoiderMethod::holonomic_full_eval ? clearanceOf(fan, open) : mrpt::nav::ClearanceDiagram();
	if (config.method != AvoiderMethod::holonomic_vff) closeOutside(fan, input, config.sector_rad, open);
	// CHolonomicFullEval fails an assertion when nothing is open.
	if (*std::max_element(open.begin(), open.end()) * config.max_range_m <= kTooClose_m) return std::nullopt;

	CAbstractHolonomicReactiveMethod::NavInput nav_input;
	nav_input.obstacles = std::move(open);
	const double goal = input.goal_distance_m / config.max_range_m;
	nav_input.targets.emplace_back(goal > 0.0 ? std::min(goal, 1.0) : 1.0, 0.0);
	nav_input.clearance = &clearance;
	CAbstractHolonomicReactiveMethod::NavOutput output;
	makeMethod(config)->navigate(nav_input, output);
	if (!(output.desiredSpeed > 0.0) || !std::isfinite(output.desiredDirection)) return std::nullopt;
	return wrapToPi(output.desiredDirection);
}
}  // namespace

Avoidance mrptDirection(const Ways& ways, const AvoiderInput& input, const AvoiderConfig& config)
{
	const DirectionFan fan = fullTurn(input, config);
	std::vector<double> open = ways.along(fan).worth_m;
	for (double& length : open) length /= config.max_range_m;

	const double desired_open_m = ways.along(Direction{input.desired_rad}).open_m.front();
	const std::optional<double> turn = ask(fan, std::move(open), input, config);
	if (!turn || std::abs(*turn) > config.sector_rad + 0.5 * fan.step_rad)
		return {.heading_rad = std::nullopt, .open_path_m = desired_open_m};
	const double heading = wrapToPi(input.desired_rad + *turn);
	const double open_m = ways.along(Direction{heading}).open_m.front();
	if (!(open_m > 0.0)) return {.heading_rad = std::nullopt, .open_path_m = desired_open_m};
	// Half a direction off is rounding, not avoiding.
	if (std::abs(*turn) <= 0.5 * fan.step_rad && desired_open_m >= open_m)
		return {.heading_rad = wrapToPi(input.desired_rad), .open_path_m = desired_open_m};
	return {.heading_rad = heading, .open_path_m = open_m, .deviates = true};
}
}  // namespace explore
