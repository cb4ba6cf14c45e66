#include <explore/sinks/exploration_summary.h>

#include <algorithm>

namespace explore
{
namespace
{
std::vector<DoorSummary> doorsOf(const DoorTracks& tracks)
{
	std::vector<DoorSummary> doors;
	for (const DoorTrack& track : tracks.tracks)
	{
		if (!track.existence.confirmed) continue;
		const Door door = doorOf(track, Eigen::Isometry3d::Identity());
		doors.push_back({track.number, door.center, door.width_m, door.height_m, door.verdict, confidenceOf(track),
		                 track.existence.hits, track.visited});
	}
	return doors;
}

std::vector<CorridorSummary> corridorsOf(const CorridorTracks& tracks)
{
	std::vector<CorridorSummary> corridors;
	for (const CorridorTrack& track : tracks.tracks)
	{
		if (!track.existence.confirmed) continue;
		const Eigen::Vector2d point = track.point_in_map, direction = track.direction();
		corridors.push_back({track.number,
		                     {point.x(), point.y(), track.point_height_m},
		                     {direction.x(), direction.y(), 0.0},
		                     track.existence.hits});
	}
	return corridors;
}
}  // namespace

double knownFreeArea(const FrontierMemory& memory)
{
	const BodyLayers& layers = memory.layers;
	const LayerFrame& frame = layers.frame();
	const auto end =
	    layers.cells().begin() + static_cast<std::ptrdiff_t>(std::min(frame.cellsInLayer(), layers.cells().size()));
	const auto free = std::count(layers.cells().begin(), end, CellState::free);
	return static_cast<double>(free) * frame.resolution_m * frame.resolution_m;
}

std::size_t confirmedDoors(const FrontierMemory& memory)
{
	return static_cast<std::size_t>(
	    std::ranges::count_if(memory.doors.tracks, [](const DoorTrack& track) { return track.existence.confirmed; }));
}

ExplorationSummary explorationSummary(const ExplorerState& state)
{
	ExplorationSummary summary;
	if (!state.memory) return summary;
	const Mission& mission = state.mission;
	summary.finished = mission.phase == MissionPhase::done;
	summary.complete = mission.home_reached && mission.end == MissionEnd::nothing_left;
	summary.end = nameOf(mission.end);
	summary.known_free_m2 = knownFreeArea(*state.memory);
	if (mission.map_from_home && mission.robot_in_map)
		summary.home_error_m = (*mission.robot_in_map - mission.map_from_home->translation()).head<2>().norm();
	summary.doors = doorsOf(state.memory->doors);
	summary.corridors = corridorsOf(state.memory->corridors);
	summary.left_over = mission.left_over;
	return summary;
}
}  // namespace explore
