#include <explore/core/errors.h>
#include <explore/sinks/map_files.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "support/test_files.h"

namespace explore
{
namespace
{
/** A map with voxels of 5 cm: a floor, a wall of 0.4 m, a lamp above the robot, and a threshold below its wheels. */
octomap::OcTree smallMap()
{
	octomap::OcTree map(0.05);
	const auto put = [&](double x, double y, double z, float log_odds) { map.setNodeValue(x, y, z, log_odds); };
	for (int i = 0; i < 40; ++i)
		for (int j = 0; j < 20; ++j)
		{
			const double x = -0.475 + 0.05 * i, y = 1.025 + 0.05 * j;
			put(x, y, -0.025, 2.0F);
			for (int k = 0; k < 20; ++k) put(x, y, 0.025 + 0.05 * k, -2.0F);
		}
	for (int k = 0; k < 8; ++k) put(0.525, 1.525, 0.025 + 0.05 * k, 2.0F);
	put(1.025, 1.225, 0.975, 2.0F);
	put(0.025, 1.225, 0.025, 2.0F);
	return map;
}

TEST(MapFiles, OctreesReadBackAsTheyWere)
{
	const octomap::OcTree map = smallMap();
	const auto folder = test::freshFolder();
	writeOctrees(map, folder);
	const std::unique_ptr<octomap::AbstractOcTree> exact(octomap::AbstractOcTree::read((folder / "map.ot").string()));
	const auto* tree = dynamic_cast<octomap::OcTree*>(exact.get());
	ASSERT_NE(tree, nullptr);
	EXPECT_TRUE(*tree == map);
	octomap::OcTree states(0.05);
	ASSERT_TRUE(states.readBinary((folder / "map.bt").string()));
	EXPECT_EQ(states.size(), map.size());
	for (auto leaf = map.begin_leafs(); leaf != map.end_leafs(); ++leaf)
		EXPECT_EQ(states.isNodeOccupied(states.search(leaf.getKey())), map.isNodeOccupied(*leaf));
}

/** What map_server (ROS 1 and 2, mode trinary) makes of the two files. */
class ServedMap
{
public:
	explicit ServedMap(const std::filesystem::path& folder)
	{
		for (const std::string& line : test::linesOf(test::readFile(folder / "map.yaml")))
			m_yaml[line.substr(0, line.find(':'))] = line.substr(line.find(':') + 2);
		std::istringstream pgm(test::readFile(folder / m_yaml.at("image")));
		std::string magic;
		int white = 0;
		pgm >> magic >> m_width >> m_height >> white;
		EXPECT_EQ(magic, "P5");
		EXPECT_EQ(white, 255);
		EXPECT_TRUE(std::isspace(pgm.get()));
		m_pixels.assign(std::istreambuf_iterator<char>(pgm), {});
		EXPECT_EQ(m_pixels.size(), static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height));
		std::sscanf(m_yaml.at("origin").c_str(), "[%lf, %lf", &m_x, &m_y);
	}

