// Runs a program as a user does and keeps what it says.
#pragma once

#include "support/test_files.h"

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore::test
{
struct ProgramResult
{
	int exit_code = -1;  ///< 128 + signal when it was killed by one
	std::string out, err;
};

/** A program that is running; its output goes to files in a folder of the test. */
class Program
{
public:
	/** `standard_output` replaces the file that the result's `out` is read from, e.g. "/dev/full". `file_size_limit` in
	 *  bytes stands for a full disk; 0 = none. */
	struct Setup
	{
		std::string standard_output;
		std::size_t file_size_limit = 0;
		std::filesystem::path working_folder;
	};
	Program(const std::string& program, const std::vector<std::string>& arguments, const Setup& setup);

	[[nodiscard]] bool running() const;
	void signal(int number) const;
	ProgramResult wait();

private:
	pid_t m_process = -1;
	std::filesystem::path m_out, m_err;
};

/** Arguments of explore-mrpt for a quiet run of corridor.ini over a recording; `more` comes last. */
std::vector<std::string> runOf(const std::filesystem::path& log, const std::filesystem::path& out,
                               const std::vector<std::string>& more = {});
/** Runs explore-mrpt to its end. */
ProgramResult exploreMrpt(const std::vector<std::string>& arguments, const Program::Setup& setup = {});
}  // namespace explore::test
