// Writes a made-up building as a Gazebo world with door labels: building.sdf and building.doors.json.
#include "support/building.h"

#include <cstdlib>
#include <iostream>
#include <map>

namespace
{
constexpr const char* kUsage = "usage: make_building --seed S --kind house|office|school|warehouse|hotel --out DIR\n";

int run(const std::map<std::string, std::string>& options)
{
	const explore::test::Building building =
	    explore::test::makeBuilding(options.at("--kind"), std::stoull(options.at("--seed")));
	const std::filesystem::path folder = options.at("--out");
	std::filesystem::create_directories(folder);
	building.sketch.write(folder);
	std::cout << folder.string() << ": " << building.plan.rooms.size() << " rooms, " << building.sketch.doors.size()
	          << " doors, " << building.sketch.shapes() << " shapes\n";
	return EXIT_SUCCESS;
}
}  // namespace

int main(int argc, char** argv)
try
{
	std::map<std::string, std::string> options;
	for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
	if (argc != 7 || options.size() != 3 || !options.contains("--seed") || !options.contains("--kind") ||
	    !options.contains("--out"))
	{
		std::cerr << kUsage;
		return EXIT_FAILURE;
	}
	return run(options);
}
catch (const std::exception& error)
{
	std::cerr << "make_building: " << error.what() << '\n';
	return EXIT_FAILURE;
}
