// The typed errors that leave the library; each maps to one exit code of the programs.
#pragma once

#include <stdexcept>

namespace explore
{
/** Wrong command line or configuration: the message names file, line, key, value and what is accepted. Exit code 2. */
struct ConfigError : std::runtime_error
{
	using std::runtime_error::runtime_error;
};

/** Input that cannot be read or is not what it says: the message names the file and byte offset. Exit code 3. */
struct InputError : std::runtime_error
{
	using std::runtime_error::runtime_error;
};

/** A sensor that is gone and did not come back in time. Exit code 4. */
struct SensorLost : std::runtime_error
{
	using std::runtime_error::runtime_error;
};

/** Output that cannot be written: the message names the file and the system's reason. Exit code 5. */
struct OutputError : std::runtime_error
{
	using std::runtime_error::runtime_error;
};
}  // namespace explore
