// SDF worlds written by a test, and what a test asks of a loaded one.
#pragma once

#include "support/test_files.h"

#include <explore/simulation/load_world.h>

#include <Eigen/Geometry>
#include <string>

namespace explore::simulation::test
{
using namespace explore::test;

/** A world file of `content` in the test's folder, which must exist. */
inline std::filesystem::path writeWorld(const std::string& content, const std::string& version = "1.6",
                                        const std::string& name = "test.sdf")
{
	writeFile(testFolder() / name, "<?xml version='1.0'?>\n<sdf version='" + version + "'>\n<world name='test'>\n" +
	                                   content + "\n</world>\n</sdf>\n");
	return testFolder() / name;
}

/** loadWorld() of such a file, without a cache, in a fresh folder. */
inline World worldOf(const std::string& content, const std::string& version = "1.6")
{
	freshFolder();
	return loadWorld(writeWorld(content, version), {});
}

inline std::string pose(const std::string& text)
{
	return text.empty() ? text : "<pose>" + text + "</pose>";
}

inline std::string visual(const std::string& geometry, const std::string& at = "", const std::string& name = "v")
{
	return "<visual name='" + name + "'>" + pose(at) + "<geometry>" + geometry + "</geometry></visual>";
}

inline std::string box(const std::string& size)
{
	return "<box><size>" + size + "</size></box>";
}

inline std::string link(const std::string& content, const std::string& at = "", const std::string& name = "l")
{
	return "<link name='" + name + "'>" + pose(at) + content + "</link>";
}

/** A model of one link. */
inline std::string model(const std::string& name, const std::string& visuals, const std::string& at = "")
{
	return "<model name='" + name + "'><static>true</static>" + pose(at) + link(visuals) + "</model>";
}

/** The bounds of all bodies whose name begins so; empty when there is none. */
inline Eigen::AlignedBox3f boundsOf(const World& world, const std::string& name)
{
	Eigen::AlignedBox3f bounds;
	for (std::size_t i = 0; i < world.mesh.triangles.size(); ++i)
		if (world.bodies[world.body_of_triangle[i]].name.starts_with(name))
			for (const std::uint32_t corner : world.mesh.triangles[i]) bounds.extend(world.mesh.vertices[corner]);
	return bounds;
}

/** All warnings, one a line. */
inline std::string warningsOf(const World& world)
{
	std::string text;
	for (const std::string& warning : world.warnings) text.append(warning).append("\n");
	return text;
}

/** The message of what `load` throws; empty when it throws nothing. */
template <class Load>
std::string messageOf(const Load& load)
{
	try
	{
		load();
		return {};
	}
	catch (const std::exception& error)
	{
		return error.what();
	}
}

/** Whether both corners of the bounds are where they should be, to a tenth of a millimetre. */
inline bool spans(const Eigen::AlignedBox3f& bounds, const Eigen::Vector3f& low, const Eigen::Vector3f& high)
{
	return !bounds.isEmpty() && (bounds.min() - low).norm() < 1e-4F && (bounds.max() - high).norm() < 1e-4F;
}
}  // namespace explore::simulation::test
