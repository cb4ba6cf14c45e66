// A camera that is read by a thread of its own: its latest frame, or that it is away.
#pragma once

#include <explore/openni2/mailbox.h>
#include <explore/sources/source_config.h>

#include <memory>
#include <thread>

namespace explore::openni2
{
class LiveCamera
{
public:
	/** Opens it, without waiting for one that is not there. Throws ConfigError for what the camera does not have, and
	 *  SensorLost with what to check. */
	explicit LiveCamera(const Openni2Config& config);
	/** A camera whose driver does not answer any more is left to itself after 2 s. */
	~LiveCamera();
	LiveCamera(const LiveCamera&) = delete;
	LiveCamera& operator=(const LiveCamera&) = delete;

	/** The latest frame that was not taken yet; no value when none came in time. Throws SensorLost after lost_after_s
	 *  without any. */
	std::optional<RawDepth> take(std::chrono::milliseconds timeout);
	/** What happened since the last call, for the user. */
	std::vector<std::string> takeTold() { return m_mailbox->takeTold(); }
	[[nodiscard]] Mailbox::Counts counts() const { return m_mailbox->counts(); }

private:
	Openni2Config m_config;
	std::shared_ptr<Mailbox> m_mailbox;
	std::thread m_thread;
};
}  // namespace explore::openni2
