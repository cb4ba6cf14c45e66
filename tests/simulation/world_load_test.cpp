// loadWorld: geometry, poses, states, and what is broken.
#include "simulation/world_fixture.h"

#include <explore/core/errors.h>
#include <gmock/gmock.h>

#include <numbers>

using namespace explore::simulation::test;
using explore::InputError;
using explore::simulation::loadWorld;
using explore::simulation::Surface;
using explore::simulation::World;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(LoadWorld, ShapesStandWhereTheirChainOfPosesPutsThem)
{
	// 1 m box: visual 1 m ahead of the link, link 2 m ahead of the model, model turned to the left.
	const World world = worldOf("<model name='m'><pose>10 0 0 0 0 1.5707963267948966</pose>" +
	                            link(visual(box("1 0.5 0.2"), "1 0 0.1 0 0 0"), "2 0 1 0 0 0") + "</model>");
	EXPECT_THAT(world.warnings, IsEmpty());
	EXPECT_EQ(world.name, "test");
	ASSERT_EQ(world.bodies.size(), 1U);
	EXPECT_EQ(world.bodies[0].name, "m::l::v");
	EXPECT_TRUE(spans(boundsOf(world, "m"), {9.75F, 2.5F, 1.0F}, {10.25F, 3.5F, 1.2F}));
}

TEST(LoadWorld, RollPitchYawTurnAboutFixedAxes)
{
	// A stick along x: pitch −90° raises it to z, a roll before that leaves it, a yaw after that too.
	const World world = worldOf(model("m", visual(box("2 0.2 0.1"), "0 0 0 1.5707963 -1.5707963 0.7")));
	const auto bounds = boundsOf(world, "m");
	EXPECT_NEAR(bounds.sizes().z(), 2, 1e-4);
	const float diagonal = 0.2F * std::cos(0.7F) + 0.1F * std::sin(0.7F);
	EXPECT_NEAR(std::max(bounds.sizes().x(), bounds.sizes().y()),
	            std::max(diagonal, 0.2F * std::sin(0.7F) + 0.1F * std::cos(0.7F)), 1e-4);
}

TEST(LoadWorld, PosesInDegreesAndQuaternions)
{
	const World world = worldOf(
	    "<model name='a'><pose degrees='true'>0 0 0 0 0 90</pose>" + link(visual(box("4 1 1"))) + "</model>" +
	        "<model name='b'><pose rotation_format='quat_xyzw'>5 0 0 0 0 0.7071067811865476 0.7071067811865476</pose>" +
	        link(visual(box("4 1 1"))) + "</model>",
	    "1.9");
	EXPECT_THAT(world.warnings, IsEmpty());
	EXPECT_TRUE(spans(boundsOf(world, "a"), {-0.5F, -2, -0.5F}, {0.5F, 2, 0.5F}));
	EXPECT_TRUE(spans(boundsOf(world, "b"), {4.5F, -2, -0.5F}, {5.5F, 2, 0.5F}));
}

TEST(LoadWorld, EveryShapeHasItsSize)
{
	const World world = worldOf(
	    model("cylinder", visual("<cylinder><radius>0.5</radius><length>2</length></cylinder>")) +
	    model("sphere", visual("<sphere><radius>0.4</radius></sphere>")) +
	    model("capsule", visual("<capsule><radius>0.2</radius><length>1</length></capsule>")) +
	    model("ellipsoid", visual("<ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid>")) +
	    model("plane", visual("<plane><normal>0 0 1</normal><size>6 8</size></plane>")) +
	    model("polyline", visual("<polyline><point>0 0</point><point>2 0</point><point>2 1</point><point>0 1</point>"
	                             "<height>3</height></polyline>")));
	EXPECT_THAT(world.warnings, IsEmpty());
	EXPECT_TRUE(spans(boundsOf(world, "cylinder"), {-0.5F, -0.5F, -1}, {0.5F, 0.5F, 1}));
	EXPECT_TRUE(spans(boundsOf(world, "sphere"), {-0.4F, -0.4F, -0.4F}, {0.4F, 0.4F, 0.4F}));
	EXPECT_TRUE(spans(boundsOf(world, "capsule"), {-0.2F, -0.2F, -0.7F}, {0.2F, 0.2F, 0.7F}));
	EXPECT_TRUE(spans(boundsOf(world, "ellipsoid"), {-0.1F, -0.2F, -0.3F}, {0.1F, 0.2F, 0.3F}));
	EXPECT_TRUE(spans(boundsOf(world, "plane"), {-3, -4, 0}, {3, 4, 0}));
	EXPECT_TRUE(spans(boundsOf(world, "polyline"), {0, 0, 0}, {2, 1, 3}));
}

