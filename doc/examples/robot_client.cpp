// A robot without a body: takes the explorer's commands, moves a pose by them, and tells it where it is.
// robot_client COMMAND_PORT [LISTEN_PORT]   ends after 2 s of silence, and prints what it was told
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

int main(int argc, char** argv)
{
	if (argc < 2) return 2;
	const int commands = socket(AF_INET, SOCK_DGRAM, 0);
	sockaddr_in here{}, explorer{};
	here.sin_family = explorer.sin_family = AF_INET;
	here.sin_addr.s_addr = explorer.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
	here.sin_port = htons(static_cast<std::uint16_t>(std::atoi(argv[1])));
	explorer.sin_port = htons(static_cast<std::uint16_t>(argc > 2 ? std::atoi(argv[2]) : 0));
	if (bind(commands, reinterpret_cast<sockaddr*>(&here), sizeof(here)) != 0) return 3;

	using Clock = std::chrono::steady_clock;
	double x = 0, y = 0, yaw = 0, distance = 0, turned = 0, t = 0, frame_t = 0;
	Clock::time_point since;
	int count = 0;
	nlohmann::json last{{"stop", true}};
	pollfd state{commands, POLLIN, 0};
	// A robot's own watchdog stops its motors after 0.2 s of silence; the explorer may take its time to start.
	while (poll(&state, 1, count == 0 ? 30'000 : 2'000) > 0)
	{
		char text[2048];
		const ssize_t size = recv(commands, text, sizeof(text), 0);
		if (size <= 0) break;
		last = nlohmann::json::parse(text, text + size);
		++count;
		if (last["t"].is_null()) continue;  // the explorer waits for its first frame
		if (frame_t == 0) t = last["t"];
		if (last["t"] != frame_t) frame_t = last["t"], since = Clock::now();
		const double now = frame_t + std::chrono::duration<double>(Clock::now() - since).count();
		const double dt = std::max(0.0, now - t);  // a real robot asks its clock
		t = now;
		const double v = last["v"][0], yaw_rate = last["yaw_rate"];  // here: set the motors
		yaw += yaw_rate * dt, turned += std::abs(yaw_rate) * dt, distance += v * dt;
		x += v * std::cos(yaw) * dt, y += v * std::sin(yaw) * dt;
		if (argc < 3) continue;
		const nlohmann::json pose{{"t", t}, {"x", x}, {"y", y}, {"z", 0}, {"yaw", yaw}, {"pitch", 0}, {"roll", 0}};
		const std::string message = nlohmann::json{{"pose", pose}}.dump();
		sendto(commands, message.data(), message.size(), 0, reinterpret_cast<sockaddr*>(&explorer), sizeof(explorer));
	}
	std::printf("%d commands, %.2f m, %.2f rad, the last one %s\n", count, distance, turned,
	            last["stop"] ? "stop" : "move");
}
