#include <explore/simulation/shapes.h>
#include <explore/simulation/world.h>
#include <gtest/gtest.h>

#include <numbers>

namespace explore::simulation
{
namespace
{
TEST(World, SurfacesAreRecognisedByName)
{
	EXPECT_EQ(surfaceOf("Office/WindowGlass"), Surface::glass);
	EXPECT_EQ(surfaceOf("MIRROR"), Surface::mirror);
	EXPECT_EQ(surfaceOf("mirror_of_glass"), Surface::mirror);
	EXPECT_EQ(surfaceOf("Office/black_felt"), Surface::black);
	EXPECT_EQ(surfaceOf("Gazebo/FlatBlack"), Surface::matte);
	EXPECT_EQ(surfaceOf("Gazebo/Grey"), Surface::matte);
	EXPECT_EQ(surfaceOf(""), Surface::matte);
}

TEST(World, AMaterialIsMadeOnce)
{
	World world;
	const std::size_t grey = world.materialNamed("grey", {0.5F, 0.5F, 0.5F});
	const std::size_t glass = world.materialNamed("glass");
	EXPECT_NE(grey, glass);
	EXPECT_EQ(world.materialNamed("grey", {1, 0, 0}), grey);
	ASSERT_EQ(world.materials.size(), 2U);
	EXPECT_EQ(world.materials[grey].color, Eigen::Vector3f(0.5F, 0.5F, 0.5F));
	EXPECT_EQ(world.materials[glass].surface, Surface::glass);
}

TEST(World, EachTriangleKnowsItsBody)
{
	World world;
	const std::size_t first = world.add("table", boxMesh({1, 1, 1}), world.materialNamed("wood"));
	const std::size_t empty = world.add("nothing", {}, world.materialNamed("wood"));
	const std::size_t last =
	    world.add("floor", planeMesh(Eigen::Vector3d::UnitZ(), {9, 9}), world.materialNamed("stone"));
	ASSERT_EQ(world.bodies.size(), 3U);
	EXPECT_EQ(world.bodies[last].name, "floor");
	EXPECT_EQ(world.materials[world.bodies[last].material].name, "stone");
	ASSERT_EQ(world.mesh.triangles.size(), 14U);
	ASSERT_EQ(world.body_of_triangle.size(), 14U);
	for (std::size_t i = 0; i < 14; ++i) EXPECT_EQ(world.body_of_triangle[i], i < 12 ? first : last);
	EXPECT_NE(empty, last);
	for (const std::uint32_t index : world.mesh.triangles.back()) EXPECT_LT(index, world.mesh.vertices.size());
	EXPECT_NEAR(world.mesh.vertices[world.mesh.triangles.back()[0]].head<2>().norm(), 4.5 * std::numbers::sqrt2, 1e-5);
}

TEST(World, AppendTurnsThenMoves)
{
	TriangleMesh piece;
	piece.vertices = {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}};
	piece.triangles = {{0, 1, 2}};
	Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
	place.translate(Eigen::Vector3d(10, 0, 1));
	place.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()));
	TriangleMesh mesh;
	append(mesh, piece, Eigen::Isometry3d::Identity());
	append(mesh, piece, place);
	ASSERT_EQ(mesh.triangles.size(), 2U);
	EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{3, 4, 5}));
	EXPECT_TRUE(mesh.vertices[4].isApprox(Eigen::Vector3f(10, 2, 1), 1e-6F));
	EXPECT_TRUE(mesh.vertices[5].isApprox(Eigen::Vector3f(9, 1, 1), 1e-6F));
}
}  // namespace
}  // namespace explore::simulation