TEST(LoadWorld, NestedModelsAddUp)
{
	const World world =
	    worldOf("<model name='outer'><pose>1 0 0 0 0 0</pose><model name='inner'><pose>0 2 0 0 0 0</pose>" +
	                link(visual(box("1 1 1")), "0 0 3 0 0 0") + "</model>" + link("", "", "own") + "</model>",
	            "1.8");
	EXPECT_EQ(world.bodies[0].name, "outer::inner::l::v");
	EXPECT_TRUE(spans(boundsOf(world, "outer"), {0.5F, 1.5F, 2.5F}, {1.5F, 2.5F, 3.5F}));
}

TEST(LoadWorld, FramesAndRelativePosesAreResolved)
{
	const World world = worldOf(
	    "<frame name='door'><pose>10 0 0 0 0 1.5707963267948966</pose></frame>"
	    "<model name='leaf'><pose relative_to='door'>1 0 0 0 0 0</pose>" +
	        link(visual(box("0.5 0.1 2"))) + "</model><model name='arm'><pose>0 5 0 0 0 0</pose>" +
	        link(visual(box("1 1 1")), "1 0 0 0 0 0", "base") +
	        "<link name='tip'><pose relative_to='base'>2 0 0 0 0 0</pose>" + visual(box("1 1 1")) +
	        "</link><frame name='grip' attached_to='tip'><pose>0 0 1 0 0 0</pose></frame>"
	        "<link name='hand'><pose relative_to='grip'/>" +
	        visual(box("1 1 1")) + "</link></model>",
	    "1.9");
	EXPECT_THAT(world.warnings, IsEmpty());
	EXPECT_TRUE(spans(boundsOf(world, "leaf"), {9.95F, 0.75F, -1}, {10.05F, 1.25F, 1}));
	EXPECT_TRUE(spans(boundsOf(world, "arm::base"), {0.5F, 4.5F, -0.5F}, {1.5F, 5.5F, 0.5F}));
	EXPECT_TRUE(spans(boundsOf(world, "arm::tip"), {2.5F, 4.5F, -0.5F}, {3.5F, 5.5F, 0.5F}));
	EXPECT_TRUE(spans(boundsOf(world, "arm::hand"), {2.5F, 4.5F, 0.5F}, {3.5F, 5.5F, 1.5F}));
}

TEST(LoadWorld, AFrameThatDoesNotExistIsNamed)
{
	const World world = worldOf(
	    "<model name='m'><pose relative_to='nowhere'>3 0 0 0 0 0</pose>" + link(visual(box("1 1 1"))) + "</model>",
	    "1.8");
	EXPECT_THAT(warningsOf(world), HasSubstr("nowhere"));
	EXPECT_TRUE(spans(boundsOf(world, "m"), {2.5F, -0.5F, -0.5F}, {3.5F, 0.5F, 0.5F}));
}

TEST(LoadWorld, StateMovesModelsAndLinks)
{
	const World world =
	    worldOf("<model name='a'><pose>9 9 9 0 0 0</pose>" + link(visual(box("1 1 1")), "0 0 1 0 0 0", "one") +
	            link(visual(box("1 1 1")), "0 0 2 0 0 0", "two") + "</model>" + model("gone", visual(box("1 1 1"))) +
	            "<state world_name='test'><model name='a'><pose>1 2 0 0 0 0</pose><scale>1 1 1</scale><link name='one'>"
	            "<pose>5 6 0 0 0 0</pose></link></model><deletions><name>gone</name></deletions><insertions>" +
	            model("new", visual(box("1 1 1")), "0 0 7 0 0 0") + "</insertions></state>");
	EXPECT_TRUE(spans(boundsOf(world, "a::one"), {4.5F, 5.5F, -0.5F}, {5.5F, 6.5F, 0.5F}));
	EXPECT_TRUE(spans(boundsOf(world, "a::two"), {0.5F, 1.5F, 1.5F}, {1.5F, 2.5F, 2.5F}));
	EXPECT_TRUE(boundsOf(world, "gone").isEmpty());
	EXPECT_TRUE(spans(boundsOf(world, "new"), {-0.5F, -0.5F, 6.5F}, {0.5F, 0.5F, 7.5F}));
}

