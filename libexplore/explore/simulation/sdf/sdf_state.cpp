#include <explore/core/errors.h>
#include <explore/simulation/sdf/sdf_state.h>
#include <explore/simulation/sdf/sdf_values.h>

namespace explore::simulation
{
namespace
{
void takeElement(WorldState& state, const XmlNode& element, const std::string& prefix, Warnings& warnings)
{
	const std::string name = prefix + element.attribute("name");
	try
	{
		if (element.child("pose") != nullptr) state.map_from_element.emplace(name, poseOf(element));
		const Eigen::Vector3d scale = vectorAt(element, "scale", Eigen::Vector3d(1, 1, 1));
		if (scale != Eigen::Vector3d(1, 1, 1)) state.scale_of_model.emplace(name, scale);
	}
	catch (const InputError& error)
	{
		warnings.add("<state> of '" + name + "' is left out: " + error.what());
	}
	for (const XmlNode& child : element.children)
		if (child.name == "link" || child.name == "model") takeElement(state, child, name + "::", warnings);
}
}  // namespace

WorldState stateOf(const XmlNode& world, Warnings& warnings)
{
	WorldState state;
	for (const XmlNode& element : world.children)
	{
		if (element.name != "state") continue;
		for (const XmlNode& child : element.children)
		{
			if (child.name == "model") takeElement(state, child, "", warnings);
			for (const XmlNode& change : child.children)
			{
				if (child.name == "insertions" && change.name == "model") state.inserted.push_back(&change);
				if (child.name == "deletions" && change.name == "name") state.deleted.insert(change.text);
			}
		}
	}
	return state;
}
}  // namespace explore::simulation
