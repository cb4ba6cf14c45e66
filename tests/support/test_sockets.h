// The robot's ends of a link: sockets on this machine that a test receives and sends with.
#pragma once

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace explore::test
{
using SteadyClock = std::chrono::steady_clock;

/** A text and when it came. */
struct Received
{
	SteadyClock::time_point at;
	std::string text;
};

/** A socket that is closed with its owner. Its methods throw std::runtime_error where the system fails. */
class TestSocket
{
public:
	explicit TestSocket(int number) : m_number(number)
	{
		if (number < 0) throw std::runtime_error(std::string("socket: ") + std::strerror(errno));
	}
	TestSocket(TestSocket&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
	TestSocket(const TestSocket&) = delete;
	TestSocket& operator=(const TestSocket&) = delete;
	~TestSocket()
	{
		if (m_number >= 0) ::close(m_number);
	}
	[[nodiscard]] int number() const { return m_number; }
	[[nodiscard]] bool readable(int timeout_ms) const
	{
		pollfd state{m_number, POLLIN, 0};
		return ::poll(&state, 1, timeout_ms) > 0;
	}
	/** At most 64 KiB of what is there; empty where the other side has ended. */
	[[nodiscard]] std::string receive() const
	{
		std::string text(65'536, '\0');
		const ssize_t size = ::recv(m_number, text.data(), text.size(), 0);
		text.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
		return text;
	}
	void send(const std::string& text) const { ::send(m_number, text.data(), text.size(), MSG_NOSIGNAL); }

private:
	int m_number;
};

inline sockaddr_in loopback(int port)
{
	sockaddr_in address{};
	address.sin_family = AF_INET;
	address.sin_port = htons(static_cast<std::uint16_t>(port));
	address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
	return address;
}

/** Datagrams to a port of this machine that the system chooses. */
class UdpReceiver
{
public:
	UdpReceiver() : m_socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0))
	{
		sockaddr_in address = loopback(0);
		socklen_t size = sizeof(address);
		if (::bind(m_socket.number(), reinterpret_cast<sockaddr*>(&address), size) != 0 ||
		    ::getsockname(m_socket.number(), reinterpret_cast<sockaddr*>(&address), &size) != 0)
			throw std::runtime_error("no port");
		m_port = ntohs(address.sin_port);
	}
	[[nodiscard]] int port() const { return m_port; }
	[[nodiscard]] std::string uri() const { return "udp://127.0.0.1:" + std::to_string(m_port); }
	[[nodiscard]] const TestSocket& socket() const { return m_socket; }
	/** What comes until nothing has come for so long. */
	[[nodiscard]] std::vector<Received> all(int silence_ms) const
	{
		std::vector<Received> received;
		while (m_socket.readable(silence_ms)) received.push_back({SteadyClock::now(), m_socket.receive()});
		return received;
	}

private:
	TestSocket m_socket;
	int m_port = 0;
};

/** A port of this machine that nobody used a moment ago. */
inline int freePort()
{
	return UdpReceiver().port();
}

inline TestSocket udpSender(int port)
{
	TestSocket socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
	const sockaddr_in address = loopback(port);
	if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0)
		throw std::runtime_error("no receiver");
	return socket;
}

inline sockaddr_un unixName(const std::filesystem::path& path)
{
	sockaddr_un name{};
	name.sun_family = AF_UNIX;
	if (path.string().size() >= sizeof(name.sun_path)) throw std::runtime_error("too long a path: " + path.string());
	std::strcpy(name.sun_path, path.c_str());
	return name;
}

/** A Unix stream socket that listens at `path`. */
inline TestSocket unixServer(const std::filesystem::path& path)
{
	TestSocket socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
	const sockaddr_un name = unixName(path);
	if (::bind(socket.number(), reinterpret_cast<const sockaddr*>(&name), sizeof(name)) != 0 ||
	    ::listen(socket.number(), 4) != 0)
		throw std::runtime_error("cannot listen at " + path.string());
	return socket;
}

/** The next connection to a server. */
inline TestSocket accepted(const TestSocket& server)
{
	return TestSocket(::accept4(server.number(), nullptr, nullptr, SOCK_CLOEXEC));
}

inline TestSocket unixClient(const std::filesystem::path& path)
{
	TestSocket socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
	const sockaddr_un name = unixName(path);
	if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&name), sizeof(name)) != 0)
		throw std::runtime_error("nobody listens at " + path.string());
	return socket;
}
}  // namespace explore::test
