// Draws robot poses in the free space of a labelled world, most of them with a door before them: independent views for
// explore-rawlog record --poses.
#include "support/building_sketch.h"

#include <explore/simulation/load_world.h>
#include <explore/simulation/ray_scene.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <numbers>
#include <sstream>

namespace explore::test
{
namespace
{
using namespace simulation;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDegree_rad = std::numbers::pi / 180;
constexpr double kCell_m = 0.10;
constexpr double kApart_m = 0.5;         ///< from every surface
constexpr double kThin_m = 0.15;         ///< of the body that finds its way from the spawns
constexpr double kScene_s = 20;          ///< between poses
constexpr double kDoorShare = 0.65;      ///< of the poses that look at a door
constexpr double kCorridorShare = 0.12;  ///< along a corridor

/** Floor cells that can be reached from the spawns on level floor. */
class FreeFloor
{
public:
	explicit FreeFloor(const RayScene& scene) : m_scene(scene)
	{
		for (const Spawn& spawn : scene.world().spawns) spread(spawn.position_in_map.head<2>());
		for (const auto& [cell, reached] : m_cells)
			if (reached) m_reached.push_back(cell);
	}
	[[nodiscard]] bool empty() const { return m_reached.empty(); }
	[[nodiscard]] bool reached(const Vector2d& at) const
	{
		const auto found = m_cells.find(cellOf(at));
		return found != m_cells.end() && found->second;
	}
	[[nodiscard]] Vector2d draw(Dice& dice) const
	{
		const auto [column, row] =
		    m_reached[static_cast<std::size_t>(dice.whole(0, static_cast<int>(m_reached.size()) - 1))];
		return Vector2d(column + dice.between(-0.5, 0.5), row + dice.between(-0.5, 0.5)) * kCell_m;
	}

private:
	using Cell = std::pair<int, int>;

	static Cell cellOf(const Vector2d& at)
	{
		return {static_cast<int>(std::lround(at.x() / kCell_m)), static_cast<int>(std::lround(at.y() / kCell_m))};
	}
	[[nodiscard]] bool isFree(const Cell& cell) const
	{
		const Vector3d at(cell.first * kCell_m, cell.second * kCell_m, 0);
		const auto floor = m_scene.cast(at + Vector3d(0, 0, 0.3), -Vector3d::UnitZ(), 0.35);
		return floor && floor->distance > 0.26 && !m_scene.touchesCylinder(at + Vector3d(0, 0, 0.05), kThin_m, 1.2);
	}
	/** Whether the cell was not looked at before and is free. */
	bool visit(const Cell& cell)
	{
		const auto [entry, fresh] = m_cells.try_emplace(cell, false);
		if (fresh) entry->second = isFree(cell);
		return fresh && entry->second;
	}
	void spread(const Vector2d& from)
	{
		std::deque<Cell> open;
		const Cell start = cellOf(from);
		// Furniture may stand in the middle of the room.
		for (int reach = 0; reach < 12 && open.empty(); ++reach)
			for (int i = -reach; i <= reach && open.empty(); ++i)
				for (int k = -reach; k <= reach && open.empty(); ++k)
				{
					const Cell cell(start.first + i, start.second + k);
					const auto known = m_cells.find(cell);
					if (known != m_cells.end() && known->second) return;  // another spawn has been here
					if (visit(cell)) open.push_back(cell);
				}
		while (!open.empty())
		{
			const Cell cell = open.front();
			open.pop_front();
			for (const auto& [dx, dy] : {Cell(1, 0), Cell(-1, 0), Cell(0, 1), Cell(0, -1)})
				if (const Cell next(cell.first + dx, cell.second + dy); visit(next)) open.push_back(next);
		}
	}

	const RayScene& m_scene;
	std::map<Cell, bool> m_cells;
	std::vector<Cell> m_reached;
};

struct SampledPose
{
	Vector3d position;
	double yaw_rad = 0, pitch_rad = 0, roll_rad = 0;
};

struct SampleOptions
{
	bool mav = false;
	int count = 60;
	double camera_m = 0.5;  ///< height of a ground robot's camera
	double door_share = kDoorShare;
	Eigen::AlignedBox2d within{Vector2d(-1e6, -1e6), Vector2d(1e6, 1e6)};
};

class Sampler
{
public:
	Sampler(const RayScene& scene, const SampleOptions& options, std::uint64_t seed)
	    : m_scene(scene), m_options(options), m_dice(seed), m_floor(scene)
	{
		if (m_floor.empty()) throw std::runtime_error("no free floor around the world's spawns");
		for (const CorridorLabel& corridor : scene.world().corridors)
			if ((corridor.end_in_map - corridor.start_in_map).norm() > 3 * corridor.width_m)
				m_corridors.push_back(&corridor);
	}

