// Runs a program's body and turns the typed errors of the library into exit codes and one line on stderr.
#pragma once

#include <explore-mrpt/exit_codes.h>
#include <explore/core/errors.h>

#include <iostream>
#include <string_view>

namespace explore::app
{
/** The result of `body()`, or the exit code of what it threw. */
template <class Body>
int guardedMain(std::string_view program, const Body& body)
{
	const auto fail = [program](int exit_code, const std::exception& error)
	{
		std::cerr << program << ": " << error.what() << '\n';
		return exit_code;
	};
	try
	{
		return body();
	}
	catch (const ConfigError& error)
	{
		return fail(kUsageError, error);
	}
	catch (const InputError& error)
	{
		return fail(kInputError, error);
	}
	catch (const SensorLost& error)
	{
		return fail(kSensorLost, error);
	}
	catch (const OutputError& error)
	{
		return fail(kOutputError, error);
	}
	catch (const std::exception& error)
	{
		return fail(kInternalError, error);
	}
}
}  // namespace explore::app
