#include <explore/config/fields.h>

#include <array>

namespace explore
{
void describe(FieldVisitor& fields, RobotConfig& robot)
{
	static constexpr std::array<std::string_view, 2> kKinds{"ground", "mav"};

	fields.section("robot", "The robot's body and what its drive can do.");
	fields.choice(
	    "kind", robot.kind, kKinds,
	    "ground: drives on the floor. mav: flies, chooses an elevation as well as an azimuth; explore-mrpt then "
	    "takes radius 0.3, height 0.25 and max_speed 0.8 for keys that are left out.");
	fields.real("radius", robot.radius_m, {0.02, 5.0}, "m",
	            "Radius of the circle around the turning centre that holds the whole body.");
	fields.real("height", robot.height_m, {0.02, 5.0}, "m",
	            "ground: top of the body above the floor. mav: height of the body itself.");
	fields.real("max_speed", robot.max_speed_mps, {0.01, 20.0}, "m/s", "Greatest speed that is ever commanded.");
	fields.real("max_acceleration", robot.max_acceleration_mps2, {0.01, 50.0}, "m/s^2",
	            "Braking that the robot surely reaches: it sets the stopping distance.");
	fields.degreesPerSecond("max_yaw_rate_deg", robot.max_yaw_rate_radps, {1.0, 720.0},
	                        "Greatest turning rate that is ever commanded.");
	fields.real("min_altitude", robot.min_altitude_m, {0.0, 50.0}, "m",
	            "mav only: lowest height of the body's centre above the floor.");
	fields.real("max_altitude", robot.max_altitude_m, {0.1, 50.0}, "m",
	            "mav only: greatest height of the body's centre above the floor.");
}
}  // namespace explore
