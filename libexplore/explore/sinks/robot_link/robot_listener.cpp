#include <explore/sinks/robot_link/robot_listener.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace explore
{
namespace
{
constexpr std::size_t kMostStreams = 16;
}

RobotListener::RobotListener(const LinkAddress& address, RobotInbox& inbox)
    : m_address(address),
      m_inbox(inbox),
      m_socket(listenOn(address)),
      m_buffer(kLongestMessage, '\0'),
      m_thread([this] { run(); })
{
}

RobotListener::~RobotListener()
{
	m_ends = true;
	m_thread.join();
	if (m_address.kind == LinkKind::unix_stream) ::unlink(m_address.path.c_str());
}

void RobotListener::wait(std::vector<int>& ready) const
{
	constexpr int kLookUp_ms = 50;  // whether it is over
	std::vector<pollfd> states{{m_socket.number(), POLLIN, 0}};
	for (const Stream& stream : m_streams) states.push_back({stream.socket.number(), POLLIN, 0});
	ready.clear();
	if (::poll(states.data(), states.size(), kLookUp_ms) <= 0) return;
	for (const pollfd& state : states)
		if (state.revents != 0) ready.push_back(state.fd);
}

void RobotListener::run()
{
	std::vector<int> ready;
	while (!m_ends)
	{
		wait(ready);
		const auto is_ready = [&](int descriptor) { return std::ranges::find(ready, descriptor) != ready.end(); };
		m_streams.remove_if([&](Stream& stream) { return is_ready(stream.socket.number()) && !receiveOn(stream); });
		if (!is_ready(m_socket.number())) continue;
		if (m_address.kind == LinkKind::udp)
			receiveDatagram();
		else
			accept();
	}
}

void RobotListener::receiveDatagram()
{
	const ssize_t size = ::recv(m_socket.number(), m_buffer.data(), m_buffer.size(), MSG_DONTWAIT);
	if (size >= 0)
		m_inbox.take(std::string_view(m_buffer).substr(0, static_cast<std::size_t>(size)), mrpt::Clock::now());
}

void RobotListener::accept()
{
	Descriptor socket(::accept4(m_socket.number(), nullptr, nullptr, SOCK_CLOEXEC));
	if (socket.valid() && m_streams.size() < kMostStreams) m_streams.push_back({std::move(socket), {}});
}

bool RobotListener::receiveOn(Stream& stream)
{
	const ssize_t size = ::recv(stream.socket.number(), m_buffer.data(), m_buffer.size(), MSG_DONTWAIT);
	if (size < 0) return errno == EAGAIN || errno == EINTR;
	takeLines(stream, std::string_view(m_buffer).substr(0, static_cast<std::size_t>(size)));
	return size > 0;
}

void RobotListener::takeLines(Stream& stream, std::string_view bytes)
{
	while (!bytes.empty())
	{
		const std::size_t end = std::min(bytes.find('\n'), bytes.size());
		const bool fits = stream.line.size() + end <= kLongestMessage;
		if (!fits) stream.line.clear(), stream.too_long = true;
		if (!stream.too_long) stream.line += bytes.substr(0, end);
		if (end == bytes.size()) return;
		bytes.remove_prefix(end + 1);
		if (stream.too_long)
			m_inbox.refuse("a line of more than 64 KiB");
		else if (!stream.line.empty())
			m_inbox.take(stream.line, mrpt::Clock::now());
		stream.line.clear(), stream.too_long = false;
	}
}
}  // namespace explore
