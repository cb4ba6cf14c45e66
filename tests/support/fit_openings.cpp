// Fits passTrees(): openings that the detector measures in logs, against the truth beside these logs.
//   fit_openings measure LOG... > openings.csv     what is known about each opening, and whether it can be passed
//   fit_openings fit openings.csv... > pass_trees.cpp
//   fit_openings check openings.csv...             fitted on four fifths of the logs, checked on the fifth: five times
#include "support/fit_trees.h"

#include <explore/evaluation/door_pairs.h>
#include <explore/evaluation/truth_file.h>
#include <explore/perception/full_view.h>
#include <explore/perception/openings.h>
#include <explore/sources/source.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

namespace explore::test
{
namespace
{
using namespace evaluation;
constexpr double kTolerance_m = 0.30;

/** No value: near a door that counts neither way, or one that is only just off. */
std::optional<bool> isPassable(const Opening& opening, const LevelPose& pose, const TruthFrame& truth,
                               const RobotConfig& robot)
{
	Door door = doorOf(opening, pose);
	door.verdict = Verdict::open;
	const Report report = reportsOf({door}, truth.map_from_robot, robot).front();
	bool near = false;
	for (const TruthDoor& true_door : truth.doors)
	{
		const bool must = isPositive(true_door) && true_door.visibility == Visibility::visible;
		if (must && agrees(report, true_door, kTolerance_m)) return true;
		near = near || (countsNeitherWay(true_door) &&
		                centerDistance(report, true_door) < std::max(kTolerance_m, 0.5 * true_door.width_m));
	}
	return near ? std::nullopt : std::optional(false);
}

void measure(const std::string& log, std::ostream& out)
{
	const TruthLog truth = readTruth(truthPathOf(log));
	std::map<std::size_t, const TruthFrame*> frames;
	for (const TruthFrame& frame : truth.frames) frames[frame.index] = &frame;
	SourceConfig source_config;
	source_config.rawlog = log;
	mrpt::system::COutputLogger logger;
	logger.setMinLoggingLevel(mrpt::system::LVL_ERROR);
	const auto source = makeSource(source_config, logger);
	const PerceptionConfig config;
	while (const auto frame = source->next())
	{
		const auto true_frame = frames.find(frame->index);
		if (true_frame == frames.end()) continue;
		const FullView view = fullView(*frame, config, truth.robot, {});
		for (const Opening& opening :
		     measuredOpenings(view.level, view.walls, truth.robot, config.openings, config.sensor_noise))
			if (const auto passable = isPassable(opening, view.level.pose, *true_frame->second, truth.robot))
			{
				out << log << ',' << *passable;
				for (const float value : openingFeatures(opening.frame, opening.measure, opening.context))
					out << ',' << value;
				out << '\n';
			}
	}
}

struct Sample
{
	std::string log;
	KnownOpening opening;
};

std::vector<Sample> readSamples(const std::vector<std::string>& files)
{
	std::vector<Sample> samples;
	for (const std::string& file : files)
	{
		std::ifstream in(file);
		for (std::string line; std::getline(in, line);)
		{
			std::istringstream fields(line);
			Sample sample;
			std::string field;
			std::getline(fields, sample.log, ',');
			std::getline(fields, field, ',');
			sample.opening.passable = field == "1";
			for (float& value : sample.opening.features)
			{
				if (!std::getline(fields, field, ',')) throw std::runtime_error(file + ": a row is too short");
				value = std::stof(field);
			}
			samples.push_back(std::move(sample));
		}
	}
	if (samples.empty()) throw std::runtime_error("no openings to fit");
	return samples;
}

std::vector<KnownOpening> openingsOf(const std::vector<Sample>& samples,
                                     const std::function<bool(const Sample&)>& takes)
{
	std::vector<KnownOpening> openings;
	openings.reserve(samples.size());
	for (const Sample& sample : samples)
		if (takes(sample)) openings.push_back(sample.opening);
	return openings;
}

void printTrees(const std::vector<PassTree>& trees, std::ostream& out)
{
	out << "// Made by fit_openings; see doc/method.md.\n#include <explore/perception/pass_probability.h>\n\n"
	    << "namespace explore\n{\nnamespace\n{\n// clang-format off\n"
	    << "constexpr std::array<PassTree, " << trees.size() << "> kTrees{{\n"
	    << std::fixed << std::setprecision(4);
	for (const PassTree& tree : trees)
	{
		out << "{{";
		for (const PassNode& node : tree)
			out << '{' << +node.feature << ',' << node.threshold << "F," << node.next << "},";
		out << "}},\n";
	}
	out << "}};\n// clang-format on\n}  // namespace\n\nstd::span<const PassTree> passTrees()\n{\n\treturn kTrees;\n}\n"
	    << "}  // namespace explore\n";
}

/** Logs with the same name up to their last dash are of the same building, and stay together. */
void check(const std::vector<Sample>& samples)
{
	constexpr std::size_t kFolds = 5;
	std::map<std::string, std::size_t> fold_of;
	for (const Sample& sample : samples)
		fold_of.emplace(sample.log.substr(0, sample.log.rfind('-')), fold_of.size() % kFolds);
	const auto fold = [&](const Sample& sample) { return fold_of.at(sample.log.substr(0, sample.log.rfind('-'))); };
	std::vector<double> probability(samples.size());
	for (std::size_t k = 0; k < kFolds; ++k)
	{
		const auto trees = fitTrees(openingsOf(samples, [&](const Sample& sample) { return fold(sample) != k; }), {});
		for (std::size_t i = 0; i < samples.size(); ++i)
			if (fold(samples[i]) == k) probability[i] = passProbability(samples[i].opening.features, trees);
	}
	for (const double threshold : {0.3, 0.5, 0.7})
	{
		int right = 0, claimed = 0, passable = 0;
		for (std::size_t i = 0; i < samples.size(); ++i)
		{
			const bool claims = probability[i] > threshold;
			claimed += static_cast<int>(claims);
			passable += static_cast<int>(samples[i].opening.passable);
			right += static_cast<int>(claims && samples[i].opening.passable);
		}
		std::cout << "p > " << threshold << ": precision " << static_cast<double>(right) / claimed << ", recall "
		          << static_cast<double>(right) / passable << '\n';
	}
}

int run(const std::vector<std::string>& arguments)
{
	if (arguments.size() < 2) throw std::runtime_error("usage: fit_openings measure|fit|check FILE...");
	const std::vector<std::string> files(arguments.begin() + 1, arguments.end());
	if (arguments.front() == "measure")
		for (const std::string& log : files) measure(log, std::cout);
	else if (arguments.front() == "fit")
		printTrees(fitTrees(openingsOf(readSamples(files), [](const Sample&) { return true; }), {}), std::cout);
	else if (arguments.front() == "check")
		check(readSamples(files));
	else
		throw std::runtime_error("no such command: " + arguments.front());
	return EXIT_SUCCESS;
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
{
	try
	{
		return explore::test::run({argv + 1, argv + argc});
	}
	catch (const std::exception& error)
	{
		std::cerr << "fit_openings: " << error.what() << '\n';
		return EXIT_FAILURE;
	}
}
