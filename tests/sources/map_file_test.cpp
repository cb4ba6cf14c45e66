#include <explore/core/errors.h>
#include <explore/sources/map_file.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "support/test_files.h"

namespace explore
{
namespace
{
octomap::OcTree randomMap()
{
	octomap::OcTree map(0.05);
	std::mt19937 random(3);
	const auto coordinate = [&] { return 0.05 * (static_cast<double>(random() % 40) - 20.0) + 0.025; };
	for (int i = 0; i < 2000; ++i)
	{
		const double x = coordinate(), y = coordinate(), z = coordinate();
		map.updateNode(octomap::point3d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)),
		               random() % 3 == 0);
	}
	map.prune();
	return map;
}

TEST(MapFile, ReadsWhatOctoMapWrites)
{
	octomap::OcTree map = randomMap();
	const auto folder = test::freshFolder();
	ASSERT_TRUE(map.write((folder / "a.ot").string()));
	ASSERT_TRUE(map.writeBinaryConst((folder / "a.bt").string()));
	EXPECT_TRUE(*readMapFile(folder / "a.ot") == map);
	const auto states = readMapFile(folder / "a.bt");
	EXPECT_EQ(states->size(), map.size());
	EXPECT_EQ(states->getResolution(), 0.05);
	for (auto leaf = map.begin_leafs(); leaf != map.end_leafs(); ++leaf)
		ASSERT_EQ(states->isNodeOccupied(states->search(leaf.getKey())), map.isNodeOccupied(*leaf));
	const octomap::OcTree empty(0.1);
	ASSERT_TRUE(empty.write((folder / "empty.ot").string()));
	EXPECT_EQ(readMapFile(folder / "empty.ot")->size(), 0U);
}

std::string complaintAbout(const std::filesystem::path& path, const std::string& bytes)
{
	test::writeFile(path, bytes);
	try
	{
		readMapFile(path);
	}
	catch (const InputError& error)
	{
		return error.what();
	}
	return "none";
}

TEST(MapFile, SaysWhatIsWrong)
{
	using testing::HasSubstr;
	const auto path = test::freshFolder() / "map.ot";
	EXPECT_THROW(readMapFile(path), InputError);
	EXPECT_THAT(complaintAbout(path, ""), HasSubstr("empty"));
	EXPECT_THAT(complaintAbout(path, "P5\n3 3\n255\n"), HasSubstr("byte 0: no OctoMap file"));
	EXPECT_THAT(complaintAbout(path, "# Octomap OcTree file\nid ColorOcTree\nsize 1\nres 0.1\ndata\n"),
	            HasSubstr("ColorOcTree"));
	EXPECT_THAT(complaintAbout(path, "# Octomap OcTree file\nid OcTree\nsize 1\nres -1\ndata\n"),
	            HasSubstr("resolution"));
	EXPECT_THAT(complaintAbout(path, "# Octomap OcTree file\nid OcTree\nsize 1\nres 0.1\n"), HasSubstr("no end"));
	EXPECT_THAT(
	    complaintAbout(path, "# Octomap OcTree file\nid OcTree\nsize 2\nres 0.1\ndata\n" + std::string(5, '\0')),
	    HasSubstr("1 nodes, but the header says 2"));
	const std::string deep(200'000, '\x01');  // each node has a child
	EXPECT_THAT(complaintAbout(path, "# Octomap OcTree file\nid OcTree\nsize 9\nres 0.1\ndata\n" + deep),
	            HasSubstr("lowest level"));
	const std::string deep_states(200'000, '\xff');
	EXPECT_THAT(complaintAbout(path, "# Octomap OcTree binary file\nid OcTree\nsize 9\nres 0.1\ndata\n" + deep_states),
	            HasSubstr("lowest level"));
}

TEST(MapFile, EveryCutFileIsRefusedAndNoFlippedBitDoesHarm)
{
	octomap::OcTree map = randomMap();
	const auto folder = test::freshFolder();
	std::mt19937 random(4);
	for (const std::string name : {"a.ot", "a.bt"})
	{
		name == "a.ot" ? map.write((folder / name).string()) : map.writeBinaryConst((folder / name).string());
		const std::string whole = test::readFile(folder / name);
		for (int i = 0; i < 100; ++i)
			EXPECT_NE(complaintAbout(folder / "cut", whole.substr(0, random() % whole.size())), "none");
		EXPECT_NE(complaintAbout(folder / "long", whole + "x"), "none");
		for (int i = 0; i < 300; ++i)
		{
			std::string flipped = whole;
			flipped[random() % flipped.size()] ^= static_cast<char>(1U << (random() % 8));
			complaintAbout(folder / "flipped", flipped);
		}
	}
}
}  // namespace
}  // namespace explore
