#include <explore/core/errors.h>
#include <explore/sinks/robot_link/link_socket.h>
#include <netdb.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <system_error>

namespace explore
{
namespace
{
template <class Error>
[[noreturn]] void fail(const LinkAddress& address, const std::string& action, const std::string& reason)
{
	throw Error("[robot_link] " + address.text + ": cannot " + action + ": " + reason);
}

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

template <class Error>
Addresses resolve(const LinkAddress& address, int flags)
{
	addrinfo hints{};
	hints.ai_family = AF_UNSPEC;
	hints.ai_socktype = SOCK_DGRAM;
	hints.ai_flags = flags | AI_NUMERICSERV;
	addrinfo* found = nullptr;
	const int error = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found);
	if (error != 0) fail<Error>(address, "find the host " + address.host, ::gai_strerror(error));
	return {found, &::freeaddrinfo};
}

/** The first of the host's addresses for which `use` (connect or bind) succeeds. */
template <class Error, class Use>
Descriptor datagramSocket(const LinkAddress& address, int flags, const char* action, const Use& use)
{
	int error = 0;
	const Addresses addresses = resolve<Error>(address, flags);
	for (const addrinfo* one = addresses.get(); one != nullptr; one = one->ai_next)
	{
		Descriptor socket(::socket(one->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0));
		if (socket.valid() && use(socket.number(), one->ai_addr, one->ai_addrlen) == 0) return socket;
		error = errno;
	}
	fail<Error>(address, action, reasonOf(error));
}

sockaddr_un nameOfPath(const std::string& path)
{
	sockaddr_un name{};
	name.sun_family = AF_UNIX;
	std::memcpy(static_cast<char*>(name.sun_path), path.c_str(), path.size() + 1);  // linkAddress() has checked it
	return name;
}

const sockaddr* genericName(const sockaddr_un& name)
{
	return reinterpret_cast<const sockaddr*>(&name);  // NOLINT: the system's own interface
}

/** A connected stream; not valid where that fails, errno saying why. */
Descriptor connectedStream(const LinkAddress& address)
{
	Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
	const sockaddr_un name = nameOfPath(address.path);
	if (socket.valid() && ::connect(socket.number(), genericName(name), sizeof(name)) == 0) return socket;
	return Descriptor();
}

/** Removes a socket at the path that nobody listens on any more. */
void removeLeftover(const LinkAddress& address)
{
	struct stat status
	{
	};
	const bool is_socket = ::lstat(address.path.c_str(), &status) == 0 && S_ISSOCK(status.st_mode);
	if (!is_socket) return;  // somebody's file stays, and bind() fails
	if (connectedStream(address).valid()) fail<InputError>(address, "listen", "another program listens there");
	if (errno == ECONNREFUSED) ::unlink(address.path.c_str());
}

Descriptor listeningStream(const LinkAddress& address)
{
	constexpr int kWaiting = 8;
	removeLeftover(address);
	Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
	const sockaddr_un name = nameOfPath(address.path);
	const bool listens = socket.valid() && ::bind(socket.number(), genericName(name), sizeof(name)) == 0 &&
	                     ::listen(socket.number(), kWaiting) == 0;
	if (!listens) fail<InputError>(address, "listen", reasonOf(errno));
	return socket;
}
}  // namespace

std::string reasonOf(int error)
{
	return std::system_category().message(error);
}

Descriptor::~Descriptor()
{
	if (valid()) ::close(m_number);
}

Descriptor connectTo(const LinkAddress& address)
{
	if (address.kind == LinkKind::udp) return datagramSocket<OutputError>(address, 0, "send", ::connect);
	Descriptor socket = connectedStream(address);
	if (!socket.valid()) fail<OutputError>(address, "connect", reasonOf(errno));
	return socket;
}

Descriptor listenOn(const LinkAddress& address)
{
	if (address.kind == LinkKind::udp) return datagramSocket<InputError>(address, AI_PASSIVE, "listen", ::bind);
	return listeningStream(address);
}
}  // namespace explore
