#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/simulation/sdf/sdf_tree.h>

#include <algorithm>
#include <cctype>

namespace explore::simulation
{
namespace fs = std::filesystem;
namespace
{
/** Before this version, poses and sizes were written differently. */
constexpr double kOldest = 1.2;
constexpr int kDeepestInclude = 20;

/** Where Gazebo's two standard models are missing, these do what they do. */
constexpr std::string_view kGroundPlane =
    "<sdf version='1.6'><model name='ground_plane'><static>true</static><link name='link'><visual name='visual'>"
    "<geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>"
    "<material><script><name>Gazebo/Grey</name></script></material></visual></link></model></sdf>";
constexpr std::string_view kSun = "<sdf version='1.6'><light name='sun' type='directional'/></sdf>";

class Includer
{
public:
	Includer(Resources& resources, Warnings& warnings) : m_resources(resources), m_warnings(warnings) {}

	/** The root element of a file. */
	XmlNode readSdf(const fs::path& path)
	{
		const std::optional<std::string> text = m_resources.read(path);
		if (!text) throw InputError(path.string() + ": cannot be read");
		XmlNode root = parseXml(*text, path.string());
		if (root.name != "sdf" && root.name != "gazebo")
			throw InputError(path.string() + ":" + std::to_string(root.line) + ": <" + root.name +
			                 "> is no SDF; <sdf> is needed");
		if (parseNumber(root.attribute("version")).value_or(kOldest) < kOldest)
			throw InputError(path.string() + ":" + std::to_string(root.line) + ": SDF version " +
			                 root.attribute("version") + " is too old; 1.2 or later is needed");
		return root;
	}

	/** Replaces every <include> below `parent`, which stands in `file`. */
	void expand(XmlNode& parent, const fs::path& file, int depth = 0)
	{
		for (XmlNode& child : parent.children)
		{
			if (child.name == "model") expand(child, file, depth);
			if (child.name == "include") include(child, file, depth);
		}
		std::erase_if(parent.children, [](const XmlNode& child) { return child.name == "include"; });
		// <state> may put further models into a world.
		for (XmlNode& child : parent.children)
			if (child.name == "state" || child.name == "insertions") expand(child, file, depth);
	}

private:
	void include(XmlNode& include, const fs::path& file, int depth)
	{
		const std::string uri = include.textAt("uri");
		const std::string where = file.string() + ":" + std::to_string(include.line) + ": <include> of '" + uri + "': ";
		try
		{
			if (depth >= kDeepestInclude) throw InputError("models include each other without end; left out");
			XmlNode thing = included(uri, file, depth);
			// What the including file says goes before what the model says.
			if (const std::string name = include.textAt("name"); !name.empty()) thing.setAttribute("name", name);
			if (const XmlNode* pose = include.child("pose"))
			{
				std::erase_if(thing.children, [](const XmlNode& child) { return child.name == "pose"; });
				thing.children.insert(thing.children.begin(), *pose);
			}
			if (const std::string frame = include.textAt("placement_frame"); !frame.empty())
				thing.setAttribute("placement_frame", frame);
			thing.line = include.line;
			include = std::move(thing);
		}
		catch (const InputError& error)
		{
			m_warnings.add(where + error.what());
		}
	}

	XmlNode included(const std::string& uri, const fs::path& file, int depth)
	{
		std::optional<fs::path> path = m_resources.find(uri, file);
		std::error_code error;
		if (path && fs::is_directory(*path, error)) path = m_resources.modelFileIn(*path);
		if (!path) return builtIn(uri, file);
		XmlNode root = readSdf(*path);
		for (XmlNode& thing : root.children)
			if (thing.name == "model" || thing.name == "actor" || thing.name == "light")
			{
				expand(thing, *path, depth + 1);
				thing.setAttribute(kFileAttribute, path->string());
				return std::move(thing);
			}
		throw InputError(path->string() + " holds no model, actor or light; left out");
	}

	XmlNode builtIn(const std::string& uri, const fs::path& file)
	{
		std::string name = uri;
		for (char& letter : name)
			letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
		std::string_view text;
		if (name.ends_with("ground_plane") || name.ends_with("ground%20plane")) text = kGroundPlane;
		if (name.ends_with("/sun")) text = kSun;
		if (text.empty()) throw InputError("not found in " + m_resources.searched() + "; left out");
		XmlNode thing = parseXml(text, name).children.front();
		thing.setAttribute(kFileAttribute, file.string());
		if (text == kGroundPlane)
			m_warnings.add("'" + uri + "' was not found: a plane of 100 × 100 m stands in for it");
		return thing;
	}

	Resources& m_resources;
	Warnings& m_warnings;
};
}  // namespace

XmlNode readWorldTree(const fs::path& path, Resources& resources, Warnings& warnings)
{
	Includer includer(resources, warnings);
	XmlNode root = includer.readSdf(path);
	const auto is_world = [](const XmlNode& child) { return child.name == "world"; };
	const auto world = std::find_if(root.children.begin(), root.children.end(), is_world);
	if (world == root.children.end()) throw InputError(path.string() + ": there is no <world> in it");
	if (std::count_if(root.children.begin(), root.children.end(), is_world) > 1)
		warnings.add(path.string() + ": only the first of its worlds is read");
	includer.expand(*world, path);
	return std::move(*world);
}
}  // namespace explore::simulation
