// The <state> of a saved Gazebo world: where models and links have gone since they were placed.
#pragma once

#include <explore/simulation/sdf/warnings.h>
#include <explore/simulation/sdf/xml.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace explore::simulation
{
/** Names are scoped: "model", "model::link", "model::inner model::link". */
struct WorldState
{
	std::map<std::string, Eigen::Isometry3d> map_from_element;
	std::map<std::string, Eigen::Vector3d> scale_of_model;  ///< only those that are not 1 1 1
	std::set<std::string> deleted;
	std::vector<const XmlNode*> inserted;  ///< models inside the world's tree
};

/** Of all `<state>` elements in `world`; a broken pose is left out with a warning. */
WorldState stateOf(const XmlNode& world, Warnings& warnings);
}  // namespace explore::simulation
