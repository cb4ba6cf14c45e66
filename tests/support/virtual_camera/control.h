// What the virtual camera is to do, as a test says it in a file.
#pragma once

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <string>

namespace explore::test
{
/** What the test wants the camera to do now; renewed while it runs. */
struct Control
{
	bool plugged = true, stalled = false, denied = false, starts = true;
	std::string corrupt = "none";  ///< none, size or empty
	std::string color = "rgb";  ///< rgb, none (no such sensor), yuv (no such mode), refused (does not start), stalled
	bool registers = false;     ///< can do depth as the colour camera would see it
	double late_s = 0;          ///< so long after it was taken a frame is there
	std::string unit = "1mm";   ///< 1mm or 100um: the only one that is offered
	double rate_hz = 30;
};

inline std::string controlFolder()
{
	const char* folder = std::getenv("EXPLORE_VIRTUAL_CAMERA");  // NOLINT(concurrency-mt-unsafe)
	return folder != nullptr ? folder : "";
}

inline Control readControl()
{
	Control control;
	const std::string folder = controlFolder();
	control.plugged = !folder.empty();
	std::ifstream file(folder + "/control");
	for (std::string line; std::getline(file, line);)
	{
		const std::size_t equals = line.find('=');
		if (equals == std::string::npos) continue;
		const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
		if (key == "plugged") control.plugged = value == "1";
		if (key == "stalled") control.stalled = value == "1";
		if (key == "denied") control.denied = value == "1";
		if (key == "starts") control.starts = value == "1";
		if (key == "corrupt") control.corrupt = value;
		if (key == "unit") control.unit = value;
		if (key == "rate_hz") control.rate_hz = std::stod(value);
		if (key == "color") control.color = value;
		if (key == "registers") control.registers = value == "1";
		if (key == "late_s") control.late_s = std::stod(value);
	}
	return control;
}

/** The control as it was read last. */
class SharedControl
{
public:
	Control get() const
	{
		const std::lock_guard lock(m_mutex);
		return m_control;
	}
	void renew()
	{
		const Control control = readControl();
		const std::lock_guard lock(m_mutex);
		m_control = control;
	}

private:
	mutable std::mutex m_mutex;
	Control m_control;
};

inline SharedControl& shared()
{
	static SharedControl control;
	return control;
}
}  // namespace explore::test