TEST(LoadWorld, ABrokenStateLeavesWhatItWouldMoveInPlace)
{
	const World world =
	    worldOf(model("m", visual(box("1 1 1")), "3 0 0 0 0 0") +
	            "<state world_name='test'><model name='m'><pose>nan 0 0 0 0 0</pose></model><insertions>" +
	            model("new", visual(box("1 1 1")), "1 2 3") + "</insertions></state>");
	EXPECT_TRUE(spans(boundsOf(world, ""), {2.5F, -0.5F, -0.5F}, {3.5F, 0.5F, 0.5F}));
	EXPECT_THAT(warningsOf(world), AllOf(HasSubstr("<state> of 'm'"), HasSubstr("'new' is left out")));
}

TEST(LoadWorld, OfTwoModelsOfOneNameBothAreKeptAndNamed)
{
	const World world =
	    worldOf(model("twin", visual(box("1 1 1"))) + model("twin", visual(box("1 1 1")), "5 0 0 0 0 0") +
	            "<state world_name='test'><model name='twin'><pose>0 9 0 0 0 0</pose></model></state>");
	EXPECT_EQ(world.bodies.size(), 2U);
	EXPECT_TRUE(spans(boundsOf(world, "twin"), {-0.5F, -0.5F, -0.5F}, {5.5F, 9.5F, 0.5F}));
	EXPECT_THAT(warningsOf(world), HasSubstr("'twin'"));
}

TEST(LoadWorld, MaterialsHaveNameColourAndSurface)
{
	const auto look = [](const std::string& name, const std::string& material)
	{ return "<visual name='" + name + "'><geometry>" + box("1 1 1") + "</geometry>" + material + "</visual>"; };
	const World world =
	    worldOf("<model name='m'>" +
	            link(look("pane", "<material><script><name>Office/Glass</name></script></material>") +
	                 look("red", "<material><diffuse>1 0 0 1</diffuse></material>") + look("mirror_door", "") +
	                 look("tv",
	                      "<material><script><name>Gazebo/Black</name>"
	                      "</script></material>")) +
	            "</model>");
	ASSERT_EQ(world.bodies.size(), 4U);
	const auto material = [&world](std::size_t body) { return world.materials[world.bodies[body].material]; };
	EXPECT_EQ(material(0).name, "Office/Glass");
	EXPECT_EQ(material(0).surface, Surface::glass);
	EXPECT_EQ(material(1).color, Eigen::Vector3f(1, 0, 0));
	EXPECT_EQ(material(1).surface, Surface::matte);
	EXPECT_EQ(material(2).surface, Surface::mirror);
	EXPECT_EQ(material(3).surface, Surface::matte);
	EXPECT_LT(material(3).color.maxCoeff(), 0.2F);
}

TEST(LoadWorld, WhatIsBrokenIsLeftOutAndTheRestIsUsable)
{
	const World world = worldOf(
	    model("good", visual(box("1 1 1"))) + model("nan", visual(box("1 1 1")), "nan 0 0 0 0 0") +
	    model("words", visual(box("1 one 1"))) + model("far", visual(box("1 1 1")), "1e9 0 0 0 0 0") +
	    model("flat", visual(box("1 0 1"))) + model("missing", visual("<mesh><uri>model://none/a.dae</uri></mesh>")) +
	    model("hills", visual("<heightmap><uri>a.png</uri></heightmap>")) + model("picture", visual("<image/>")) +
	    model("clear",
	          "<visual name='v'><transparency>1</transparency><geometry>" + box("1 1 1") + "</geometry></visual>") +
	    "<model name='ghost'>" + link("<collision name='c'><geometry>" + box("1 1 1") + "</geometry></collision>") +
	    "</model><include><uri>model://nothing_here</uri></include><population name='crowd'/>");
	ASSERT_EQ(world.bodies.size(), 1U);
	EXPECT_EQ(world.bodies[0].name, "good::l::v");
	for (const char* name : {"'nan'", "'words::l::v'", "'far::l::v'", "'flat::l::v'", "'missing::l::v'", "heightmap",
	                         "<image>", "'clear::l::v'", "'ghost'", "nothing_here", "population"})
		EXPECT_THAT(warningsOf(world), HasSubstr(name));
	EXPECT_THAT(warningsOf(world), Not(HasSubstr("good")));
}

