#include <explore/core/errors.h>
#include <explore/sinks/json_values.h>
#include <explore/sinks/robot_link/json_command_sink.h>
#include <explore/sinks/robot_link/link_socket.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <utility>

namespace explore
{
namespace
{
/** Datagrams are sent or lost: the next one comes soon. */
class DatagramWriter
{
public:
	DatagramWriter(const LinkAddress& address, LinkRemarks& remarks)
	    : m_name("[robot_link] " + address.text),
	      m_socket(std::make_shared<Descriptor>(connectTo(address))),
	      m_remarks(&remarks)
	{
	}
	void operator()(const std::string& line)
	{
		if (::send(m_socket->number(), line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0) return;
		const int error = errno;
		if (error == EINTR || error == EAGAIN) return;
		m_remarks->say("commands unheard", m_name + ": commands do not arrive: " + reasonOf(error));
	}

private:
	std::string m_name;
	std::shared_ptr<Descriptor> m_socket;  ///< std::function wants copies
	LinkRemarks* m_remarks;
};

/** Whole lines, or an error: half a line would spoil the next. */
class LineWriter
{
public:
	LineWriter(std::string name, std::shared_ptr<Descriptor> owned, int descriptor)
	    : m_name(std::move(name)), m_owned(std::move(owned)), m_descriptor(descriptor)
	{
	}
	void operator()(const std::string& line)
	{
		std::string_view rest = line;
		while (!rest.empty())
		{
			waitUntilItTakesMore();
			const ssize_t written = m_owned ? ::send(m_descriptor, rest.data(), rest.size(), MSG_NOSIGNAL)
			                                : ::write(m_descriptor, rest.data(), rest.size());
			if (written < 0 && (errno == EINTR || errno == EAGAIN)) continue;
			if (written < 0) fail(reasonOf(errno));
			rest.remove_prefix(static_cast<std::size_t>(written));
		}
	}

private:
	[[noreturn]] void fail(const std::string& reason) const
	{
		throw OutputError(m_name + ": commands cannot be delivered: " + reason);
	}
	/** A pipe or socket that takes more takes a line without waiting. */
	void waitUntilItTakesMore() const
	{
		constexpr int kPatience_ms = 1000;
		pollfd state{m_descriptor, POLLOUT, 0};
		int ready = -1;
		do ready = ::poll(&state, 1, kPatience_ms);
		while (ready < 0 && errno == EINTR);
		if (ready == 0) fail("the receiver has read nothing for a second");
	}

	std::string m_name;
	std::shared_ptr<Descriptor> m_owned;  ///< null for standard output
	int m_descriptor;
};
}  // namespace

std::string commandLine(const TimedCommand& command, bool stop, std::uint64_t seq)
{
	const Json line{{"t", jsonOrNull(command.t_s)},
	                {"v", jsonVector(command.command.velocity_mps)},
	                {"yaw_rate", jsonNumber(command.command.yaw_rate_radps)},
	                {"stop", stop},
	                {"seq", seq}};
	return jsonText(line) + '\n';
}

JsonCommandSink::JsonCommandSink(Write write) : m_write(std::move(write)) {}

void JsonCommandSink::send(const TimedCommand& command)
{
	m_write(commandLine(command, false, m_next++));
}

void JsonCommandSink::stop(std::optional<double> t_s)
{
	m_write(commandLine({t_s, Command()}, true, m_next++));
}

std::unique_ptr<CommandSink> makeCommandSink(const LinkAddress& address, LinkRemarks& remarks)
{
	if (address.kind == LinkKind::udp) return std::make_unique<JsonCommandSink>(DatagramWriter(address, remarks));
	const std::string name = "[robot_link] " + address.text;
	if (address.kind == LinkKind::standard_output)
		return std::make_unique<JsonCommandSink>(LineWriter(name, nullptr, STDOUT_FILENO));
	auto socket = std::make_shared<Descriptor>(connectTo(address));
	const int descriptor = socket->number();
	return std::make_unique<JsonCommandSink>(LineWriter(name, std::move(socket), descriptor));
}
}  // namespace explore
