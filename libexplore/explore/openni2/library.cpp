#include <OpenNI.h>
#include <explore/core/errors.h>
#include <explore/openni2/library.h>

#include <algorithm>

namespace explore::openni2
{
Library::Library()
{
	if (openni::OpenNI::initialize() == openni::STATUS_OK) return;
	const std::string reason = reasonOfFailure();
	openni::OpenNI::shutdown();
	throw SensorLost("OpenNI2 cannot be started: " + reason + "\n" + whatToCheck());
}

Library::~Library()
{
	openni::OpenNI::shutdown();
}

std::vector<DeviceEntry> listDevices()
{
	openni::Array<openni::DeviceInfo> found;
	openni::OpenNI::enumerateDevices(&found);
	std::vector<DeviceEntry> devices;
	devices.reserve(static_cast<std::size_t>(found.getSize()));
	for (int i = 0; i < found.getSize(); ++i)
		devices.push_back({found[i].getUri(), found[i].getVendor(), found[i].getName()});
	return devices;
}

std::string textOf(const std::vector<DeviceEntry>& devices)
{
	std::string text;
	for (std::size_t i = 0; i < devices.size(); ++i)
		text.append("  ")
		    .append(std::to_string(i))
		    .append(": ")
		    .append(devices[i].name)
		    .append(" of ")
		    .append(devices[i].vendor)
		    .append(", ")
		    .append(devices[i].uri)
		    .append("\n");
	return text;
}

std::string whatToCheck()
{
	return "What to check:\n"
	       "  - cable and USB port: lsusb shows 1d27:... (Xtion, PrimeSense) or 045e:02ae (Kinect); an Xtion wants a\n"
	       "    port of its own, some models USB 2; a Kinect wants its power supply\n"
	       "  - permissions: the udev rules of the package libopenni2-0 (/lib/udev/rules.d/60-libopenni2-0.rules) must "
	       "be\n"
	       "    in force: plug the camera in anew, or run udevadm control --reload && udevadm trigger as root\n"
	       "  - another program that has the camera open, or the kernel's gspca_kinect or snd_usb_audio module that "
	       "took\n"
	       "    it: rmmod gspca_kinect snd_usb_audio\n"
	       "  - frames that do not come although it opens: UsbInterface=2 (bulk transfers) below [Device] in\n"
	       "    /etc/openni2/PS1080.ini\n"
	       "  - explore-rawlog record --openni2 list shows what OpenNI2 finds";
}

std::string reasonOfFailure()
{
	std::string reason = openni::OpenNI::getExtendedError();
	while (!reason.empty() && (reason.back() == '\n' || reason.back() == '\t' || reason.back() == ' '))
		reason.pop_back();
	std::replace(reason.begin(), reason.end(), '\n', ' ');
	std::replace(reason.begin(), reason.end(), '\t', ' ');
	return reason.empty() ? "OpenNI2 gives no reason" : reason;
}
}  // namespace explore::openni2
