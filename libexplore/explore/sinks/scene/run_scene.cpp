#include <explore/sinks/output_file.h>
#include <explore/sinks/scene/run_scene.h>
#include <explore/sinks/scene/shapes.h>
#include <mrpt/core/format.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/opengl/CGridPlaneXY.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace explore
{
namespace
{
using mrpt::opengl::COctoMapVoxels;
using mrpt::opengl::CSetOfObjects;

template <class Object>
std::shared_ptr<Object> named(std::shared_ptr<Object> object, const std::string& name)
{
	object->setName(name);
	return object;
}

/** Calls `take(leaf)` for what is occupied and not above the cut, in voxels of the tree's level `depth` or larger. */
template <class Take>
void forEachOccupied(const octomap::OcTree& map, unsigned depth, double highest_z_m, const Take& take)
{
	const auto end = map.end_leafs();
	for (auto leaf = map.begin_leafs(static_cast<unsigned char>(depth)); leaf != end; ++leaf)
		if (map.isNodeOccupied(*leaf) && leaf.getZ() - 0.5 * leaf.getSize() < highest_z_m) take(leaf);
}

unsigned finestDepth(const octomap::OcTree& map, double highest_z_m, std::size_t most)
{
	unsigned depth = map.getTreeDepth();
	for (; depth > 1; --depth)
	{
		std::size_t count = 0;
		forEachOccupied(map, depth, highest_z_m, [&](const auto&) { ++count; });
		if (count <= most) break;
	}
	return depth;
}

COctoMapVoxels::Ptr mapObject(const octomap::OcTree& map, const RunSceneConfig& config)
{
	const double highest_z_m = config.floor_z_m + config.cut_m;
	auto object = COctoMapVoxels::Create();
	object->resizeVoxelSets(1);
	object->enableCubeTransparency(false);
	object->enableLights(true);
	mrpt::math::TBoundingBox box = mrpt::math::TBoundingBox::PlusMinusInfinity();
	forEachOccupied(map, finestDepth(map, highest_z_m, config.most_voxels), highest_z_m,
	                [&](const auto& leaf)
	                {
		                const mrpt::math::TPoint3D at(leaf.getX(), leaf.getY(), leaf.getZ());
		                box.updateWithPoint(at);
		                object->push_back_Voxel(
		                    mrpt::opengl::VOXEL_SET_OCCUPIED,
		                    {mrpt::math::TPoint3Df(at), leaf.getSize(), style::heightColor(at.z - config.floor_z_m)});
	                });
	if (object->getVoxelCount(mrpt::opengl::VOXEL_SET_OCCUPIED) > 0) object->setBoundingBox(box.min, box.max);
	return object;
}

/** A line a metre, over what is known of the floor and a metre more. */
mrpt::opengl::CGridPlaneXY::Ptr gridObject(const FrontierMemory* memory, double z_m)
{
	constexpr double kAlone_m = 6.0;
	Eigen::Vector2d low(-kAlone_m, -kAlone_m), high(kAlone_m, kAlone_m);
	if (memory != nullptr && memory->layers.frame().cellsInLayer() > 0)
	{
		const LayerFrame& frame = memory->layers.frame();
		low = frame.corner_in_map;
		high = low + frame.resolution_m * Eigen::Vector2d(frame.columns, frame.rows);
	}
	const auto down = [](double m) { return static_cast<float>(std::floor(m) - 1.0); };
	const auto up = [](double m) { return static_cast<float>(std::ceil(m) + 1.0); };
	auto grid = mrpt::opengl::CGridPlaneXY::Create(down(low.x()), up(high.x()), down(low.y()), up(high.y()),
	                                               static_cast<float>(z_m), 1.0F);
	grid->setColor_u8(style::kFaint);
	return grid;
}

CSetOfObjects::Ptr doorsObject(const DoorTracks& tracks)
{
	auto objects = CSetOfObjects::Create();
	for (const DoorTrack& track : tracks.tracks)
	{
		if (!track.existence.confirmed) continue;
		const Door door = doorOf(track, Eigen::Isometry3d::Identity());
		Ground floor;
		floor.plane = planeThrough({0, 0, track.place.floor_m}, Eigen::Vector3d::UnitZ());
		const std::string label = mrpt::format("%d: ", track.number) + doorLabel(door);
		const DoorMark mark{doorCorners(door, floor), door.normal, style::verdictColor(door.verdict), label};
		objects->insert(named(scene::opening(mark, door.verdict), "door." + std::to_string(track.number)));
	}
	return objects;
}

/** Its axis on the floor as far as it was seen, with an arrow's head at either end. */
CSetOfObjects::Ptr corridorsObject(const CorridorTracks& tracks, double z_m)
{
	auto objects = CSetOfObjects::Create();
	for (const CorridorTrack& track : tracks.tracks)
	{
		if (!track.existence.confirmed) continue;
		const auto at = [&](double along_m) -> Eigen::Vector3d {
			return {track.at(along_m).x(), track.at(along_m).y(), z_m};
		};
		const double middle_m = 0.5 * (track.from_m + track.to_m);
		auto one = named(CSetOfObjects::Create(), "corridor." + std::to_string(track.number));
		for (const double end_m : {track.from_m, track.to_m})
			one->insert(scene::arrow({at(middle_m), at(end_m)}, style::kVanishingPoint, 0.04));
		one->insert(scene::label(mrpt::format("corridor %d", track.number), at(middle_m) + Eigen::Vector3d(0, 0, 0.3),
		                         style::kVanishingPoint));
		objects->insert(one);
	}
	return objects;
}

mrpt::opengl::CRenderizable::Ptr frontiersObject(const FrontierMemory& memory, double z_m)
{
	const LayerFrame& frame = memory.layers.frame();
	const double half_m = 0.5 * frame.resolution_m;
	std::vector<scene::Stretch> dashes;
	for (const FrontierCluster& cluster : memory.frontiers.clusters())
		for (const std::size_t cell : cluster.cells)
		{
			const Eigen::Vector2d centre = frame.centreOf(cell);
			dashes.push_back({{centre.x() - half_m, centre.y(), z_m}, {centre.x() + half_m, centre.y(), z_m}});
			dashes.push_back({{centre.x(), centre.y() - half_m, z_m}, {centre.x(), centre.y() + half_m, z_m}});
		}
	return scene::stretches(dashes, style::kFrontier, 3.0);
}

CSetOfObjects::Ptr leftOverObject(const std::vector<LeftOver>& left_over)
{
	constexpr double kRing_m = 0.15;
	auto objects = CSetOfObjects::Create();
	for (std::size_t i = 0; i < left_over.size(); ++i)
	{
		const LeftOver& place = left_over[i];
		auto one = named(CSetOfObjects::Create(), "left_over." + std::to_string(i));
		one->insert(scene::ring(place.center_in_map, kRing_m, style::kFrontier));
		std::string text(nameOf(place.why));
		if (place.area_m2 >= 0.1) text += mrpt::format(" %.1f m2", place.area_m2);
		one->insert(scene::label(text, place.center_in_map + Eigen::Vector3d(0, 0, 0.3), style::kFrontier));
		objects->insert(one);
	}
	return objects;
}

CSetOfObjects::Ptr homeObject(const Eigen::Vector3d& place)
{
	constexpr double kRing_m = 0.3;
	auto home = CSetOfObjects::Create();
	home->insert(scene::ring(place, kRing_m, style::kChosen));
	home->insert(scene::label("home", place + Eigen::Vector3d(0, 0, 0.2), style::kChosen));
	return home;
}

std::vector<Eigen::Vector3d> thinned(const std::vector<Eigen::Vector3d>& points, std::size_t most)
{
	const std::size_t step = points.size() / most + 1;
	std::vector<Eigen::Vector3d> kept;
	for (std::size_t i = 0; i + 1 < points.size(); i += step) kept.push_back(points[i]);
	if (!points.empty()) kept.push_back(points.back());
	return kept;
}

/** So far apart that bars between them are not all joints. */
std::vector<Eigen::Vector3d> spaced(const std::vector<Eigen::Vector3d>& points, double least_m)
{
	std::vector<Eigen::Vector3d> kept;
	for (const Eigen::Vector3d& point : points)
		if (kept.empty() || (point - kept.back()).norm() >= least_m) kept.push_back(point);
	if (!points.empty() && kept.back() != points.back()) kept.push_back(points.back());
	return kept;
}

void addPath(mrpt::opengl::COpenGLScene& scene, std::vector<Eigen::Vector3d> places, double lift_m)
{
	constexpr double kBar_m = 0.05, kSpacing_m = 0.15;
	for (Eigen::Vector3d& place : places) place.z() += lift_m;
	scene.insert(named(scene::polyline(places, style::kChosen, 3.0), "path"));
	scene.insert(named(scene::bars(spaced(places, kSpacing_m), style::kChosen, kBar_m), "path.bars"));
}
}  // namespace

mrpt::opengl::COpenGLScene runScene(const RunSceneParts& parts, const RunSceneConfig& config)
{
	// What lies on the floor is drawn on top of its voxels.
	const double on_floor_m = config.floor_z_m + (parts.map != nullptr ? parts.map->getResolution() : 0.0) + 0.01;
	mrpt::opengl::COpenGLScene scene;
	scene.insert(named(gridObject(parts.memory, on_floor_m), "grid"));
	if (parts.map != nullptr) scene.insert(named(mapObject(*parts.map, config), "map"));
	if (parts.memory != nullptr)
	{
		scene.insert(named(doorsObject(parts.memory->doors), "doors"));
		scene.insert(named(corridorsObject(parts.memory->corridors, on_floor_m + 0.02), "corridors"));
		scene.insert(named(frontiersObject(*parts.memory, on_floor_m + 0.01), "frontiers"));
	}
	if (parts.mission != nullptr)
	{
		const auto& path = parts.path_in_map.empty() ? parts.mission->trail_in_map : parts.path_in_map;
		addPath(scene, thinned(path, config.most_path_points), on_floor_m - config.floor_z_m + 0.03);
		scene.insert(named(leftOverObject(parts.mission->left_over), "left_over"));
		if (const auto& home = parts.mission->map_from_home)
			scene.insert(named(homeObject(home->translation() + Eigen::Vector3d(0, 0, on_floor_m)), "home"));
	}
	if (parts.last != nullptr)
	{
		auto last = named(parts.memory != nullptr ? directionObjects(*parts.last, config.robot)
		                                          : frameObjects(*parts.last, config.robot),
		                  "last_frame");
		if (parts.memory != nullptr) last->setPose(parts.last->map_from_robot);
		scene.insert(last);
	}
	return scene;
}

void writeScene(const mrpt::opengl::COpenGLScene& scene, const std::filesystem::path& path)
{
	mrpt::io::CMemoryStream bytes;
	mrpt::serialization::archiveFrom(bytes).WriteObject(scene);
	writeFileAtomically(path, {static_cast<const char*>(bytes.getRawBufferData()), bytes.getTotalBytesCount()});
}

std::vector<Eigen::Vector3d> placesOfTrajectory(const std::filesystem::path& path)
{
	std::ifstream file(path);
	std::vector<Eigen::Vector3d> places;
	for (std::string line; std::getline(file, line);)
	{
		std::istringstream numbers(line);
		double time = 0;
		Eigen::Vector3d place;
		if (numbers >> time >> place.x() >> place.y() >> place.z()) places.push_back(place);
	}
	return places;
}
}  // namespace explore
