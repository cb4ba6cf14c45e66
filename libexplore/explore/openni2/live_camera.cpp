#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/openni2/capture.h>
#include <explore/openni2/library.h>
#include <explore/openni2/live_camera.h>

namespace explore::openni2
{
namespace
{
using namespace std::chrono_literals;

constexpr auto kPatience = 2s;

Mailbox::Duration durationOf(double seconds)
{
	return std::chrono::duration_cast<Mailbox::Duration>(std::chrono::duration<double>(seconds));
}

void endThread(Mailbox& mailbox, std::thread& thread)
{
	mailbox.stop();
	// The thread owns all that it uses, so one that hangs in a driver may be left behind.
	if (mailbox.awaitEnd(kPatience))
		thread.join();
	else
		thread.detach();
}
}  // namespace

LiveCamera::LiveCamera(const Openni2Config& config)
    : m_config(config),
      m_mailbox(std::make_shared<Mailbox>()),
      m_thread([config, mailbox = m_mailbox] { capture(config, *mailbox); })
{
	try
	{
		if (!m_mailbox->awaitBegin(durationOf(config.lost_after_s)))
			throw SensorLost("the camera did not open in " + formatNumber(config.lost_after_s) + " s\n" +
			                 whatToCheck());
	}
	catch (...)
	{
		endThread(*m_mailbox, m_thread);
		throw;
	}
}

LiveCamera::~LiveCamera()
{
	endThread(*m_mailbox, m_thread);
}

std::optional<RawDepth> LiveCamera::take(std::chrono::milliseconds timeout)
{
	if (auto frame = m_mailbox->take(timeout)) return frame;
	const Mailbox::Counts counts = m_mailbox->counts();
	if (counts.silence < durationOf(m_config.lost_after_s)) return std::nullopt;
	throw SensorLost("the camera is lost: no frame for " + formatNumber(m_config.lost_after_s) + " s" +
	                 (counts.trouble.empty() ? "" : " (" + counts.trouble + ")") + "\n" + whatToCheck());
}
}  // namespace explore::openni2
