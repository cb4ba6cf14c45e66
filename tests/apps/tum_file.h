// Where a run says that the robot was.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <sstream>
#include <vector>

#include "support/test_files.h"

namespace explore::test
{
/** The places on the floor plan of every line of a TUM file. */
inline std::vector<Eigen::Vector2d> placesIn(const std::filesystem::path& tum)
{
	std::vector<Eigen::Vector2d> places;
	for (const std::string& line : linesOf(readFile(tum)))
	{
		std::istringstream words(line);
		double t_s = 0;
		Eigen::Vector2d& place = places.emplace_back();
		words >> t_s >> place.x() >> place.y();
	}
	return places;
}
}  // namespace explore::test