	std::vector<SampledPose> run()
	{
		constexpr int kTrials = 4000;
		std::vector<SampledPose> poses;
		for (int i = 0; i < m_options.count; ++i)
		{
			const Aim aim = drawAim();
			for (int trial = 0; trial < kTrials; ++trial)
				if (const auto pose = draw(aim))
				{
					poses.push_back(*pose);
					break;
				}
		}
		return poses;
	}

private:
	/** What a pose is there to show. */
	enum class Aim
	{
		door,
		corridor,
		anything
	};

	[[nodiscard]] Aim drawAim()
	{
		const World& world = m_scene.world();
		const double choice = m_dice.between(0, 1);
		if (choice < m_options.door_share) return world.doors.empty() ? Aim::anything : Aim::door;
		return choice < m_options.door_share + kCorridorShare && !m_corridors.empty() ? Aim::corridor : Aim::anything;
	}

	[[nodiscard]] std::optional<SampledPose> draw(Aim aim)
	{
		const std::optional<View> view = aim == Aim::door       ? doorView()
		                                 : aim == Aim::corridor ? corridorView()
		                                                        : View{m_floor.draw(m_dice), anyAngle()};
		if (!view || !m_options.within.contains(view->at) || !m_floor.reached(view->at)) return std::nullopt;
		SampledPose pose;
		pose.position = {view->at.x(), view->at.y(), m_options.mav ? m_dice.between(0.7, 1.8) : floorAt(view->at)};
		const double eye_m = pose.position.z() + (m_options.mav ? 0.0 : m_options.camera_m);
		if (!clear(view->at, eye_m)) return std::nullopt;
		if (aim == Aim::door && !m_scene.world().doors.empty() && !sees({view->at.x(), view->at.y(), eye_m}, *m_door))
			return std::nullopt;
		const double tilt = (m_options.mav ? 15 : 1) * kDegree_rad;
		pose.yaw_rad = view->yaw_rad;
		pose.pitch_rad = m_dice.between(-tilt, tilt);
		pose.roll_rad = m_dice.between(-tilt, tilt);
		return pose;
	}

	/** 0, but where the world's floor is another one. */
	[[nodiscard]] double floorAt(const Vector2d& at) const
	{
		constexpr double kFrom_m = 0.3, kCarpet_m = 0.015;
		const auto floor = m_scene.cast({at.x(), at.y(), kFrom_m}, -Vector3d::UnitZ(), 1);
		const double height_m = floor ? kFrom_m - floor->distance : 0.0;
		return std::abs(height_m) > kCarpet_m ? height_m : 0.0;
	}

	/** Room for the robot, and nothing within kApart_m of its camera at the height of its eye. */
	[[nodiscard]] bool clear(const Vector2d& at, double eye_m) const
	{
		const double low = m_options.mav ? eye_m - 0.3 : eye_m - m_options.camera_m + 0.05,
		             high = std::max(eye_m + 0.15, m_options.mav ? 0.0 : 0.7);
		return !m_scene.touchesCylinder({at.x(), at.y(), low}, kApart_m, high - low);
	}

	struct View
	{
		Vector2d at;
		double yaw_rad = 0;
	};

	[[nodiscard]] double anyAngle() { return m_dice.between(-std::numbers::pi, std::numbers::pi); }

	/** From 1.2–5.2 m before a door, up to 75° off its normal; the door is up to 20° off the image's middle. */
	[[nodiscard]] std::optional<View> doorView()
	{
		m_door = &m_dice.oneOf(m_scene.world().doors);
		const Vector2d normal = m_door->normal_in_map.head<2>();
		const double off = std::atan2(normal.y(), normal.x()) + m_dice.between(-75, 75) * kDegree_rad +
		                   (m_dice.chance(0.5) ? std::numbers::pi : 0);
		const Vector2d away(std::cos(off), std::sin(off));
		return View{m_door->floor_center_in_map.head<2>() + m_dice.between(1.2, 5.2) * away,
		            std::atan2(-away.y(), -away.x()) + m_dice.between(-20, 20) * kDegree_rad};
	}