TEST(LoadWorld, BrokenXmlIsRefusedWithFileAndLine)
{
	freshFolder();
	const auto path = writeWorld(model("m", visual(box("1 1 1"))) + "\n<model>");
	EXPECT_THAT(messageOf([&path] { loadWorld(path, {}); }), AllOf(HasSubstr("test.sdf:6:"), HasSubstr("</world>")));
	EXPECT_THROW(loadWorld(path, {}), InputError);
}

TEST(LoadWorld, WhatIsNoWorldIsRefused)
{
	freshFolder();
	const auto refused = [](const std::string& bytes)
	{
		writeFile(testFolder() / "a.world", bytes);
		return messageOf([] { loadWorld(testFolder() / "a.world", {}); });
	};
	for (const char* bytes : {"", "hello", "<html></html>", "<sdf version='1.6'></sdf>", "\x1f\x8b\x08",
	                          "<sdf version='1.6'><world name='w'></world></sdf>"})
		EXPECT_THAT(refused(bytes), HasSubstr("a.world")) << bytes;
	EXPECT_THAT(messageOf([] { loadWorld(testFolder() / "none.world", {}); }), HasSubstr("none.world"));
}

TEST(LoadWorld, ManyEqualWarningsAreCounted)
{
	std::string content = model("good", visual(box("1 1 1")));
	for (int i = 0; i < 300; ++i)
		content += "<population name='p'/>" + model(std::string("m").append(std::to_string(i)), visual(box("1 0 1")));
	const World world = worldOf(content);
	EXPECT_THAT(warningsOf(world), AllOf(HasSubstr("(300 times)"), HasSubstr("further warnings")));
	EXPECT_LE(world.warnings.size(), 52U);
}

TEST(LoadWorld, OneHundredThousandBoxesAreNoTrouble)
{
	std::string content;
	for (int i = 0; i < 100'000; ++i)
		content += model(std::string("m").append(std::to_string(i)), visual(box("1 1 1")),
		                 std::to_string(2 * (i % 300)) + " " + std::to_string(2 * (i / 300)) + " 0 0 0 0");
	const World world = worldOf(content);
	EXPECT_EQ(world.bodies.size(), 100'000U);
	EXPECT_EQ(world.mesh.triangles.size(), 1'200'000U);
	EXPECT_THAT(world.warnings, IsEmpty());
}

TEST(LoadWorld, ActorsWalkTheirScript)
{
	const World world = worldOf(
	    model("floor", visual("<plane><normal>0 0 1</normal><size>9 9</size></plane>")) +
	    "<actor name='anna'><script><loop>true</loop><trajectory id='0' type='walk'><waypoint><time>0</time>"
	    "<pose>0 0 1 0 0 0</pose></waypoint><waypoint><time>4</time><pose>4 0 1 0 0 3.1</pose></waypoint><waypoint>"
	    "<time>8</time><pose>0 0 1 0 0 -3.1</pose></waypoint></trajectory></script></actor>"
	    "<actor name='bert'><pose>2 3 1 0 0 1</pose></actor>");
	ASSERT_EQ(world.moving.size(), 2U);
	const auto& track = world.moving[0].track;
	ASSERT_EQ(track.size(), 3U);
	EXPECT_EQ(track[1].t_s, 4);
	EXPECT_EQ(track[1].position_in_map, Eigen::Vector2d(4, 0));
	EXPECT_EQ(track[1].z_m, 0);
	// From 3.1 to −3.1 it is 0.083 rad further to the left, not 6.2 back.
	EXPECT_NEAR(track[2].yaw_rad, 2 * std::numbers::pi - 3.1, 1e-9);
	EXPECT_TRUE(world.moving[0].loop);
	ASSERT_EQ(world.moving[1].track.size(), 1U);
	EXPECT_EQ(world.moving[1].track[0].position_in_map, Eigen::Vector2d(2, 3));
	EXPECT_FALSE(world.moving[1].mesh.triangles.empty());
}
