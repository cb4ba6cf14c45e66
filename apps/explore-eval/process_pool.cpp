#include <common/guarded_main.h>
#include <explore-eval/process_pool.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <system_error>

namespace explore::app
{
namespace
{
/** A temporary file without a name: it is gone with the processes that hold it. */
using Channel = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Channel makeChannel()
{
	Channel channel(std::tmpfile(), &std::fclose);
	if (!channel) throw OutputError("a temporary file: cannot create: " + std::generic_category().message(errno));
	return channel;
}

bool put(std::FILE* file, const std::string& text)
{
	return std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
}

std::string contents(std::FILE* file)
{
	std::string text;
	std::array<char, 65536> buffer{};
	std::rewind(file);
	while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file))
		text.append(buffer.data(), count);
	return text;
}

/** The error that `exit_code` stands for (see guarded_main.h). */
[[noreturn]] void rethrow(int exit_code, const std::string& message)
{
	if (exit_code == kUsageError) throw ConfigError(message);
	if (exit_code == kInputError) throw InputError(message);
	if (exit_code == kOutputError) throw OutputError(message);
	throw std::runtime_error(message);
}

/** Never returns: the child must not run what its parent has still to do. */
[[noreturn]] void runChild(std::size_t task, const std::function<std::string(std::size_t)>& work, std::FILE* channel)
{
	::prctl(PR_SET_PDEATHSIG, SIGTERM);  // NOLINT(cppcoreguidelines-pro-type-vararg): the system's own interface
	const auto body = [&]
	{
		if (!put(channel, work(task))) throw OutputError("a temporary file: cannot write: no space left?");
		return kDone;
	};
	const auto failed = [&](const std::exception& error) { put(channel, error.what()); };
	::_exit(guarded(body, failed));
}

class Pool
{
public:
	Pool(const std::vector<std::string>& names, const std::function<std::string(std::size_t)>& work,
	     const std::function<void(std::size_t)>& done)
	    : m_names(names), m_work(work), m_done(done), m_results(names.size())
	{
	}
	[[nodiscard]] std::size_t running() const { return m_running.size(); }

	void start(std::size_t task)
	{
		m_results[task].channel = makeChannel();
		const pid_t process = ::fork();
		if (process < 0) throw std::system_error(errno, std::generic_category(), "fork");
		if (process == 0) runChild(task, m_work, m_results[task].channel.get());
		m_running[process] = task;
	}

	void waitForOne()
	{
		int status = 0;
		const pid_t process = ::waitpid(-1, &status, 0);
		if (process < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
		const auto found = m_running.find(process);
		if (found == m_running.end()) return;
		const std::size_t task = found->second;
		m_running.erase(found);
		Result& result = m_results[task];
		result.text = contents(result.channel.get());
		result.channel.reset();
		result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalBase + WTERMSIG(status);
		m_done(task);
	}

	std::vector<std::string> texts()
	{
		std::vector<std::string> texts;
		for (Result& result : m_results)
		{
			if (result.exit_code >= kSignalBase)
				throw std::runtime_error(m_names[texts.size()] + ": its process was ended by signal " +
				                         std::to_string(result.exit_code - kSignalBase));
			if (result.exit_code != kDone) rethrow(result.exit_code, result.text);
			texts.push_back(std::move(result.text));
		}
		return texts;
	}

private:
	struct Result
	{
		Channel channel{nullptr, &std::fclose};
		std::string text;
		int exit_code = kDone;
	};
	const std::vector<std::string>& m_names;
	const std::function<std::string(std::size_t)>& m_work;
	const std::function<void(std::size_t)>& m_done;
	std::vector<Result> m_results;
	std::map<pid_t, std::size_t> m_running;
};
}  // namespace

std::vector<std::string> inProcesses(const std::vector<std::string>& names, int jobs,
                                     const std::function<std::string(std::size_t)>& work,
                                     const std::function<void(std::size_t)>& done)
{
	Pool pool(names, work, done);
	std::size_t next = 0;
	while (next < names.size() || pool.running() > 0)
		if (next < names.size() && pool.running() < static_cast<std::size_t>(jobs))
			pool.start(next++);
		else
			pool.waitForOne();
	return pool.texts();
}
}  // namespace explore::app