	/** 100, 0 or −1, as nav_msgs/OccupancyGrid has it; the image's first row is the map's last. */
	[[nodiscard]] int at(double x, double y) const
	{
		const double cell_m = std::stod(m_yaml.at("resolution"));
		const int column = static_cast<int>(std::floor((x - m_x) / cell_m)),
		          row = static_cast<int>(std::floor((y - m_y) / cell_m));
		EXPECT_TRUE(column >= 0 && column < m_width && row >= 0 && row < m_height);
		const int grey = static_cast<unsigned char>(
		    m_pixels[static_cast<std::size_t>(m_height - 1 - row) * static_cast<std::size_t>(m_width) +
		             static_cast<std::size_t>(column)]);
		const double occupancy = m_yaml.at("negate") == "0" ? (255 - grey) / 255.0 : grey / 255.0;
		if (occupancy > std::stod(m_yaml.at("occupied_thresh"))) return 100;
		return occupancy < std::stod(m_yaml.at("free_thresh")) ? 0 : -1;
	}
	[[nodiscard]] int width() const { return m_width; }
	[[nodiscard]] int height() const { return m_height; }

private:
	std::map<std::string, std::string> m_yaml;
	int m_width = 0, m_height = 0;
	double m_x = 0, m_y = 0;
	std::string m_pixels;
};

TEST(MapFiles, MapServerSeesTheBandOfTheRobot)
{
	const auto folder = test::freshFolder();
	writeFloorMap(floorMap(smallMap(), {}), folder);
	const ServedMap map(folder);
	EXPECT_EQ(map.width(), 40);
	EXPECT_EQ(map.height(), 20);
	EXPECT_EQ(map.at(0.525, 1.525), 100);  // the wall
	EXPECT_EQ(map.at(0.475, 1.525), 0);    // beside it
	EXPECT_EQ(map.at(0.525, 1.575), 0);
	EXPECT_EQ(map.at(1.025, 1.225), 0);   // below the lamp
	EXPECT_EQ(map.at(0.025, 1.225), 0);   // over the threshold
	EXPECT_EQ(map.at(-0.475, 1.025), 0);  // the corners
	EXPECT_EQ(map.at(1.475, 1.975), 0);
}

TEST(MapFiles, WhatIsKnownOutsideOfTheBandOnlyIsUnknown)
{
	octomap::OcTree map = smallMap();
	map.setNodeValue(2.025, 1.025, 0.325, -2.0F);  // one free voxel farther to the right
	map.setNodeValue(1.825, 1.025, 0.025, 2.0F);   // low
	const auto folder = test::freshFolder();
	writeFloorMap(floorMap(map, {}), folder);
	const ServedMap served(folder);
	EXPECT_EQ(served.width(), 51);
	EXPECT_EQ(served.at(2.025, 1.025), 0);
	EXPECT_EQ(served.at(1.825, 1.025), -1);
}

TEST(MapFiles, TheBandIsMeasuredFromTheFloor)
{
	octomap::OcTree map(0.05);
	map.setNodeValue(0.025, 0.025, 3.125, 2.0F);
	map.setNodeValue(0.025, 0.075, 3.625, 2.0F);
	map.setNodeValue(0.025, 0.125, 3.075, 2.0F);
	map.setNodeValue(0.025, 0.175, 3.575, -2.0F);
	const FloorMap floor = floorMap(map, {.floor_z_m = 3.0, .lowest_m = 0.1, .highest_m = 0.6});
	ASSERT_EQ(floor.rows, 4);
	ASSERT_EQ(floor.columns, 1);
	const std::vector<VoxelState> expected{VoxelState::occupied, VoxelState::unknown, VoxelState::unknown,
	                                       VoxelState::free};
	EXPECT_EQ(floor.cells, expected);
}

TEST(MapFiles, LargeLeavesCoverAllOfTheirCells)
{
	octomap::OcTree map(0.05);
	for (int i = 0; i < 8; ++i)
		for (int j = 0; j < 8; ++j)
			for (int k = 0; k < 16; ++k) map.setNodeValue(0.025 + 0.05 * i, 0.025 + 0.05 * j, 0.025 + 0.05 * k, -2.0F);
	map.prune();
	ASSERT_LT(map.size(), 64U);
	const FloorMap floor = floorMap(map, {});
	EXPECT_EQ(floor.cells, std::vector<VoxelState>(64, VoxelState::free));
	EXPECT_EQ(floor.corner_in_map, Eigen::Vector2d(0, 0));
}

TEST(MapFiles, AnEmptyMapIsOneUnknownCell)
{
	const auto folder = test::freshFolder();
	octomap::OcTree map(0.05);
	writeFloorMap(floorMap(map, {}), folder);
	const ServedMap served(folder);
	EXPECT_EQ(served.width(), 1);
	EXPECT_EQ(served.at(0.01, 0.01), -1);
	writeOctrees(map, folder);
	EXPECT_THROW(writeOctrees(map, folder / "missing"), OutputError);
	EXPECT_THROW(writeFloorMap(floorMap(map, {}), folder / "missing"), OutputError);
}
}  // namespace
}  // namespace explore
