#include <explore/core/errors.h>
#include <explore/sinks/robot_link/link_address.h>
#include <sys/un.h>

#include <algorithm>
#include <optional>
#include <string_view>

namespace explore
{
namespace
{
constexpr std::string_view kUdp = "udp://", kUnix = "unix://";

[[noreturn]] void fail(const std::string& key, const std::string& text, const std::string& why)
{
	throw ConfigError("[robot_link] " + key + " = " + text + ": " + why +
	                  "; accepted: none, stdout (commands only), udp://host:port or unix:///path");
}

bool isPort(std::string_view text)
{
	constexpr int kLargest = 65535;
	const bool digits =
	    !text.empty() && text.size() <= 5 && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
	if (!digits) return false;
	const int port = std::stoi(std::string(text));
	return port >= 1 && port <= kLargest;
}

std::string withoutBrackets(std::string host)
{
	const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
	return bracketed ? host.substr(1, host.size() - 2) : host;
}

LinkAddress udpAddress(const std::string& key, const std::string& text)
{
	const std::string place = text.substr(kUdp.size());
	const std::size_t colon = place.rfind(':');
	if (colon == std::string::npos) fail(key, text, "has no port");
	if (colon == 0) fail(key, text, "has no host");
	LinkAddress address{LinkKind::udp, withoutBrackets(place.substr(0, colon)), place.substr(colon + 1), {}, text};
	if (!isPort(address.port)) fail(key, text, "'" + address.port + "' is no port from 1 to 65535");
	return address;
}

LinkAddress unixAddress(const std::string& key, const std::string& text)
{
	LinkAddress address{LinkKind::unix_stream, {}, {}, text.substr(kUnix.size()), text};
	constexpr std::size_t kLongest = sizeof(sockaddr_un::sun_path) - 1;
	if (address.path.empty() || address.path.front() != '/') fail(key, text, "the path has to begin with /");
	if (address.path.size() > kLongest)
		fail(key, text, "the path of a socket has at most " + std::to_string(kLongest) + " bytes");
	return address;
}
}  // namespace

LinkAddress linkAddress(const std::string& key, const std::string& text)
{
	if (text == "none") return {LinkKind::none, {}, {}, {}, text};
	if (text == "stdout") return {LinkKind::standard_output, {}, {}, {}, text};
	if (text.starts_with(kUdp)) return udpAddress(key, text);
	if (text.starts_with(kUnix)) return unixAddress(key, text);
	fail(key, text, "is no address");
}
}  // namespace explore
