// Sockets of the robot link: datagrams over UDP, lines over a Unix stream.
#pragma once

#include <explore/sinks/robot_link/link_address.h>

#include <string>
#include <utility>

namespace explore
{
/** A descriptor that is closed with its owner. */
class Descriptor
{
public:
	explicit Descriptor(int number = -1) : m_number(number) {}
	Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
	Descriptor& operator=(Descriptor&& other) noexcept
	{
		std::swap(m_number, other.m_number);
		return *this;
	}
	Descriptor(const Descriptor&) = delete;
	Descriptor& operator=(const Descriptor&) = delete;
	~Descriptor();

	[[nodiscard]] int number() const { return m_number; }
	[[nodiscard]] bool valid() const { return m_number >= 0; }

private:
	int m_number;
};

/** What the system calls an errno. */
std::string reasonOf(int error);

/** A socket that sends to `address` (udp or unix_stream). Throws OutputError with the address and the system's reason,
 *  for a Unix stream also where nobody listens. */
Descriptor connectTo(const LinkAddress& address);

/** A socket on which `address` receives: datagrams of udp, connections of unix_stream. A Unix socket that a program
 * left behind is replaced, one on which a program listens is not. Throws InputError with the address and the system's
 *  reason. */
Descriptor listenOn(const LinkAddress& address);
}  // namespace explore
