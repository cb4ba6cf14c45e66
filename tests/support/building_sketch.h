// Collects the shapes and labels of a made-up building and writes them as a Gazebo world with its door labels.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace explore::test
{

/** Numbers that are the same with every compiler: xorshift64* after Marsaglia and Vigna. */
class Dice
{
public:
	explicit Dice(std::uint64_t seed);
	double between(double low, double high);
	/** Both ends included. */
	int whole(int low, int high);
	bool chance(double share) { return between(0, 1) < share; }
	template <class Things>
	const auto& oneOf(const Things& things)
	{
		return *(std::begin(things) + whole(0, static_cast<int>(std::size(things)) - 1));
	}

private:
	std::uint64_t m_state;
};

/** A frame on the floor plan: local x runs along `yaw_rad`. */
struct Place
{
	Eigen::Vector2d origin = Eigen::Vector2d::Zero();
	double yaw_rad = 0;

	[[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& local) const;
	/** The frame whose origin is `local`, turned further. */
	[[nodiscard]] Place then(const Eigen::Vector2d& local, double turn_rad = 0) const;
};

enum class Look
{
	wall,
	floor,
	ceiling,
	wood,
	white,
	metal,
	fabric,
	skin,
	leaves,
	cardboard,
	glass,
	mirror,
	black
};

/** What the world's author knows of an opening; doc/worlds.md, "door". */
struct PlannedDoor
{
	std::string id;
	Place place;  ///< origin: the middle of the opening; x along the wall
	double width_m = 0;
	std::optional<double> height_m;
	double depth_m = 0;
	std::string verdict = "open";
	double clear_width_m = 0, sill_m = 0;
};

struct PlannedCorridor
{
	Eigen::Vector2d from, to;
	double width_m = 0;
};

struct PlannedObstacle
{
	std::string kind;
	Eigen::Vector2d at;
	double radius_m = 0, height_m = 0;
};

class Sketch
{
public:
	/** Turns the finished world by this angle about the plan's origin. */
	double turn_rad = 0;
	std::vector<PlannedDoor> doors;
	std::vector<PlannedCorridor> corridors;
	std::vector<PlannedObstacle> obstacles;
	std::vector<Eigen::Vector2d> spawns;  ///< one a room

	/** `middle` and `size` in the axes of `place`; turned by `yaw_rad`, then leaned about its own y. */
	void box(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle,
	         const Eigen::Vector3d& size, double yaw_rad = 0, double lean_rad = 0);
	/** A box from corner to corner; nothing where it has no volume. */
	void block(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& low,
	           const Eigen::Vector3d& high);
	void cylinder(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle,
	              double radius_m, double length_m);
	void sphere(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle, double radius_m);
	void capsule(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle, double radius_m,
	             double length_m);

	[[nodiscard]] std::size_t shapes() const { return m_visuals.size(); }
	/** building.sdf and building.doors.json in `folder`. Throws std::runtime_error. */
	void write(const std::filesystem::path& folder) const;
	/** The point of the plan in the finished world. */
	[[nodiscard]] Eigen::Vector2d inMap(const Eigen::Vector2d& point) const;

private:
	void add(const std::string& name, Look look, const std::string& pose, const std::string& geometry);

	std::vector<std::string> m_visuals;
};
}  // namespace explore::test
