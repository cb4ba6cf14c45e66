#include <explore/perception/voxel_grid.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "support/random_points.h"

namespace explore
{
namespace
{
using Cell = std::array<long, 3>;

/** Double precision and an ordered map, with the order of first visit beside it. */
std::vector<Eigen::Vector3d> slowReference(const PointCloud& points, double size_m)
{
	std::map<Cell, std::size_t> place;
	std::vector<std::pair<Eigen::Vector3d, int>> sums;
	for (std::size_t i = 0; i < points.size(); ++i)
	{
		// The grid's cell borders lie where single precision puts them.
		const auto scale = 1.0F / static_cast<float>(size_m);
		const Cell cell{std::lround(std::floor(points.x[i] * scale)), std::lround(std::floor(points.y[i] * scale)),
		                std::lround(std::floor(points.z[i] * scale))};
		const auto [entry, added] = place.try_emplace(cell, sums.size());
		if (added) sums.emplace_back(Eigen::Vector3d::Zero(), 0);
		sums[entry->second].first += points[i].cast<double>();
		++sums[entry->second].second;
	}
	std::vector<Eigen::Vector3d> centroids;
	for (const auto& [sum, count] : sums) centroids.push_back(sum / count);
	return centroids;
}

/** Moves points off the voxels' borders, which the fast code rounds by up to 1/2000 of a voxel. */
void leaveBorders(PointCloud& points, double size_m)
{
	const auto margin = static_cast<float>(1e-3 * size_m);
	for (auto* axis : {&points.x, &points.y, &points.z})
		for (float& value : *axis)
			if (std::abs(std::remainder(value, static_cast<float>(size_m))) < margin) value += 2 * margin;
}

TEST(VoxelGrid, EqualsOrderedMapReference)
{
	std::mt19937 random(11);
	for (const double size_m : {0.02, 0.05, 0.3})
		for (const std::size_t count : {0U, 1U, 100U, 60000U})
		{
			PointCloud points;
			test::addUniform(points, count, 4.0, random);
			// Too wide for an array of cells.
			if (count == 100U) points.push_back({-900.0F, 700.0F, 80.0F});
			leaveBorders(points, size_m);
			const PointCloud fast = voxelGrid(points, {size_m});
			const auto slow = slowReference(points, size_m);
			ASSERT_EQ(fast.size(), slow.size());
			for (std::size_t i = 0; i < fast.size(); ++i)
				ASSERT_LT((fast[i].cast<double>() - slow[i]).norm(), 1e-4) << "voxel " << i;
		}
}

TEST(VoxelGrid, DensePatchKeepsOneCentroidPerVoxel)
{
	std::mt19937 random(3);
	PointCloud points;
	test::addPatch(points, {0.001, 0.001, 0.02}, {1.0 - 0.002, 0, 0}, {0, 1.0 - 0.002, 0}, 0.004, 0.0, random);
	const PointCloud voxels = voxelGrid(points, {0.05});
	EXPECT_EQ(voxels.size(), 400U);
	for (std::size_t i = 0; i < voxels.size(); ++i) EXPECT_NEAR(voxels.z[i], 0.02, 1e-5);
}

TEST(VoxelGrid, BorderAtZeroSeparatesBothSides)
{
	PointCloud points;
	points.push_back({0.01F, 0.0F, 0.0F});
	points.push_back({-0.01F, 0.0F, 0.0F});
	EXPECT_EQ(voxelGrid(points, {0.05}).size(), 2U);
}
}  // namespace
}  // namespace explore
