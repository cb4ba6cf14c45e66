#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <explore/core/errors.h>
#include <explore/simulation/sdf/mesh_import.h>
#include <explore/simulation/sdf/text_reader.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>

namespace explore::simulation
{
namespace
{
std::string lowerExtension(const std::filesystem::path& path)
{
	std::string extension = path.extension().string();
	for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
	return extension.empty() ? extension : extension.substr(1);
}

/** assimp misreads Collada numbers that have a blank before them, without a word. */
std::string withoutLeadingBlanks(const std::string& collada)
{
	std::string mended;
	mended.reserve(collada.size());
	for (std::size_t i = 0; i < collada.size(); ++i)
	{
		mended.push_back(collada[i]);
		if (collada[i] != '>') continue;
		while (i + 1 < collada.size() && isBlank(collada[i + 1])) ++i;
	}
	return mended;
}

/** Notes every file that assimp opens: materials and buffers beside the mesh belong to it. */
class NotingFiles : public Assimp::DefaultIOSystem
{
public:
	explicit NotingFiles(Resources& resources) : m_resources(resources) {}
	Assimp::IOStream* Open(const char* file, const char* mode) override
	{
		m_resources.read(file);
		return DefaultIOSystem::Open(file, mode);
	}

private:
	Resources& m_resources;
};

Material lookOf(const aiScene& scene, const aiMesh& mesh)
{
	Material look;
	if (mesh.mMaterialIndex >= scene.mNumMaterials) return look;
	const aiMaterial& material = *scene.mMaterials[mesh.mMaterialIndex];
	aiString name;
	if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) look.name = name.C_Str();
	aiColor3D color;
	if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS) look.color = {color.r, color.g, color.b};
	look.color = look.color.cwiseMax(0.0F).cwiseMin(1.0F);
	look.surface = surfaceOf(look.name);
	return look;
}

/** The mesh, moved by `transform`; triangles with a broken corner are left out. */
TriangleMesh trianglesOf(const aiMesh& mesh, const aiMatrix4x4& transform)
{
	TriangleMesh triangles;
	triangles.vertices.reserve(mesh.mNumVertices);
	for (unsigned i = 0; i < mesh.mNumVertices; ++i)
	{
		const aiVector3D vertex = transform * mesh.mVertices[i];
		triangles.vertices.emplace_back(vertex.x, vertex.y, vertex.z);
	}
	const auto usable = [&triangles](unsigned i)
	{ return i < triangles.vertices.size() && triangles.vertices[i].allFinite(); };
	const bool mirrored = transform.Determinant() < 0;
	for (unsigned i = 0; i < mesh.mNumFaces; ++i)
	{
		const aiFace& face = mesh.mFaces[i];
		if (face.mNumIndices != 3 || !std::all_of(face.mIndices, face.mIndices + 3, usable)) continue;
		triangles.triangles.push_back(
		    {face.mIndices[0], face.mIndices[mirrored ? 2 : 1], face.mIndices[mirrored ? 1 : 2]});
	}
	// Nothing looks at a corner without a triangle, but it must not spoil a bounding box.
	for (Eigen::Vector3f& vertex : triangles.vertices)
		if (!vertex.allFinite())
			vertex = triangles.vertices[0].allFinite() ? triangles.vertices[0] : Eigen::Vector3f(0, 0, 0);
	return triangles;
}

void addNode(MeshFile& file, const aiScene& scene, const aiNode& node, const aiMatrix4x4& file_from_parent)
{
	const aiMatrix4x4 file_from_node = file_from_parent * node.mTransformation;
	for (unsigned i = 0; i < node.mNumMeshes; ++i)
	{
		const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
		TriangleMesh triangles = trianglesOf(mesh, file_from_node);
		if (triangles.triangles.empty()) continue;
		file.parts.push_back({mesh.mName.C_Str(), node.mName.C_Str(), {std::move(triangles), lookOf(scene, mesh)}});
	}
	for (unsigned i = 0; i < node.mNumChildren; ++i) addNode(file, scene, *node.mChildren[i], file_from_node);
}

void configure(Assimp::Importer& importer)
{
	importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);  // as Gazebo does
	importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
	importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
	// Without these, corners at the same place can be joined.
	importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS,
	                            aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS | aiComponent_COLORS |
	                                aiComponent_TEXCOORDS | aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS |
	                                aiComponent_TEXTURES | aiComponent_LIGHTS | aiComponent_CAMERAS);
}
}  // namespace

const MeshFile& MeshLibrary::at(const std::filesystem::path& path)
{
	if (const auto known = m_files.find(path); known != m_files.end()) return known->second;
	const std::optional<std::string> bytes = m_resources.read(path);
	if (!bytes) throw InputError(path.string() + ": the mesh cannot be read");
	Assimp::Importer importer;
	configure(importer);
	constexpr unsigned kSteps =
	    aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices;
	const std::string extension = lowerExtension(path);
	const aiScene* scene = nullptr;
	if (extension == "dae")
	{
		const std::string mended = withoutLeadingBlanks(*bytes);
		scene = importer.ReadFileFromMemory(mended.data(), mended.size(), kSteps, "dae");
	}
	else
	{
		importer.SetIOHandler(new NotingFiles(m_resources));  // the importer deletes it
		scene = importer.ReadFile(path.string(), kSteps);
	}
	MeshFile file;
	if (scene != nullptr && scene->mRootNode != nullptr) addNode(file, *scene, *scene->mRootNode, aiMatrix4x4());
	if (file.parts.empty())
	{
		const std::string reason = importer.GetErrorString();
		throw InputError(path.string() + ": no mesh with triangles" + (reason.empty() ? reason : ": " + reason));
	}
	return m_files.emplace(path, std::move(file)).first->second;
}
}  // namespace explore::simulation
