// Runs a program's body and turns the typed errors of the library into exit codes and one line on stderr.
#pragma once

#include <common/exit_codes.h>
#include <explore/core/errors.h>

#include <csignal>
#include <iostream>
#include <string_view>

namespace explore::app
{
/** The result of `body()`, or the exit code of what it threw, after `failed(error)`. */
template <class Body, class Failed>
int guarded(const Body& body, const Failed& failed)
{
	const auto fail = [&](int exit_code, const std::exception& error)
	{
		failed(error);
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

/** guarded() for main(): an error becomes a line on standard error. Beyond a file size limit a write fails and is
 *  reported as any other, instead of a signal that ends the program. */
template <class Body>
int guardedMain(std::string_view program, const Body& body)
{
	std::signal(SIGXFSZ, SIG_IGN);
	return guarded(body,
	               [program](const std::exception& error) { std::cerr << program << ": " << error.what() << '\n'; });
}
}  // namespace explore::app
