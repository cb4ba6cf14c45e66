#include <OpenNI.h>
#include <explore/openni2/capture.h>
#include <explore/openni2/depth_stream.h>
#include <explore/openni2/device_choice.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace explore::openni2
{
namespace
{
using std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kSilence = 1s;
constexpr auto kGlance = 50ms;
constexpr auto kFirstWait = 250ms, kLongestWait = 1000ms;

/** Hears of cameras that come and go; OpenNI2 calls it from threads of its own. */
class PlugEvents : public openni::OpenNI::DeviceConnectedListener, public openni::OpenNI::DeviceDisconnectedListener
{
public:
	explicit PlugEvents(Mailbox& mailbox) : m_mailbox(mailbox)
	{
		openni::OpenNI::addDeviceConnectedListener(this);
		openni::OpenNI::addDeviceDisconnectedListener(this);
	}
	~PlugEvents() override
	{
		openni::OpenNI::removeDeviceConnectedListener(this);
		openni::OpenNI::removeDeviceDisconnectedListener(this);
	}
	PlugEvents(const PlugEvents&) = delete;
	PlugEvents& operator=(const PlugEvents&) = delete;

	void watch(const std::string& uri)
	{
		const std::lock_guard lock(m_mutex);
		m_uri = uri;
		m_gone = false;
	}
	[[nodiscard]] bool gone() const { return m_gone; }

	void onDeviceConnected(const openni::DeviceInfo* /*device*/) override { m_mailbox.plugIn(); }
	void onDeviceDisconnected(const openni::DeviceInfo* device) override
	{
		const std::lock_guard lock(m_mutex);
		if (m_uri == device->getUri()) m_gone = true;
	}

private:
	Mailbox& m_mailbox;
	std::mutex m_mutex;
	std::string m_uri;
	std::atomic<bool> m_gone = false;
};

std::string firstLineOf(const std::string& text)
{
	return text.substr(0, text.find('\n'));
}

class Capture
{
public:
	Capture(const Openni2Config& config, Mailbox& mailbox) : m_config(config), m_mailbox(mailbox), m_events(mailbox) {}

	void run()
	{
		open();
		m_mailbox.begin(nullptr);
		while (!m_mailbox.stopping())
		{
			const std::string end = m_stream ? deliver() : "";
			m_stream.reset();
			if (m_mailbox.stopping()) return;
			if (!end.empty())
			{
				// Who learns of the loss finds out why.
				tellOnce(m_uri + ": " + end + "; trying to open it again");
				m_mailbox.lose();
			}
			rest();
			tryToOpen();
		}
	}

private:
	void open()
	{
		m_uri = chooseDevice(m_config.device);
		m_events.watch(m_uri);
		m_stream = std::make_unique<DepthStream>(m_uri, DepthStream::Origin::camera, m_config);
		m_number.reset();
		++m_connection;
	}
	void tryToOpen()
	{
		try
		{
			open();
		}
		catch (const std::exception& error)
		{
			m_stream.reset();
			tellOnce(firstLineOf(error.what()));
		}
	}
	void rest()
	{
		if (m_mailbox.rest(m_wait))
			m_wait = kFirstWait;
		else
			m_wait = std::min<std::chrono::milliseconds>(2 * m_wait, kLongestWait);
	}
	/** Until frames come again each thing is said once. */
	void tellOnce(const std::string& text)
	{
		if (std::find(m_told.begin(), m_told.end(), text) != m_told.end()) return;
		m_told.push_back(text);
		m_mailbox.tell(text);
	}
	/** Returns why no more frames come; empty when it is to stop. */
	std::string deliver()
	{
		auto heard = steady_clock::now();
		std::string objection;
		while (!m_mailbox.stopping())
		{
			if (m_events.gone()) return "was unplugged";
			try
			{
				if (auto frame = m_stream->read(kGlance))
				{
					heard = steady_clock::now();
					arrive(*std::move(frame));
				}
			}
			catch (const BadFrame& error)
			{
				objection = error.what();
				m_mailbox.discard();
			}
			countGap();
			if (steady_clock::now() - heard > kSilence)
				return objection.empty() ? "no frame for 1 s" : "no usable frame for 1 s: " + objection;
		}
		return "";
	}
	/** OpenNI2 keeps one frame: of those that come faster than they are read, the numbers alone tell. */
	void countGap()
	{
		const int number = m_stream->frameNumber();
		if (m_number && number > *m_number + 1) m_mailbox.miss(static_cast<std::size_t>(number - *m_number - 1));
		if (number >= 0) m_number = number;
	}
	void arrive(RawDepth frame)
	{
		const auto now = steady_clock::now();
		if (!m_told.empty())
			m_mailbox.tell(
			    m_uri + ": delivers frames again" +
			    mrpt::format(", %.1f s after the last one", std::chrono::duration<double>(now - m_delivered).count()));
		m_told.clear();
		m_wait = kFirstWait;
		m_delivered = now;
		frame.connection = m_connection;
		m_mailbox.put(std::move(frame));
	}

	const Openni2Config& m_config;
	Mailbox& m_mailbox;
	Library m_library;
	PlugEvents m_events;
	std::unique_ptr<DepthStream> m_stream;
	std::string m_uri;
	int m_connection = 0;
	std::optional<int> m_number;  ///< of the last frame of this connection
	std::chrono::milliseconds m_wait = kFirstWait;
	std::vector<std::string> m_told;
	steady_clock::time_point m_delivered = steady_clock::now();
};
}  // namespace

void capture(const Openni2Config& config, Mailbox& mailbox)
{
	try
	{
		Capture(config, mailbox).run();
	}
	catch (const std::exception&)
	{
		mailbox.begin(std::current_exception());
	}
	mailbox.end();
}
}  // namespace explore::openni2
