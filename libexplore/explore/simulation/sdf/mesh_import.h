// Reads mesh files (Collada, STL, OBJ, glTF, …) through assimp.
#pragma once

#include <explore/simulation/sdf/resources.h>
#include <explore/simulation/world.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace explore::simulation
{
/** Triangles of one material, with a material of its own. */
struct Piece
{
	TriangleMesh mesh;
	Material look;
};

struct MeshFile
{
	struct Part
	{
		std::string mesh_name, node_name;  ///< either may be what SDF calls a submesh
		Piece piece;                       ///< in the file's frame, metres
	};
	std::vector<Part> parts;
};

/** Mesh files, each read once. */
class MeshLibrary
{
public:
	explicit MeshLibrary(Resources& resources) : m_resources(resources) {}

	/** The mesh at `path`. Throws InputError that names the file when it cannot be read or has no triangles. */
	const MeshFile& at(const std::filesystem::path& path);

private:
	Resources& m_resources;
	std::map<std::filesystem::path, MeshFile> m_files;
};
}  // namespace explore::simulation
