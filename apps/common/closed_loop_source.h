// A simulated robot as a source: what the explorer decides about a frame moves it before the next one.
#pragma once

#include <common/app_config.h>
#include <explore/core/byte_archive.h>
#include <explore/core/contact.h>
#include <explore/core/truth.h>
#include <explore/sources/source.h>

#include <filesystem>
#include <memory>

namespace explore::app
{
/** What is really so at the last frame. */
struct TrueState
{
	double t_s = 0;  ///< since the first frame
	mrpt::poses::CPose3D map_from_robot;
	std::vector<Contact> contacts;          ///< so far
	std::optional<double> min_clearance_m;  ///< of the moving body, so far; no value before it moved
};

/** Ends, as every source, with a frame that has no value: at the time limit. */
class ClosedLoopSource : public FrameSource
{
public:
	virtual void obey(const Command& command) = 0;
	[[nodiscard]] virtual TrueState trueState() const = 0;
	/** Where the robot could and may get to from its start, as the world and [bounds] are; takes up to a second or two.
	 */
	[[nodiscard]] virtual TruthReach reachable() const = 0;
	/** Writes, or reads, all that a source that was opened alike needs to go on from here. */
	virtual void exchange(ByteWriter& archive) = 0;
	virtual void exchange(ByteReader& archive) = 0;
};

/** The simulator that `loaded` describes; its world is found as findWorldOfIni() does, but where the command line names
 *  it. `logger` outlives it and is told what is odd about the world. Throws ConfigError, also where the program was
 *  built without the simulator, and InputError. */
std::unique_ptr<ClosedLoopSource> openSimulator(const LoadedConfig& loaded, mrpt::system::COutputLogger& logger);
}  // namespace explore::app
