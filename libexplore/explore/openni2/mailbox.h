// Between the thread that reads a camera and the one that explores: the latest frame, and what happened meanwhile.
#pragma once

#include <explore/openni2/raw_depth.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace explore::openni2
{
/** All methods may be called from any thread. A frame that nobody took gives way to the next and is counted. */
class Mailbox
{
public:
	using Duration = std::chrono::steady_clock::duration;

	// The reading thread's side.
	void put(RawDepth frame)
	{
		const std::lock_guard lock(m_mutex);
		if (m_frame) ++m_dropped;
		m_frame = std::move(frame);
		m_heard = std::chrono::steady_clock::now();
		m_changed.notify_all();
	}
	/** Frames that the camera took and this machine never got. */
	void miss(std::size_t frames)
	{
		const std::lock_guard lock(m_mutex);
		m_dropped += frames;
	}
	void discard()
	{
		const std::lock_guard lock(m_mutex);
		++m_bad;
	}
	/** No more frames come until further notice: whoever waits for one need not. */
	void lose()
	{
		const std::lock_guard lock(m_mutex);
		m_lost = true;
		m_changed.notify_all();
	}
	/** What the user should read; the last one is why frames stay away. */
	void tell(const std::string& text)
	{
		const std::lock_guard lock(m_mutex);
		m_told.push_back(text);
		m_trouble = text;
	}
	/** The camera was opened; or, with an error, will not be. */
	void begin(const std::exception_ptr& error)
	{
		const std::lock_guard lock(m_mutex);
		m_begun = true;
		m_error = error;
		m_heard = std::chrono::steady_clock::now();
		m_changed.notify_all();
	}
	void end()
	{
		const std::lock_guard lock(m_mutex);
		m_ended = true;
		m_changed.notify_all();
	}
	/** Waits for something to do before the time is over; returns whether a camera was plugged in. */
	bool rest(Duration time)
	{
		std::unique_lock lock(m_mutex);
		m_changed.wait_for(lock, time, [this] { return m_stop || m_plugged_in; });
		return std::exchange(m_plugged_in, false);
	}
	void plugIn()
	{
		const std::lock_guard lock(m_mutex);
		m_plugged_in = true;
		m_changed.notify_all();
	}
	[[nodiscard]] bool stopping() const
	{
		const std::lock_guard lock(m_mutex);
		return m_stop;
	}

	// The exploring thread's side.
	/** No value when none came in time, and at once, once, when the camera was lost. */
	std::optional<RawDepth> take(Duration timeout)
	{
		std::unique_lock lock(m_mutex);
		m_changed.wait_for(lock, timeout, [this] { return m_frame || m_lost; });
		if (!m_frame) m_lost = false;
		return std::exchange(m_frame, std::nullopt);
	}
	std::vector<std::string> takeTold()
	{
		const std::lock_guard lock(m_mutex);
		return std::exchange(m_told, {});
	}
	/** Whether it was opened, or failed, in time; throws what it failed with. */
	bool awaitBegin(Duration timeout)
	{
		std::unique_lock lock(m_mutex);
		m_changed.wait_for(lock, timeout, [this] { return m_begun; });
		if (m_error) std::rethrow_exception(std::exchange(m_error, nullptr));
		return m_begun;
	}
	void stop()
	{
		const std::lock_guard lock(m_mutex);
		m_stop = true;
		m_changed.notify_all();
	}
	bool awaitEnd(Duration timeout)
	{
		std::unique_lock lock(m_mutex);
		return m_changed.wait_for(lock, timeout, [this] { return m_ended; });
	}

	struct Counts
	{
		std::size_t dropped = 0, bad = 0;
		Duration silence{};   ///< since the last frame, or since it was opened
		std::string trouble;  ///< what was told last
	};
	[[nodiscard]] Counts counts() const
	{
		const std::lock_guard lock(m_mutex);
		return {m_dropped, m_bad, std::chrono::steady_clock::now() - m_heard, m_trouble};
	}

private:
	mutable std::mutex m_mutex;
	std::condition_variable m_changed;
	std::optional<RawDepth> m_frame;
	std::vector<std::string> m_told;
	std::string m_trouble;
	std::exception_ptr m_error;
	std::chrono::steady_clock::time_point m_heard = std::chrono::steady_clock::now();
	std::size_t m_dropped = 0, m_bad = 0;
	bool m_lost = false, m_begun = false, m_ended = false, m_stop = false, m_plugged_in = false;
};
}  // namespace explore::openni2
