// Triangles of an SDF <geometry>.
#pragma once

#include <explore/simulation/sdf/mesh_import.h>
#include <explore/simulation/sdf/xml.h>

#include <vector>

namespace explore::simulation
{
/** What the `<geometry>` element `geometry`, which stands in `file`, looks like in the visual's frame; no look of its
 * own (an empty name) for simple shapes. Throws InputError for what is not supported, missing, or of no size. */
std::vector<Piece> piecesOf(const XmlNode& geometry, const std::filesystem::path& file, Resources& resources,
                            MeshLibrary& meshes);

/** The material of the `<visual>` element; a surface named by its script goes before one named by the visual. */
Material lookOf(const XmlNode& visual);

/** `mesh` with every coordinate times `factor`, turned inside out again where that mirrors it. */
void scale(TriangleMesh& mesh, const Eigen::Vector3d& factor);
}  // namespace explore::simulation
