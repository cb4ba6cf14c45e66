#include <explore/core/errors.h>
#include <explore/simulation/sdf/sdf_geometry.h>
#include <explore/simulation/sdf/sdf_values.h>
#include <explore/simulation/shapes.h>

#include <algorithm>

namespace explore::simulation
{
namespace
{
/** Sizes below are nothing that a camera could see; sizes above are no world. */
constexpr double kLeastSize_m = 1e-6, kMostSize_m = 1e5;

double sizeAt(const XmlNode& shape, std::string_view child, double otherwise)
{
	const double size_m = numberAt(shape, child, otherwise);
	if (size_m < kLeastSize_m || size_m > kMostSize_m)
		throw InputError("<" + shape.name + "> has the " + std::string(child) + " " + std::to_string(size_m) +
		                 " m; more than 0 and at most 100000 is needed");
	return size_m;
}

Eigen::VectorXd sizesAt(const XmlNode& shape, std::string_view child, const Eigen::VectorXd& otherwise)
{
	Eigen::VectorXd sizes = vectorAt(shape, child, otherwise);
	if (sizes.cwiseAbs().minCoeff() < kLeastSize_m || sizes.cwiseAbs().maxCoeff() > kMostSize_m)
		throw InputError("<" + shape.name + "> has a zero or absurd " + std::string(child) + " '" +
		                 shape.textAt(child) + "'; more than 0 and at most 100000 is needed");
	return sizes;
}

TriangleMesh ellipsoidMesh(const XmlNode& shape)
{
	TriangleMesh mesh = sphereMesh(1.0, 16);
	scale(mesh, sizesAt(shape, "radii", Eigen::Vector3d(1, 1, 1)));
	return mesh;
}

TriangleMesh floorMesh(const XmlNode& shape)
{
	const Eigen::Vector3d normal = vectorAt(shape, "normal", Eigen::Vector3d::UnitZ());
	if (normal.norm() < kLeastSize_m) throw InputError("<plane> has a <normal> of length 0");
	return planeMesh(normal, sizesAt(shape, "size", Eigen::Vector2d(1, 1)));
}

std::vector<Eigen::Vector2d> outlineOf(const XmlNode& polyline)
{
	std::vector<Eigen::Vector2d> outline;
	for (const XmlNode& child : polyline.children)
	{
		if (child.name != "point") continue;
		const auto point = numbersIn(child.text);
		if (!point || point->size() != 2)
			throw InputError("<polyline> has the <point> '" + child.text + "'; two finite numbers are needed");
		outline.emplace_back((*point)[0], (*point)[1]);
	}
	return outline;
}

/** All polylines of `geometry` together: one inside another is a hole. */
TriangleMesh polylineMesh(const XmlNode& geometry)
{
	std::vector<std::vector<Eigen::Vector2d>> rings;
	for (const XmlNode& child : geometry.children)
		if (child.name == "polyline") rings.push_back(outlineOf(child));
	TriangleMesh mesh = prismMesh(rings, sizeAt(*geometry.child("polyline"), "height", 1.0));
	if (mesh.triangles.empty()) throw InputError("<polyline> encloses no area: three or more points are needed");
	return mesh;
}

void centre(std::vector<Piece>& pieces)
{
	Eigen::AlignedBox3f bounds;
	for (const Piece& piece : pieces)
		for (const Eigen::Vector3f& vertex : piece.mesh.vertices) bounds.extend(vertex);
	for (Piece& piece : pieces)
		for (Eigen::Vector3f& vertex : piece.mesh.vertices) vertex -= bounds.center();
}

std::vector<Piece> meshPieces(const XmlNode& shape, const std::filesystem::path& file, Resources& resources,
                              MeshLibrary& meshes)
{
	const std::string uri = shape.textAt("uri"), submesh = shape.textAt("submesh/name");
	const auto path = resources.find(uri, file);
	if (!path) throw InputError("the mesh '" + uri + "' was not found in " + resources.searched());
	std::vector<Piece> pieces;
	for (const MeshFile::Part& part : meshes.at(*path).parts)
		if (submesh.empty() || submesh == part.mesh_name || submesh == part.node_name) pieces.push_back(part.piece);
	if (pieces.empty()) throw InputError("the mesh '" + uri + "' has no submesh '" + submesh + "'");
	if (!submesh.empty() && flagAt(*shape.child("submesh"), "center")) centre(pieces);
	const Eigen::Vector3d factor = sizesAt(shape, "scale", Eigen::Vector3d(1, 1, 1));
	for (Piece& piece : pieces) scale(piece.mesh, factor);
	return pieces;
}

TriangleMesh simpleShape(const XmlNode& shape)
{
	if (shape.name == "box") return boxMesh(sizesAt(shape, "size", Eigen::Vector3d(1, 1, 1)).cwiseAbs());
	if (shape.name == "cylinder") return cylinderMesh(sizeAt(shape, "radius", 1), sizeAt(shape, "length", 1));
	if (shape.name == "sphere") return sphereMesh(sizeAt(shape, "radius", 1), 16);
	if (shape.name == "capsule") return capsuleMesh(sizeAt(shape, "radius", 0.5), sizeAt(shape, "length", 1));
	if (shape.name == "ellipsoid") return ellipsoidMesh(shape);
	if (shape.name == "plane") return floorMesh(shape);
	throw InputError("<" + shape.name + "> geometry is not supported");
}

/** What Gazebo's own material scripts look like; the rest is light grey. */
Eigen::Vector3f colorOfScript(const std::string& script)
{
	struct Named
	{
		std::string_view word;
		Eigen::Vector3f color;
	};
	static const std::vector<Named> known = {{"Black", {0.05F, 0.05F, 0.05F}}, {"DarkGrey", {0.3F, 0.3F, 0.3F}},
	                                         {"Grey", {0.5F, 0.5F, 0.5F}},     {"White", {1, 1, 1}},
	                                         {"Red", {0.8F, 0.1F, 0.1F}},      {"Green", {0.1F, 0.7F, 0.1F}},
	                                         {"SkyBlue", {0.4F, 0.7F, 0.9F}},  {"Blue", {0.1F, 0.1F, 0.8F}},
	                                         {"Yellow", {0.9F, 0.9F, 0.1F}},   {"Orange", {0.9F, 0.5F, 0.1F}},
	                                         {"Purple", {0.6F, 0.2F, 0.7F}},   {"Turquoise", {0.1F, 0.8F, 0.8F}},
	                                         {"Wood", {0.6F, 0.45F, 0.3F}},    {"PaintedWall", {0.85F, 0.8F, 0.7F}}};
	for (const Named& named : known)
		if (script.find(named.word) != std::string::npos) return named.color;
	return {0.7F, 0.7F, 0.7F};
}
}  // namespace

std::vector<Piece> piecesOf(const XmlNode& geometry, const std::filesystem::path& file, Resources& resources,
                            MeshLibrary& meshes)
{
	std::vector<Piece> pieces;
	if (geometry.child("polyline") != nullptr) pieces.push_back({polylineMesh(geometry), {}});
	for (const XmlNode& shape : geometry.children)
	{
		if (shape.name == "empty" || shape.name == "polyline") continue;
		if (shape.name != "mesh")
		{
			pieces.push_back({simpleShape(shape), {}});
			continue;
		}
		for (Piece& piece : meshPieces(shape, file, resources, meshes)) pieces.push_back(std::move(piece));
	}
	return pieces;
}

Material lookOf(const XmlNode& visual)
{
	Material look;
	look.name = visual.textAt("material/script/name");
	look.color = colorOfScript(look.name);
	if (const XmlNode* diffuse = visual.descendant("material/diffuse"))
		if (const auto rgba = numbersIn(diffuse->text); rgba && rgba->size() >= 3)
			look.color = Eigen::Vector3d((*rgba)[0], (*rgba)[1], (*rgba)[2]).cwiseMax(0).cwiseMin(1).cast<float>();
	const std::string name = visual.attribute("name");
	if (surfaceOf(look.name) == Surface::matte && surfaceOf(name) != Surface::matte) look.name = name;
	look.surface = surfaceOf(look.name);
	return look;
}

void scale(TriangleMesh& mesh, const Eigen::Vector3d& factor)
{
	for (Eigen::Vector3f& vertex : mesh.vertices) vertex = vertex.cwiseProduct(factor.cast<float>());
	if (factor.prod() < 0)
		for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
}
}  // namespace explore::simulation
