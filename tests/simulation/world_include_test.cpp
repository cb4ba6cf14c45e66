// loadWorld: models from other files, meshes, and where they are looked for.
#include "simulation/world_fixture.h"

#include <gmock/gmock.h>

using namespace explore::simulation::test;
using explore::simulation::loadWorld;
using explore::simulation::World;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

/** assimp loses some memory of its own when it gives up on a broken mesh; the leak sanitizer asks this function. */
extern "C" const char* __lsan_default_suppressions()  // NOLINT(bugprone-reserved-identifier)
{
	return "leak:libassimp.so";
}

namespace
{
std::string sdf(const std::string& content, const std::string& version = "1.6")
{
	return "<sdf version='" + version + "'>" + content + "</sdf>";
}

/** A model folder with a config and one file for each version. */
void writeModel(const fs::path& folder, const std::vector<std::pair<std::string, std::string>>& versions)
{
	fs::create_directories(folder);
	std::string config = "<?xml version='1.0'?><model><name>x</name>";
	for (const auto& [version, content] : versions)
	{
		config += "<sdf version='" + version + "'>model-" + version + ".sdf</sdf>";
		writeFile(folder / ("model-" + version + ".sdf"), sdf(content, version));
	}
	writeFile(folder / "model.config", config + "</model>");
}

std::string include(const std::string& uri, const std::string& more = "")
{
	return "<include><uri>" + uri + "</uri>" + more + "</include>";
}

/** A box 2 × 1 × 0.5 around (1, 0.5, 0.25) in ASCII STL. */
std::string stlOf(const std::string& solid)
{
	const Eigen::Vector3f size(2, 1, 0.5F);
	std::string text = "solid " + solid + "\n";
	const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
	                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
	for (const auto& face : faces)
	{
		text += "facet normal 0 0 0\nouter loop\n";
		for (const int corner : face)
			text += "vertex " + std::to_string((corner & 1) != 0 ? size.x() : 0) + " " +
			        std::to_string((corner & 2) != 0 ? size.y() : 0) + " " +
			        std::to_string((corner & 4) != 0 ? size.z() : 0) + "\n";
		text += "endloop\nendfacet\n";
	}
	return text + "endsolid\n";
}

/** Two triangles as geometries "left" (at x < 0) and "right", 100 units to a metre; a blank stands before the numbers.
 */
std::string colladaOf(const std::string& up_axis = "Z_UP")
{
	const auto geometry = [](const std::string& name, const std::string& numbers)
	{
		return "<geometry id='" + name + "-id' name='" + name + "'><mesh><source id='" + name +
		       "-p'><float_array id='" + name + "-a' count='9'>\n " + numbers +
		       "</float_array><technique_common><accessor source='#" + name +
		       "-a' count='3' stride='3'><param name='X' type='float'/><param name='Y' type='float'/><param name='Z' "
		       "type='float'/></accessor></technique_common></source><vertices id='" +
		       name + "-v'><input semantic='POSITION' source='#" + name +
		       "-p'/></vertices><triangles count='1'><input semantic='VERTEX' source='#" + name +
		       "-v' offset='0'/><p> 0 1 2</p></triangles></mesh></geometry>";
	};
	const auto node = [](const std::string& name)
	{ return "<node id='" + name + "-n' name='" + name + "'><instance_geometry url='#" + name + "-id'/></node>"; };
	return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
	       "<unit name='centimeter' meter='0.01'/><up_axis>" +
	       up_axis + "</up_axis></asset><library_geometries>" + geometry("left", "-300 0 0 -100 0 0 -100 0 200") +
	       geometry("right", "100 0 0 300 0 0 300 0 200") +
	       "</library_geometries><library_visual_scenes><visual_scene id='s'>" + node("left") + node("right") +
	       "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

std::string mesh(const std::string& uri, const std::string& more = "")
{
	return model("m", visual("<mesh><uri>" + uri + "</uri>" + more + "</mesh>"));
}
}  // namespace

TEST(IncludedModels, TakeNameAndPoseFromTheWorld)
{
	writeModel(freshFolder() / "models" / "crate", {{"1.6", model("crate", visual(box("1 1 1")), "0 0 5 0 0 0")}});
	const auto path =
	    writeWorld(include("model://crate", "<name>first</name><pose>3 0 0 0 0 0</pose>") + include("model://crate"));
	const World world = loadWorld(path, {});
	EXPECT_THAT(world.warnings, IsEmpty());
	EXPECT_TRUE(spans(boundsOf(world, "first"), {2.5F, -0.5F, -0.5F}, {3.5F, 0.5F, 0.5F}));
	EXPECT_TRUE(spans(boundsOf(world, "crate"), {-0.5F, -0.5F, 4.5F}, {0.5F, 0.5F, 5.5F}));
}

TEST(IncludedModels, AreFoundInEveryPlaceThatGazeboLooksIn)
{
	const fs::path root = freshFolder();
	const auto content = [](const std::string& name) { return model(name, visual(box("1 1 1"))); };
	writeModel(root / "worlds" / "beside", {{"1.6", content("beside")}});
	writeModel(root / "worlds" / "models" / "below", {{"1.6", content("below")}});
	writeModel(root / "models" / "parent", {{"1.6", content("parent")}});
	writeModel(root / "elsewhere" / "folder", {{"1.6", content("folder")}});
	writeModel(root / "elsewhere" / "fuel_thing", {{"1.6", content("fuel")}});
	writeFile(
	    root / "worlds" / "w.world",
	    sdf("<world name='w'>" + include("model://beside") + include("model://below") + include("model://parent") +
	        include("model://folder") + include("file://models/parent", "<name>by_file</name>") +
	        include("https://fuel.gazebosim.org/1.0/Someone/models/Fuel%20Thing/2") + "</world>"));
	const World world = loadWorld(root / "worlds" / "w.world", {{root / "elsewhere"}, {}, {}});
	EXPECT_THAT(world.warnings, IsEmpty());
	for (const char* name : {"beside", "below", "parent", "folder", "by_file", "fuel"})
		EXPECT_FALSE(boundsOf(world, name).isEmpty()) << name;
}

TEST(IncludedModels, UseTheNewestVersionThatIsKnown)
{
	writeModel(freshFolder() / "crate", {{"1.4", model("crate", visual(box("4 4 4")))},
	                                     {"1.6", model("crate", visual(box("6 6 6")))},
	                                     {"7.0", model("crate", visual(box("9 9 9")))}});
	const World world = loadWorld(writeWorld(include("model://crate")), {});
	EXPECT_FLOAT_EQ(boundsOf(world, "crate").sizes().x(), 6);
}

TEST(IncludedModels, OfOldVersionsAreReadOrNamed)
{
	const fs::path root = freshFolder();
	writeModel(root / "crate", {});
	writeFile(root / "crate" / "model.sdf",
	          "<gazebo version='1.2'>" + model("crate", visual(box("2 2 2")), "0 0 1 0 0 0") + "</gazebo>");
	writeModel(root / "relic", {{"1.0", "<model name='relic'/>"}});
	const World world = loadWorld(writeWorld(include("model://crate") + include("model://relic")), {});
	EXPECT_TRUE(spans(boundsOf(world, "crate"), {-1, -1, 0}, {1, 1, 2}));
	EXPECT_THAT(warningsOf(world), HasSubstr("version 1.0 is too old"));
}

TEST(IncludedModels, MayIncludeOthersButNotThemselves)
{
	const fs::path root = freshFolder();
	writeModel(root / "leaf", {{"1.6", model("leaf", visual(box("1 1 1")), "0 0 1 0 0 0")}});
	writeModel(root / "tree",
	           {{"1.6", "<model name='tree'><pose>5 0 0 0 0 0</pose>" + include("model://leaf") + "</model>"}});
	writeModel(root / "loop", {{"1.6", "<model name='loop'>" + include("model://loop") + "</model>"}});
	const World world = loadWorld(writeWorld(include("model://tree") + include("model://loop")), {});
	EXPECT_TRUE(spans(boundsOf(world, "tree::leaf"), {4.5F, -0.5F, 0.5F}, {5.5F, 0.5F, 1.5F}));
	EXPECT_THAT(warningsOf(world), HasSubstr("without end"));
}

TEST(IncludedModels, GroundPlaneAndSunNeedNoModels)
{
	freshFolder();
	const World world = loadWorld(writeWorld(include("model://ground_plane") + include("model://sun")), {});
	EXPECT_TRUE(spans(boundsOf(world, "ground_plane"), {-50, -50, 0}, {50, 50, 0}));
	EXPECT_THAT(warningsOf(world), HasSubstr("stands in"));
}

TEST(Meshes, AreFoundFromTheModelsOwnFileAndScaled)
{
	const fs::path crate = freshFolder() / "models" / "crate";
	writeModel(crate, {{"1.6", mesh("meshes/box.stl", "<scale>2 1 -1</scale>")}});
	fs::create_directories(crate / "meshes");
	writeFile(crate / "meshes" / "box.stl", stlOf("a"));
	const World world = loadWorld(writeWorld(include("model://crate")), {});
	EXPECT_THAT(world.warnings, IsEmpty());
	EXPECT_EQ(world.mesh.triangles.size(), 12U);
	EXPECT_TRUE(spans(boundsOf(world, "m"), {0, 0, -0.5F}, {4, 1, 0}));
	// Mirrored by its scale, the box still faces outward.
	double six_volumes = 0;
	for (const auto& [a, b, c] : world.mesh.triangles)
		six_volumes += world.mesh.vertices[a].dot(world.mesh.vertices[b].cross(world.mesh.vertices[c]));
	EXPECT_NEAR(six_volumes / 6, 2.0, 1e-4);
}

TEST(Meshes, OfColladaKeepTheirUnitAndIgnoreTheirUpAxis)
{
	for (const char* up : {"Z_UP", "Y_UP"})
	{
		writeFile(freshFolder() / "a.dae", colladaOf(up));
		const World world = loadWorld(writeWorld(mesh("a.dae")), {});
		EXPECT_THAT(world.warnings, IsEmpty());
		EXPECT_TRUE(spans(boundsOf(world, "m"), {-3, 0, 0}, {3, 0, 2})) << up;
	}
}

TEST(Meshes, OneSubmeshMayBePickedAndCentred)
{
	writeFile(freshFolder() / "a.dae", colladaOf());
	const std::string submesh = "<submesh><name>right</name><center>";
	World world = loadWorld(writeWorld(mesh("a.dae", submesh + "false</center></submesh>")), {});
	EXPECT_TRUE(spans(boundsOf(world, "m"), {1, 0, 0}, {3, 0, 2}));
	world = loadWorld(writeWorld(mesh("a.dae", submesh + "true</center></submesh>")), {});
	EXPECT_TRUE(spans(boundsOf(world, "m"), {-1, 0, -1}, {1, 0, 1}));
	const auto path =
	    writeWorld(mesh("a.dae", "<submesh><name>middle</name></submesh>") + model("x", visual(box("1 1 1"))));
	EXPECT_THAT(warningsOf(loadWorld(path, {})), HasSubstr("no submesh 'middle'"));
}

TEST(Meshes, ThatAreNoneAreNamed)
{
	writeFile(freshFolder() / "a.dae", "no mesh at all");
	writeFile(testFolder() / "b.stl", "");
	writeFile(testFolder() / "c.stl", stlOf("c").substr(0, 100));
	const auto path = writeWorld(mesh("a.dae") + mesh("b.stl") + mesh("c.stl") + model("x", visual(box("1 1 1"))));
	const World world = loadWorld(path, {});
	EXPECT_EQ(world.bodies.size(), 1U);
	for (const char* name : {"a.dae", "b.stl", "c.stl"}) EXPECT_THAT(warningsOf(world), HasSubstr(name));
}
