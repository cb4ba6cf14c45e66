// Receives the robot's messages on a thread of its own: a datagram each over UDP, a line each on Unix streams.
#pragma once

#include <explore/sinks/robot_link/link_socket.h>
#include <explore/sinks/robot_link/robot_inbox.h>

#include <atomic>
#include <list>
#include <string>
#include <thread>

namespace explore
{
class RobotListener
{
public:
	static constexpr std::size_t kLongestMessage = 65'536;  ///< bytes

	/** Listens on `address`, which is udp or unix_stream, and puts what comes into `inbox`, which outlives it. Throws
	 *  InputError where it cannot listen there. */
	RobotListener(const LinkAddress& address, RobotInbox& inbox);
	RobotListener(const RobotListener&) = delete;
	RobotListener& operator=(const RobotListener&) = delete;
	/** Ends the thread; removes the Unix socket's name. */
	~RobotListener();

private:
	/** A robot that is connected, and the line that it has begun. */
	struct Stream
	{
		Descriptor socket;
		std::string line;
		bool too_long = false;  ///< the line's beginning was thrown away
	};
	void run();
	void wait(std::vector<int>& ready) const;
	void receiveDatagram();
	void accept();
	/** False when the stream has ended. */
	bool receiveOn(Stream& stream);
	void takeLines(Stream& stream, std::string_view bytes);

	LinkAddress m_address;
	RobotInbox& m_inbox;
	Descriptor m_socket;
	std::list<Stream> m_streams;
	std::string m_buffer;
	std::atomic<bool> m_ends = false;
	std::thread m_thread;  ///< last: it uses all above
};
}  // namespace explore
