// OpenNI2 as long as it is needed, the cameras that it finds, and what to check where it finds none.
#pragma once

#include <string>
#include <vector>

namespace explore::openni2
{
/** Loads OpenNI2's drivers, which look for cameras; they are unloaded with the last of these that is destroyed. */
class Library
{
public:
	/** Throws SensorLost with OpenNI2's reason. */
	Library();
	~Library();
	Library(const Library&) = delete;
	Library& operator=(const Library&) = delete;
};

struct DeviceEntry
{
	std::string uri, vendor, name;
};

/** The cameras that are plugged in now. A Library must be there. */
std::vector<DeviceEntry> listDevices();

/** One camera a line, "  0: Xtion of ASUS, 1d27/0601@1/5"; "" for none. */
std::string textOf(const std::vector<DeviceEntry>& devices);

/** What a user can do about a camera that is not found or does not open. */
std::string whatToCheck();

/** What OpenNI2 says about the call that just failed; never empty. */
std::string reasonOfFailure();
}  // namespace explore::openni2
