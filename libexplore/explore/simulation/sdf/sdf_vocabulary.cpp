#include <explore/simulation/sdf/sdf_vocabulary.h>
#include <explore/simulation/sdf/world_labels.h>

#include <map>
#include <set>

namespace explore::simulation
{
namespace
{
using Words = std::set<std::string, std::less<>>;

/** Elements that are read, or that change nothing a depth camera could see of a world at rest. */
const std::map<std::string, Words, std::less<>>& knownChildren()
{
	static const std::map<std::string, Words, std::less<>> known = {
	    {"world",
	     {"model", "actor", "state", "frame", "light", "physics", "scene", "gui", "audio", "wind", "gravity",
	      "magnetic_field", "atmosphere", "spherical_coordinates", "plugin", "joint", "include", "name"}},
	    {"model",
	     {"static", "self_collide", "allow_auto_disable", "enable_wind", "pose", "link", "joint", "gripper", "frame",
	      "model", "plugin", "name", "include"}},
	    {"link",
	     {"gravity", "enable_wind", "self_collide", "kinematic", "must_be_base_link", "velocity_decay", "inertial",
	      "collision", "visual", "sensor", "projector", "audio_sink", "audio_source", "battery", "light", "pose",
	      "frame", "plugin"}},
	    {"visual",
	     {"cast_shadows", "laser_retro", "transparency", "visibility_flags", "meta", "material", "geometry", "plugin",
	      "pose", "frame"}}};
	return known;
}

/** The systems that every world of the newer Gazebo lists change nothing by themselves. */
bool isGazebosOwn(const XmlNode& plugin)
{
	const std::string file = plugin.attribute("filename");
	return file.starts_with("gz-sim") || file.starts_with("ignition-gazebo") || file.starts_with("libgz-sim") ||
	       file.starts_with("libignition-gazebo");
}

void warnBelow(const XmlNode& element, Warnings& warnings)
{
	const auto known = knownChildren().find(element.name);
	if (known == knownChildren().end()) return;
	for (const XmlNode& child : element.children)
	{
		// A prefix marks what another program has added for itself.
		const bool foreign = child.name.find(':') != std::string::npos;
		if (!foreign && !known->second.contains(child.name))
			warnings.add("<" + child.name + "> in a <" + element.name + "> is not supported and left out");
		if (child.name == "plugin" && !holdsLabels(child) && !isGazebosOwn(child))
			warnings.add("plugins are not run: " + child.attribute("filename"));
		if (child.name == "plugin" && holdsLabels(child) && element.name != "world")
			warnings.add("labels are read from a <plugin> of the <world> only, not of '" + element.attribute("name") +
			             "'");
		warnBelow(child, warnings);
	}
}
}  // namespace

void warnAboutVocabulary(const XmlNode& tree, Warnings& warnings)
{
	warnBelow(tree, warnings);
}
}  // namespace explore::simulation
