// The addresses of [robot_link]: none, stdout, udp://host:port, unix:///path.
#pragma once

#include <string>

namespace explore
{
enum class LinkKind
{
	none,
	standard_output,
	udp,
	unix_stream
};

struct LinkAddress
{
	LinkKind kind = LinkKind::none;
	std::string host, port;  ///< udp; an IPv6 address without its brackets
	std::string path;        ///< unix_stream
	std::string text;        ///< as it was written, for messages
};

/** Throws ConfigError with `key` of [robot_link], the text and what is accepted. */
LinkAddress linkAddress(const std::string& key, const std::string& text);
}  // namespace explore
