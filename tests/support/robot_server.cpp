// A robot in a simulated world at the other end of the wires: its camera is OpenNI2's virtual one, its commands come
// and its poses go over UDP, and time is everybody's.
//
// robot_server CAMERA_FOLDER COMMAND_PORT POSE_PORT RESULTS_OF_THE_EXPLORER INI WORLD [section.key=value]...
// On SIGTERM it prints what really happened, with the coverage of the map in the explorer's results.
#include <common/app_config.h>
#include <common/closed_loop_source.h>
#include <explore/core/geometry.h>
#include <explore/evaluation/coverage.h>
#include <explore/sinks/robot_link/link_socket.h>
#include <mrpt/core/Clock.h>
#include <octomap/OcTree.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "virtual_camera/frames_file.h"
#include "virtual_camera/live_frame.h"

namespace explore::test
{
namespace
{
using std::chrono::steady_clock;

/** A robot stops when nobody commands it. */
constexpr std::chrono::milliseconds kWatchdog{300};

volatile std::sig_atomic_t g_ends = 0;

LinkAddress localPort(const std::string& port)
{
	return linkAddress("port", "udp://127.0.0.1:" + port);
}

/** The commands that come, and when the last one did. */
class Commands
{
public:
	explicit Commands(const std::string& port) : m_socket(listenOn(localPort(port))) {}

	/** What the robot is to do now. */
	Command now()
	{
		std::array<char, 2048> text{};
		for (ssize_t size = 0; (size = receive(text)) > 0;)
		{
			const auto message = nlohmann::json::parse(text.data(), text.data() + size);
			const auto velocity = message["v"].get<std::array<double, 3>>();
			m_command.velocity_mps = {velocity[0], velocity[1], velocity[2]};
			m_command.yaw_rate_radps = message["yaw_rate"].get<double>();
			m_heard = steady_clock::now();
			++m_count;
		}
		return steady_clock::now() - m_heard < kWatchdog ? m_command : Command{};
	}
	[[nodiscard]] std::size_t count() const { return m_count; }

private:
	[[nodiscard]] ssize_t receive(std::array<char, 2048>& text) const
	{
		return recv(m_socket.number(), text.data(), text.size(), MSG_DONTWAIT);
	}

	Descriptor m_socket;
	Command m_command;
	steady_clock::time_point m_heard;
	std::size_t m_count = 0;
};

class Server
{
public:
	Server(const std::filesystem::path& folder, const std::string& command_port, const std::string& pose_port)
	    : m_folder(folder), m_commands(command_port), m_poses(connectTo(localPort(pose_port)))
	{
		std::filesystem::create_directories(folder);
	}

	/** Until it is told to end. */
	void run(app::ClosedLoopSource& robot, double rate_hz)
	{
		const auto start = steady_clock::now();
		const mrpt::Clock::time_point start_time = mrpt::Clock::now();
		for (std::uint64_t number = 0; g_ends == 0; ++number)
		{
			const std::chrono::duration<double> since(static_cast<double>(number) / rate_hz);
			std::this_thread::sleep_until(start + std::chrono::duration_cast<steady_clock::duration>(since));
			if (number > 0) robot.obey(m_commands.now());
			const auto frame = robot.next();
			if (!frame) return;
			const auto time = start_time + std::chrono::duration_cast<mrpt::Clock::duration>(since);
			tellPose(frame->map_from_robot, mrpt::Clock::toDouble(time));
			show(*frame, number, static_cast<std::uint64_t>(since.count() * 1e6));
		}
	}
	[[nodiscard]] std::size_t commands() const { return m_commands.count(); }

private:
	void tellPose(const mrpt::poses::CPose3D& pose, double t_s) const
	{
		const nlohmann::json message{{"pose",
		                              {{"t", t_s},
		                               {"x", pose.x()},
		                               {"y", pose.y()},
		                               {"z", pose.z()},
		                               {"yaw", pose.yaw()},
		                               {"pitch", pose.pitch()},
		                               {"roll", pose.roll()}}}};
		const std::string text = message.dump();
		// An explorer that does not listen yet, or any more, is no error.
		send(m_poses.number(), text.data(), text.size(), 0);
	}
	void show(const DepthFrame& frame, std::uint64_t number, std::uint64_t time_us) const
	{
		LiveFrame live{number + 1, time_us, {}};
		for (const float depth_m : frame.image.depth_m)
			live.counts.push_back(static_cast<std::uint16_t>(std::lround(std::min(65.0F, depth_m) * 1000.0F)));
		writeLiveFrame(m_folder / "live", live);
		if (number > 0) return;
		// The camera is there when there is something to see.
		const CameraIntrinsics& camera = frame.image.intrinsics;
		writeServedFrames(m_folder / "frames",
		                  {camera.width_px, camera.height_px, camera.fx_px, camera.fy_px, {live.counts}});
		std::ofstream(m_folder / "control") << "plugged=1\n";
	}

	std::filesystem::path m_folder;
	Commands m_commands;
	Descriptor m_poses;
};

nlohmann::json truthOf(const app::ClosedLoopSource& robot, const mrpt::poses::CPose3D& map_from_start,
                       const std::filesystem::path& results)
{
	const app::TrueState state = robot.trueState();
	nlohmann::json truth{{"collisions", state.contacts.size()},
	                     {"from_start_m", state.map_from_robot.distanceTo(map_from_start)},
	                     {"t_s", state.t_s},
	                     {"coverage", nullptr}};
	const std::unique_ptr<octomap::AbstractOcTree> tree(octomap::AbstractOcTree::read((results / "map.ot").string()));
	if (const auto* map = dynamic_cast<const octomap::OcTree*>(tree.get()))
		truth["coverage"] = evaluation::coverageOf(robot.reachable(), *map).share();
	return truth;
}

int serve(const std::vector<std::string>& arguments)
{
	app::ConfigChoices choices;
	choices.ini = arguments.at(4);
	choices.world = arguments.at(5);
	choices.set.assign(arguments.begin() + 6, arguments.end());
	const app::LoadedConfig loaded = app::loadConfig(choices);
	mrpt::system::COutputLogger logger("robot_server");
	const auto robot = app::openSimulator(loaded, logger);
	const mrpt::poses::CPose3D map_from_start = robot->trueState().map_from_robot;
	Server server(arguments.at(0), arguments.at(1), arguments.at(2));
	server.run(*robot, loaded.config.simulated_camera.rate_hz);
	nlohmann::json truth = truthOf(*robot, map_from_start, arguments.at(3));
	truth["commands"] = server.commands();
	std::cout << truth.dump() << std::endl;
	return 0;
}
}  // namespace
}  // namespace explore::test

int main(int argc, char** argv)
{
	std::signal(SIGTERM, [](int) { explore::test::g_ends = 1; });
	try
	{
		if (argc < 7) throw std::invalid_argument("too few arguments: see the source");
		return explore::test::serve(std::vector<std::string>(argv + 1, argv + argc));
	}
	catch (const std::exception& error)
	{
		std::fprintf(stderr, "robot_server: %s\n", error.what());
		return 2;
	}
}
