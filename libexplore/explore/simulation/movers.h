// People and things on their tracks, which wait for a robot that is in their way.
#pragma once

#include <explore/simulation/world.h>

#include <vector>

namespace explore::simulation
{
/** What stands in the way of the movers: a robot's body on the floor plan. */
struct RobotFootprint
{
	Eigen::Vector2d position_in_map = Eigen::Vector2d::Zero();
	double radius_m = 0;
};

class Movers
{
public:
	/** Each begins at time 0 of its track. `world` outlives it. */
	explicit Movers(const World& world);

	/** Moves each by `dt_s` along its track. One that would come nearer than its gap_m to the robot waits where it is;
	 *  after five seconds it turns round and walks back. */
	void advance(double dt_s, const RobotFootprint& robot);
	[[nodiscard]] bool empty() const { return m_movers.empty(); }
	/** map_from_body in the order of World::moving, for RayScene::place. */
	[[nodiscard]] std::vector<Eigen::Isometry3d> placement() const;
	/** Writes or reads what advance() changes. */
	template <class Archive>
	void exchange(Archive& archive)
	{
		for (Mover& mover : m_movers) archive(mover.t_s), archive(mover.direction), archive(mover.waited_s);
	}

private:
	struct Mover
	{
		const MovingBody* body = nullptr;
		double t_s = 0;        ///< on its track
		double direction = 1;  ///< −1: on the way back
		double waited_s = 0;
	};
	static double laterOn(const Mover& mover, double dt_s);
	std::vector<Mover> m_movers;
};

/** The place on the track at that time: on a line between the waypoints around it, the first or the last beyond them.
 *  The track has at least one waypoint. */
Waypoint placeAt(const std::vector<Waypoint>& track, double t_s);
}  // namespace explore::simulation
