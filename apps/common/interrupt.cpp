#include <common/interrupt.h>

#include <atomic>
#include <csignal>

namespace explore::app
{
namespace
{
// A signal handler can reach nothing but a global, and only a lock-free one.
std::atomic<int> g_signal{0};
static_assert(std::atomic<int>::is_always_lock_free);

void remember(int signal)
{
	g_signal = signal;
}
}  // namespace

void catchSignals()
{
	struct sigaction action = {};
	action.sa_handler = remember;
	action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
	sigaction(SIGINT, &action, nullptr);
	sigaction(SIGTERM, &action, nullptr);
	struct sigaction ignore = {};
	ignore.sa_handler = SIG_IGN;
	sigaction(SIGPIPE, &ignore, nullptr);
}

int signalReceived()
{
	return g_signal;
}
}  // namespace explore::app
