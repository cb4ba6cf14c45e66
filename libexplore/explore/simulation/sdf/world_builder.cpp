#include <explore/core/errors.h>
#include <explore/simulation/sdf/sdf_actor.h>
#include <explore/simulation/sdf/sdf_frames.h>
#include <explore/simulation/sdf/sdf_geometry.h>
#include <explore/simulation/sdf/sdf_state.h>
#include <explore/simulation/sdf/sdf_tree.h>
#include <explore/simulation/sdf/sdf_values.h>
#include <explore/simulation/sdf/sdf_vocabulary.h>
#include <explore/simulation/sdf/world_builder.h>
#include <explore/simulation/sdf/world_labels.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace explore::simulation
{
namespace fs = std::filesystem;
namespace
{
constexpr double kFarthest_m = 1000;

/** An element with the name, place and file that hold for everything in it. */
struct Place
{
	std::string name;  ///< scoped
	Eigen::Isometry3d map_from_element = Eigen::Isometry3d::Identity();
	fs::path file;
	Eigen::Vector3d scale{1, 1, 1};
	bool moved_by_state = true;
};

class Builder
{
public:
	Builder(World& world, Resources& resources, Warnings& warnings, const XmlNode& tree)
	    : m_world(world),
	      m_warnings(warnings),
	      m_resources(resources),
	      m_meshes(resources),
	      m_state(stateOf(tree, warnings))
	{
	}

	void addWorld(const XmlNode& tree, const fs::path& file)
	{
		const Place origin{"", Eigen::Isometry3d::Identity(), file};
		for (const XmlNode& child : tree.children)
		{
			if (child.name == "model") addTopModel(child, origin);
			if (child.name == "actor") addActor(child);
			if (holdsLabels(child)) addLabels(m_world, child, file.string());
		}
		for (const XmlNode* model : m_state.inserted) addTopModel(*model, origin);
	}

private:
	void addTopModel(const XmlNode& model, Place world)
	{
		const std::string name = model.attribute("name");
		if (m_state.deleted.contains(name)) return;
		world.moved_by_state = m_top_models.insert(name).second;
		if (!world.moved_by_state)
			m_warnings.add("two models are called '" + name + "': a <state> moves the first of them only");
		addModel(model, world);
	}

	void addActor(const XmlNode& actor)
	{
		try
		{
			m_world.moving.push_back(actorBody(actor, m_world.materialNamed("person"), m_warnings));
		}
		catch (const InputError& error)
		{
			m_warnings.add("actor '" + actor.attribute("name") + "' is left out: " + error.what());
		}
	}

	[[nodiscard]] Place placeOf(const XmlNode& element, const Place& parent, bool scoped) const
	{
		Place place = parent;
		place.name = (parent.name.empty() ? "" : parent.name + "::") + element.attribute("name");
		place.map_from_element = parent.map_from_element * poseOf(element);
		if (element.hasAttribute(kFileAttribute)) place.file = element.attribute(kFileAttribute);
		const auto moved = m_state.map_from_element.find(place.name);
		if (!scoped || !parent.moved_by_state || moved == m_state.map_from_element.end()) return place;
		place.map_from_element = moved->second;
		return place;
	}

	void addModel(const XmlNode& model, const Place& parent)
	{
		Place place = placeOf(model, parent, true);
		if (const auto scaled = m_state.scale_of_model.find(place.name); scaled != m_state.scale_of_model.end())
			place.scale = place.scale.cwiseProduct(scaled->second);
		std::size_t visuals = 0, collisions = 0;
		for (const XmlNode& child : model.children)
		{
			if (child.name == "model") addModel(child, place);
			if (child.name != "link") continue;
			const Place link = placeOf(child, place, true);
			for (const XmlNode& part : child.children)
			{
				collisions += part.name == "collision" ? 1 : 0;
				if (part.name != "visual") continue;
				++visuals;
				addVisual(part, link);
			}
		}
		if (collisions > 0 && visuals == 0)
			m_warnings.add("'" + place.name + "' is left out: it has collision shapes but nothing visible");
	}

	void addVisual(const XmlNode& visual, const Place& link)
	{
		const Place place = placeOf(visual, link, false);
		try
		{
			if (numberAt(visual, "transparency", 0) >= 1) throw InputError("it is wholly transparent");
			const XmlNode* geometry = visual.child("geometry");
			if (geometry == nullptr) throw InputError("it has no <geometry>");
			addPieces(piecesOf(*geometry, place.file, m_resources, m_meshes), visual, place);
		}
		catch (const InputError& error)
		{
			m_warnings.add("'" + place.name + "' is left out: " + error.what());
		}
	}

	/** One body for each material among `pieces`. */
	void addPieces(const std::vector<Piece>& pieces, const XmlNode& visual, const Place& place)
	{
		const bool own_look =
		    visual.descendant("material/script") != nullptr || visual.descendant("material/diffuse") != nullptr;
		const Material look = lookOf(visual);
		std::vector<std::pair<std::size_t, TriangleMesh>> meshes;
		for (const Piece& piece : pieces)
		{
			const bool from_mesh = !own_look && look.surface == Surface::matte && !piece.look.name.empty();
			const std::size_t material = materialOf(from_mesh ? piece.look : look);
			TriangleMesh scaled = piece.mesh;
			scale(scaled, place.scale);
			if (meshes.empty() || meshes.back().first != material) meshes.emplace_back(material, TriangleMesh());
			append(meshes.back().second, scaled, place.map_from_element);
		}
		for (const auto& [material, mesh] : meshes)
		{
			demandNear(mesh);
			m_world.add(place.name, mesh, material);
		}
	}

	static void demandNear(const TriangleMesh& mesh)
	{
		Eigen::AlignedBox3f bounds;
		for (const Eigen::Vector3f& vertex : mesh.vertices) bounds.extend(vertex);
		const double distance_m = bounds.exteriorDistance(Eigen::Vector3f(0, 0, 0));
		if (distance_m > kFarthest_m)
			throw InputError("it is " + std::to_string(static_cast<long long>(std::min(distance_m, 1e15))) +
			                 " m from the origin; at most 1000 m is accepted");
	}

	/** Materials of the same name may differ in colour; those without a name are called by it. */
	std::size_t materialOf(const Material& look)
	{
		std::array<char, 8> color{};
		const Eigen::Array3i rgb = (look.color.array() * 255.0F).round().cast<int>();
		std::snprintf(color.data(), color.size(), "#%02x%02x%02x", rgb[0] & 255, rgb[1] & 255, rgb[2] & 255);
		Material material = look;
		if (material.name.empty()) material.name = color.data();
		const auto [known, added] = m_materials.emplace(look.name + color.data(), m_world.materials.size());
		if (added) m_world.materials.push_back(material);
		return known->second;
	}

	World& m_world;
	Warnings& m_warnings;
	Resources& m_resources;
	MeshLibrary m_meshes;
	WorldState m_state;
	std::map<std::string, std::size_t> m_materials;
	std::set<std::string> m_top_models;
};

/** Removes everything whose pose is no pose, so that nobody has to guess where it stands. */
void removeUnplaced(XmlNode& parent, Warnings& warnings)
{
	const auto unplaced = [&warnings](const XmlNode& child)
	{
		try
		{
			if (child.name == "model" || child.name == "link" || child.name == "visual") poseOf(child);
			return false;
		}
		catch (const InputError& error)
		{
			warnings.add("<" + child.name + "> '" + child.attribute("name") + "' is left out: " + error.what());
			return true;
		}
	};
	std::erase_if(parent.children, unplaced);
	for (XmlNode& child : parent.children)
	{
		if (child.name == "model" || child.name == "link") removeUnplaced(child, warnings);
		for (XmlNode& change : child.children)
			if (child.name == "state" && change.name == "insertions") removeUnplaced(change, warnings);
	}
}
}  // namespace

World buildWorld(XmlNode tree, const fs::path& file, Resources& resources, Warnings& warnings)
{
	warnAboutVocabulary(tree, warnings);
	removeUnplaced(tree, warnings);
	resolveFrames(tree, warnings);
	World world;
	world.name = tree.attribute("name");
	Builder(world, resources, warnings, tree).addWorld(tree, file);
	return world;
}
}  // namespace explore::simulation
