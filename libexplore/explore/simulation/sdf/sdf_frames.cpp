#include <explore/simulation/sdf/sdf_frames.h>
#include <explore/simulation/sdf/sdf_values.h>

#include <algorithm>
#include <sdf/sdf.hh>
#include <set>

namespace explore::simulation
{
namespace
{
bool hasFrame(const XmlNode& element)
{
	const XmlNode* pose = element.child("pose");
	return element.hasAttribute("placement_frame") || (pose != nullptr && !pose->attribute("relative_to").empty());
}

bool isPlaced(const XmlNode& element)
{
	return element.name == "model" || element.name == "link" || element.name == "visual";
}

/** Whether a pose anywhere in `element` counts from something else than the element around it. */
bool usesFrames(const XmlNode& element)
{
	return hasFrame(element) || std::any_of(element.children.begin(), element.children.end(),
	                                        [](const XmlNode& child) { return isPlaced(child) && usesFrames(child); });
}

void writeAttribute(std::string& text, const XmlNode& element, std::string_view name)
{
	if (element.hasAttribute(name))
		text.append(" ").append(name).append("=\"").append(escapeXml(element.attribute(name))).append("\"");
}

void writeText(std::string& text, const XmlNode& element)
{
	text.append("<").append(element.name);
	for (const auto& [name, value] : element.attributes) writeAttribute(text, element, name);
	text.append(">").append(escapeXml(element.text)).append("</").append(element.name).append(">");
}

/** The part of `element` that poses depend on. Visuals are called by their number: no frame refers to them. */
void writeSkeleton(std::string& text, const XmlNode& element, std::size_t number = 0)
{
	text.append("<").append(element.name);
	if (element.name == "visual")
		text.append(" name=\"").append(std::to_string(number)).append("\"");
	else
		writeAttribute(text, element, "name");
	for (const char* name : {"attached_to", "placement_frame", "canonical_link"}) writeAttribute(text, element, name);
	text.append(element.name == "joint" ? " type=\"fixed\">" : ">");
	std::size_t visuals = 0;
	for (const XmlNode& child : element.children)
	{
		if (child.name == "pose" || child.name == "static" || child.name == "parent" || child.name == "child")
			writeText(text, child);
		if (isPlaced(child) || child.name == "frame" || child.name == "joint")
			writeSkeleton(text, child, child.name == "visual" ? visuals++ : 0);
	}
	if (element.name == "visual") text.append("<geometry><empty/></geometry>");
	text.append("</").append(element.name).append(">");
}

/** "a" of "a::b::c". */
std::string outermost(const std::string& name)
{
	return name.substr(0, name.find("::"));
}

/** The names that poses and frames of the world itself refer to. */
std::set<std::string> worldFrameNames(const XmlNode& world)
{
	std::set<std::string> names;
	for (const XmlNode& child : world.children)
	{
		if (child.name != "model" && child.name != "frame") continue;
		names.insert(outermost(child.attribute("attached_to")));
		if (const XmlNode* pose = child.child("pose")) names.insert(outermost(pose->attribute("relative_to")));
	}
	return names;
}

class FrameResolver
{
public:
	explicit FrameResolver(Warnings& warnings) : m_warnings(warnings) {}

	/** Takes over the poses of `element`'s DOM twin, and of all below it. */
	void take(XmlNode& model, const sdf::Model& resolved)
	{
		takePose(model, resolved.SemanticPose(), resolved.Name());
		for (XmlNode& child : model.children)
		{
			const std::string name = child.attribute("name");
			if (child.name == "model" && resolved.ModelByName(name) != nullptr)
				take(child, *resolved.ModelByName(name));
			if (child.name == "link" && resolved.LinkByName(name) != nullptr)
				takeLink(child, *resolved.LinkByName(name));
		}
	}

private:
	void takeLink(XmlNode& link, const sdf::Link& resolved)
	{
		takePose(link, resolved.SemanticPose(), resolved.Name());
		std::size_t number = 0;
		for (XmlNode& child : link.children)
		{
			if (child.name != "visual") continue;
			if (const sdf::Visual* visual = resolved.VisualByName(std::to_string(number++)))
				takePose(child, visual->SemanticPose(), child.attribute("name"));
		}
	}

	void takePose(XmlNode& element, const sdf::SemanticPose& semantic, const std::string& name)
	{
		ignition::math::Pose3d pose;
		if (const sdf::Errors errors = semantic.Resolve(pose); !errors.empty())
		{
			if (hasFrame(element))
				m_warnings.add("the pose of '" + name + "' is taken as written: " + errors.front().Message());
			return;
		}
		Eigen::Isometry3d parent_from_element = Eigen::Isometry3d::Identity();
		parent_from_element.translation() = Eigen::Vector3d(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z());
		const auto& turn = pose.Rot();
		parent_from_element.linear() = Eigen::Quaterniond(turn.W(), turn.X(), turn.Y(), turn.Z()).toRotationMatrix();
		std::erase_if(element.children, [](const XmlNode& child) { return child.name == "pose"; });
		XmlNode written;
		written.name = "pose";
		written.line = element.line;
		written.text = poseText(parent_from_element);
		written.setAttribute("rotation_format", "quat_xyzw");
		element.children.push_back(std::move(written));
	}

	Warnings& m_warnings;
};

void loadSkeleton(sdf::Root& root, const std::string& skeleton, Warnings& warnings)
{
	sdf::Console::Instance()->SetQuiet(true);  // it writes to the terminal whatever it thinks
	try
	{
		// The first error is the cause, the rest are what follows from it.
		const sdf::Errors errors = root.LoadSdfString(skeleton);
		if (!errors.empty()) warnings.add("frames: " + errors.front().Message());
	}
	catch (const sdf::Exception& error)
	{
		warnings.add("frames: " + error.GetErrorStr());
	}
}
}  // namespace

void resolveFrames(XmlNode& world, Warnings& warnings)
{
	const std::set<std::string> named = worldFrameNames(world);
	const auto concerned = [&named](const XmlNode& child)
	{ return child.name == "model" && (usesFrames(child) || named.contains(child.attribute("name"))); };
	if (std::none_of(world.children.begin(), world.children.end(), concerned)) return;
	std::string skeleton = R"(<?xml version="1.0"?><sdf version="1.9"><world name="explore">)";
	for (const XmlNode& child : world.children)
		if (concerned(child) || child.name == "frame") writeSkeleton(skeleton, child);
	skeleton += "</world></sdf>";
	sdf::Root root;
	loadSkeleton(root, skeleton, warnings);
	if (root.WorldCount() == 0) return warnings.add("poses that use frames are taken as written");
	FrameResolver resolver(warnings);
	for (XmlNode& child : world.children)
		if (concerned(child))
			if (const sdf::Model* model = root.WorldByIndex(0)->ModelByName(child.attribute("name")))
				resolver.take(child, *model);
}
}  // namespace explore::simulation
