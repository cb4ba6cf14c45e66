#include <explore-mrpt/run_input.h>
#include <explore-mrpt/run_state.h>
#include <explore/core/byte_archive.h>
#include <explore/core/errors.h>

#include <utility>

namespace explore::app
{
namespace
{
/** Writes or reads all that goes on from frame to frame. */
template <class Archive>
void exchangeState(Archive& archive, Run& run)
{
	std::vector<std::string> warnings = run.logger.warnings();
	archive(run.tally), archive(run.timing), archive(run.truth), archive(run.depth_check), archive(warnings);
	archive(run.outputs);
	exchange(archive, run.state, run.config.explorer);
	if (run.robot != nullptr) run.robot->exchange(archive);
	if (Archive::kReads) run.logger.takeWarnings(std::move(warnings));
}
}  // namespace

void keepState(Run& run)
{
	ByteWriter state;
	exchangeState(state, run);
	run.keeper.keep({run.beginning, "", run.outputs.sizes(), state.bytes()});
}

bool canGoOn(const Run& run, const std::string& reason)
{
	return run.keeper.keeps() && (reason == kMaxFrames || reason == kInterrupted);
}

void keepLastState(Run& run, const std::string& reason)
{
	if (!run.keeper.keeps()) return;
	if (canGoOn(run, reason))
		keepState(run);
	else
		run.keeper.keep({run.beginning, reason, run.outputs.sizes(), {}});
	run.keeper.finish();
}

void goOnFrom(const Checkpoint& checkpoint, Run& run)
{
	// The recording says again what it said on the way; the state then puts the warnings right.
	ByteReader tally(checkpoint.state);
	tally(run.tally);
	if (run.robot == nullptr) passOver(run.source, run.tally.frames);
	ByteReader state(checkpoint.state);
	exchangeState(state, run);
	if (!state.good() || !state.atEnd()) throw InputError("the state of the run is not that of this configuration");
}
}  // namespace explore::app
