#include "support/building_sketch.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace explore::test
{
namespace
{
struct Paint
{
	const char* word;  ///< in the visual's name; tells the surface
	std::array<double, 3> color;
};

const Paint& paintOf(Look look)
{
	static constexpr std::array<Paint, 13> kPaints{{{"plaster", {0.86, 0.84, 0.78}},
	                                                {"floor", {0.45, 0.43, 0.40}},
	                                                {"ceiling", {0.92, 0.92, 0.92}},
	                                                {"wood", {0.60, 0.44, 0.28}},
	                                                {"white", {0.90, 0.90, 0.90}},
	                                                {"metal", {0.55, 0.57, 0.60}},
	                                                {"fabric", {0.35, 0.40, 0.55}},
	                                                {"skin", {0.75, 0.55, 0.45}},
	                                                {"plant", {0.25, 0.45, 0.22}},
	                                                {"cardboard", {0.65, 0.52, 0.36}},
	                                                {"glass", {0.70, 0.80, 0.80}},
	                                                {"mirror", {0.80, 0.80, 0.80}},
	                                                {"black", {0.03, 0.03, 0.03}}}};
	return kPaints.at(static_cast<std::size_t>(look));
}

std::string numbers(std::initializer_list<double> values)
{
	std::ostringstream text;
	text << std::setprecision(9);
	const char* between = "";
	for (const double value : values)
	{
		text << between << (std::abs(value) < 1e-12 ? 0.0 : value);
		between = " ";
	}
	return text.str();
}

std::string poseText(const Place& place, const Eigen::Vector3d& middle, double yaw_rad = 0, double lean_rad = 0)
{
	const Eigen::Vector2d at = place.at(middle.head<2>());
	return numbers({at.x(), at.y(), middle.z(), 0, lean_rad, place.yaw_rad + yaw_rad});
}

std::string roundGeometry(const std::string& kind, double radius_m, double length_m)
{
	std::ostringstream text;
	text << '<' << kind << "><radius>" << numbers({radius_m}) << "</radius><length>" << numbers({length_m})
	     << "</length></" << kind << '>';
	return text.str();
}

void save(const std::filesystem::path& path, const std::string& text)
{
	std::ofstream file(path, std::ios::binary);
	file << text;
	if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

std::string commaed(std::string numbers_text)
{
	for (std::size_t i = 0; (i = numbers_text.find(' ', i)) != std::string::npos; i += 2)
		numbers_text.replace(i, 1, ", ");
	return numbers_text;
}
}  // namespace

Dice::Dice(std::uint64_t seed) : m_state(seed * 0x9E3779B97F4A7C15ULL + 0xD1B54A32D192ED03ULL)
{
	if (m_state == 0) m_state = 1;
	for (int i = 0; i < 8; ++i) between(0, 1);
}

double Dice::between(double low, double high)
{
	m_state ^= m_state >> 12U;
	m_state ^= m_state << 25U;
	m_state ^= m_state >> 27U;
	return low + (high - low) * static_cast<double>((m_state * 0x2545F4914F6CDD1DULL) >> 11U) * 0x1p-53;
}

int Dice::whole(int low, int high)
{
	return std::min(high, low + static_cast<int>(std::floor(between(0, high - low + 1))));
}

Eigen::Vector2d Place::at(const Eigen::Vector2d& local) const
{
	const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
	return origin + Eigen::Vector2d(c * local.x() - s * local.y(), s * local.x() + c * local.y());
}

Place Place::then(const Eigen::Vector2d& local, double turn_rad) const
{
	return {at(local), yaw_rad + turn_rad};
}

void Sketch::add(const std::string& name, Look look, const std::string& pose, const std::string& geometry)
{
	const Paint& paint = paintOf(look);
	const std::string color = numbers({paint.color[0], paint.color[1], paint.color[2], 1});
	std::ostringstream visual;
	visual << "        <visual name=\"" << name << '_' << paint.word << '_' << m_visuals.size() << "\"><pose>" << pose
	       << "</pose><geometry>" << geometry << "</geometry><material><ambient>" << color << "</ambient><diffuse>"
	       << color << "</diffuse></material></visual>\n";
	m_visuals.push_back(visual.str());
}

void Sketch::box(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle,
                 const Eigen::Vector3d& size, double yaw_rad, double lean_rad)
{
	add(name, look, poseText(place, middle, yaw_rad, lean_rad),
	    std::string("<box><size>").append(numbers({size.x(), size.y(), size.z()})).append("</size></box>"));
}

void Sketch::block(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& low,
                   const Eigen::Vector3d& high)
{
	constexpr double kThinnest_m = 1e-4;
	if ((high - low).minCoeff() > kThinnest_m) box(name, look, place, 0.5 * (low + high), high - low);
}

void Sketch::cylinder(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle,
                      double radius_m, double length_m)
{
	add(name, look, poseText(place, middle), roundGeometry("cylinder", radius_m, length_m));
}

void Sketch::sphere(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle,
                    double radius_m)
{
	add(name, look, poseText(place, middle),
	    std::string("<sphere><radius>").append(numbers({radius_m})).append("</radius></sphere>"));
}

void Sketch::capsule(const std::string& name, Look look, const Place& place, const Eigen::Vector3d& middle,
                     double radius_m, double length_m)
{
	add(name, look, poseText(place, middle), roundGeometry("capsule", radius_m, length_m));
}

Eigen::Vector2d Sketch::inMap(const Eigen::Vector2d& point) const
{
	return Place{Eigen::Vector2d::Zero(), turn_rad}.at(point);
}

void Sketch::write(const std::filesystem::path& folder) const
{
	std::ostringstream world;
	world << "<?xml version=\"1.0\"?>\n<sdf version=\"1.7\">\n  <world name=\"building\">\n    <light name=\"sun\" "
	         "type=\"directional\"><cast_shadows>false</cast_shadows><pose>0 0 10 0 0 0</pose><diffuse>0.9 0.9 0.9 "
	         "1</diffuse><specular>0.1 0.1 0.1 1</specular><direction>-0.4 0.3 -0.9</direction></light>\n    <model "
	         "name=\"building\">\n      <static>true</static>\n      <pose>"
	      << numbers({0, 0, 0, 0, 0, turn_rad}) << "</pose>\n      <link name=\"link\">\n";
	for (const std::string& visual : m_visuals) world << visual;
	world << "      </link>\n    </model>\n  </world>\n</sdf>\n";
	save(folder / "building.sdf", world.str());

	const auto place = [&](const Eigen::Vector2d& point)
	{
		const Eigen::Vector2d at = inMap(point);
		return std::string("[").append(commaed(numbers({at.x(), at.y()}))).append("]");
	};
	std::ostringstream labels;
	labels << std::setprecision(9) << "{\n  \"doors\": [";
	const char* between = "\n";
	for (const PlannedDoor& door : doors)
	{
		const double yaw_rad = std::remainder(door.place.yaw_rad + turn_rad + std::acos(-1.0) / 2, 2 * std::acos(-1.0));
		labels << between << "    {\"id\": \"" << door.id << "\", \"at\": " << place(door.place.origin)
		       << ", \"yaw\": " << yaw_rad << ", \"width\": " << door.width_m;
		if (door.height_m) labels << ", \"height\": " << *door.height_m;
		labels << ", \"depth\": " << door.depth_m << ", \"verdict\": \"" << door.verdict
		       << "\", \"clear_width\": " << door.clear_width_m << ", \"sill\": " << door.sill_m << "}";
		between = ",\n";
	}
	labels << "\n  ],\n  \"corridors\": [";
	between = "\n";
	for (std::size_t i = 0; i < corridors.size(); ++i, between = ",\n")
		labels << between << "    {\"id\": \"c" << i << "\", \"from\": " << place(corridors[i].from)
		       << ", \"to\": " << place(corridors[i].to) << ", \"width\": " << corridors[i].width_m << "}";
	labels << "\n  ],\n  \"obstacles\": [";
	between = "\n";
	for (const PlannedObstacle& obstacle : obstacles)
	{
		labels << between << "    {\"kind\": \"" << obstacle.kind << "\", \"at\": " << place(obstacle.at)
		       << ", \"radius\": " << obstacle.radius_m << ", \"height\": " << obstacle.height_m << "}";
		between = ",\n";
	}
	labels << "\n  ],\n  \"spawns\": [";
	between = "\n";
	for (std::size_t i = 0; i < spawns.size(); ++i, between = ",\n")
		labels << between << "    {\"name\": \"room" << i << "\", \"at\": " << place(spawns[i]) << "}";
	labels << "\n  ]\n}\n";
	save(folder / "building.doors.json", labels.str());
}
}  // namespace explore::test
