// scene.3Dscene: what a run knows of the building in the end, to be walked around in.
#pragma once

#include <explore/navigation/mission.h>
#include <explore/sinks/scene/frame_sketch.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <octomap/OcTree.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore
{
struct RunSceneConfig
{
	RobotConfig robot;
	double floor_z_m = 0.0;            ///< in the map
	double cut_m = 1.5;                ///< above the floor: what is higher is left out, so that one looks into rooms
	std::size_t most_voxels = 150000;  ///< with more, the map is drawn with larger ones
	std::size_t most_path_points = 50000;
};

/** What there is to be drawn; it outlives the scene's making. */
struct RunSceneParts
{
	const octomap::OcTree* map = nullptr;
	const FrontierMemory* memory = nullptr;  ///< of the same map; null: the last frame is all there is
	const Mission* mission = nullptr;
	std::vector<Eigen::Vector3d> path_in_map;  ///< of the robot; empty = the mission's trail, which leaves places out
	const FrameSketch* last = nullptr;         ///< the last frame; null: none
};

/** Objects of the map, map frame: `map`, `grid`, `path` with `path.bars`, `home`, `doors` with `door.N` and `corridors`
 * with `corridor.N` (N = track; confirmed ones), `frontiers`, `left_over` with `left_over.N` (N from 0, as in
 * summary.json), and `last_frame` with directionObjects(). Without a memory: `grid` and `last_frame` with
 * frameObjects() at the origin. */
mrpt::opengl::COpenGLScene runScene(const RunSceneParts& parts, const RunSceneConfig& config);

/** As SceneViewer3D opens it, without compression. Puts the file into place in one step; throws OutputError. */
void writeScene(const mrpt::opengl::COpenGLScene& scene, const std::filesystem::path& path);

/** The places in a file that trajectoryLine() wrote; lines that are none are passed over. */
std::vector<Eigen::Vector3d> placesOfTrajectory(const std::filesystem::path& path);
}  // namespace explore
