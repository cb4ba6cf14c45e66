#include "apps/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

namespace explore::test
{
namespace
{
void redirect(const std::filesystem::path& path, int descriptor)
{
	const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
	if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
}

[[noreturn]] void become(const std::string& program, std::vector<std::string> arguments, const Program::Setup& setup)
{
	if (setup.file_size_limit > 0)
	{
		const rlimit limit{setup.file_size_limit, setup.file_size_limit};
		::setrlimit(RLIMIT_FSIZE, &limit);
	}
	if (!setup.working_folder.empty() && ::chdir(setup.working_folder.c_str()) != 0) ::_exit(126);
	arguments.insert(arguments.begin(), program);
	std::vector<char*> argv;
	for (auto& argument : arguments) argv.push_back(argument.data());
	argv.push_back(nullptr);
	::execv(program.c_str(), argv.data());
	::_exit(127);
}
}  // namespace

Program::Program(const std::string& program, const std::vector<std::string>& arguments, const Setup& setup)
    : m_out(setup.standard_output.empty() ? testFolder() / "stdout.txt" : std::filesystem::path(setup.standard_output)),
      m_err(testFolder() / "stderr.txt")
{
	std::filesystem::create_directories(testFolder());
	m_process = ::fork();
	if (m_process < 0) throw std::runtime_error("fork failed");
	if (m_process > 0) return;
	redirect(m_out, STDOUT_FILENO);
	redirect(m_err, STDERR_FILENO);
	become(program, arguments, setup);
}

bool Program::running() const
{
	siginfo_t ended{};
	::waitid(P_PID, static_cast<id_t>(m_process), &ended, WEXITED | WNOHANG | WNOWAIT);
	return ended.si_pid == 0;
}

void Program::signal(int number) const
{
	::kill(m_process, number);
}

ProgramResult Program::wait()
{
	int status = 0;
	::waitpid(m_process, &status, 0);
	ProgramResult result;
	result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
	if (std::filesystem::is_regular_file(m_out)) result.out = readFile(m_out);
	result.err = readFile(m_err);
	return result;
}

std::vector<std::string> runOf(const std::filesystem::path& log, const std::filesystem::path& out,
                               const std::vector<std::string>& more)
{
	std::vector<std::string> arguments{"--ini",   "corridor.ini", "--rawlog",  log.string(),
	                                   "--quiet", "--out",        out.string()};
	arguments.insert(arguments.end(), more.begin(), more.end());
	return arguments;
}

ProgramResult exploreMrpt(const std::vector<std::string>& arguments, const Program::Setup& setup)
{
	return Program(EXPLORE_MRPT_PROGRAM, arguments, setup).wait();
}

}  // namespace explore::test
