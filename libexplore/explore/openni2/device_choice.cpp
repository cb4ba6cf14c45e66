#include <OpenNI.h>
#include <explore/core/errors.h>
#include <explore/openni2/device_choice.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace explore::openni2
{
namespace
{
using Devices = std::vector<DeviceEntry>;

/** The number that all of `text` is. */
std::optional<std::size_t> numberIn(const std::string& text)
{
	std::size_t number = 0;
	const char* const end = text.data() + text.size();
	const auto [rest, error] = std::from_chars(text.data(), end, number);
	return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/** "1d27/0601" of "1d27/0601@1/5". */
std::string modelOf(const std::string& uri)
{
	return uri.substr(0, uri.find('@'));
}

std::optional<std::string> byUri(const Devices& devices, const std::string& wanted)
{
	const auto same_uri = [&](const DeviceEntry& device) { return device.uri == wanted; };
	const auto same_model = [&](const DeviceEntry& device) { return modelOf(device.uri) == modelOf(wanted); };
	if (std::any_of(devices.begin(), devices.end(), same_uri)) return wanted;
	if (wanted.find('@') == std::string::npos || std::count_if(devices.begin(), devices.end(), same_model) != 1)
		return std::nullopt;
	return std::find_if(devices.begin(), devices.end(), same_model)->uri;
}

std::string serialOf(const std::string& uri)
{
	openni::Device device;
	if (device.open(uri.c_str()) != openni::STATUS_OK) return "";
	std::array<char, 256> serial{};
	int size = static_cast<int>(serial.size()) - 1;
	const auto status = device.getProperty(ONI_DEVICE_PROPERTY_SERIAL_NUMBER, serial.data(), &size);
	device.close();
	return status == openni::STATUS_OK ? serial.data() : "";
}

std::optional<std::string> bySerial(const Devices& devices, const std::string& wanted)
{
	for (const DeviceEntry& device : devices)
		if (serialOf(device.uri) == wanted) return device.uri;
	return std::nullopt;
}
}  // namespace

std::string chooseDevice(const std::string& wanted)
{
	const Devices devices = listDevices();
	if (devices.empty()) throw SensorLost("no depth camera was found through OpenNI2\n" + whatToCheck());
	if (wanted.empty()) return devices.front().uri;
	if (const auto number = numberIn(wanted); number && *number < devices.size()) return devices[*number].uri;
	if (const auto uri = byUri(devices, wanted)) return *uri;
	if (const auto uri = bySerial(devices, wanted)) return *uri;
	throw SensorLost("[openni2] device = " + wanted + ": no camera has this number, serial number or URI; found:\n" +
	                 textOf(devices) + whatToCheck());
}
}  // namespace explore::openni2