	/** Somewhere in a long corridor, along it. */
	[[nodiscard]] std::optional<View> corridorView()
	{
		const CorridorLabel& corridor = *m_dice.oneOf(m_corridors);
		const Vector2d axis = corridor.end_in_map - corridor.start_in_map, left(-axis.y(), axis.x());
		const double half = 0.5 * corridor.width_m / axis.norm();
		return View{corridor.start_in_map + m_dice.between(0, 1) * axis + m_dice.between(-half, half) * left,
		            std::atan2(axis.y(), axis.x()) + (m_dice.chance(0.5) ? std::numbers::pi : 0) +
		                m_dice.between(-20, 20) * kDegree_rad};
	}

	/** Whether the middle of the opening, before the wall's near face, is in the line of sight. */
	[[nodiscard]] bool sees(const Vector3d& eye, const DoorLabel& door) const
	{
		const Vector2d normal = door.normal_in_map.head<2>().normalized();
		const double side = (eye - door.floor_center_in_map).head<2>().dot(normal);
		const Vector2d before = std::copysign(0.5 * door.depth_m + 0.03, side) * normal;
		return !m_scene.occluded(eye, door.floor_center_in_map + Vector3d(before.x(), before.y(), 1.2), 0.02);
	}

	const RayScene& m_scene;
	SampleOptions m_options;
	Dice m_dice;
	FreeFloor m_floor;
	std::vector<const CorridorLabel*> m_corridors;  ///< long ones
	const DoorLabel* m_door = nullptr;              ///< that the view being drawn is of
};

void writeTum(const std::vector<SampledPose>& poses, const std::filesystem::path& path)
{
	std::ofstream file(path, std::ios::binary);
	file << "# t x y z qx qy qz qw\n" << std::setprecision(9);
	double t_s = 1'600'000'000;
	for (const SampledPose& pose : poses)
	{
		const Eigen::Quaterniond turn = Eigen::AngleAxisd(pose.yaw_rad, Vector3d::UnitZ()) *
		                                Eigen::AngleAxisd(pose.pitch_rad, Vector3d::UnitY()) *
		                                Eigen::AngleAxisd(pose.roll_rad, Vector3d::UnitX());
		file << std::setprecision(12) << t_s << std::setprecision(9) << ' ' << pose.position.x() << ' '
		     << pose.position.y() << ' ' << pose.position.z() << ' ' << turn.x() << ' ' << turn.y() << ' ' << turn.z()
		     << ' ' << turn.w() << '\n';
		t_s += kScene_s;
	}
	if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

int run(std::map<std::string, std::string> options)
{
	WorldPaths paths = usualWorldPaths();
	paths.labels_file = options["--labels"];
	const World world = loadWorld(options.at("--world"), paths);
	const RayScene scene(world);
	SampleOptions wanted;
	wanted.mav = options["--robot"] == "mav";
	if (!options["--count"].empty()) wanted.count = std::stoi(options["--count"]);
	if (!options["--camera"].empty()) wanted.camera_m = std::stod(options["--camera"]);
	if (!options["--doors"].empty()) wanted.door_share = std::stod(options["--doors"]);
	if (std::istringstream area(options["--within"]); !options["--within"].empty())
		area >> wanted.within.min().x() >> wanted.within.min().y() >> wanted.within.max().x() >>
		    wanted.within.max().y();
	const std::string seed = options["--seed"].empty() ? "1" : options["--seed"];
	const std::vector<SampledPose> poses = Sampler(scene, wanted, std::stoull(seed)).run();
	writeTum(poses, options.at("--out"));
	std::cout << options.at("--out") << ": " << poses.size() << " poses\n";
	return poses.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
try
{
	std::map<std::string, std::string> options;
	for (int i = 1; i + 1 < argc; i += 2) options[argv[i]] = argv[i + 1];
	if (argc % 2 == 0 || !options.contains("--world") || !options.contains("--out"))
	{
		std::cerr << "usage: sample_poses --world F.sdf --out P.tum [--labels F.doors.json] [--robot ground|mav]\n"
		             "       [--camera HEIGHT] [--count N] [--doors SHARE] [--within 'X0 Y0 X1 Y1'] [--seed S]\n";
		return EXIT_FAILURE;
	}
	return explore::test::run(options);
}
catch (const std::exception& error)
{
	std::cerr << "sample_poses: " << error.what() << '\n';
	return EXIT_FAILURE;
}
