// explore-rawlog, for the tests that are told where it is.
#pragma once

#include "apps/program.h"

namespace explore::test
{
/** Runs explore-rawlog to its end. */
inline ProgramResult exploreRawlog(const std::vector<std::string>& arguments, const Program::Setup& setup = {})
{
	return Program(EXPLORE_RAWLOG_PROGRAM, arguments, setup).wait();
}
}  // namespace explore::test
