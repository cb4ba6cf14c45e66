#include <explore-mrpt/checkpoint.h>
#include <explore/config/ini.h>
#include <explore/core/byte_archive.h>
#include <explore/core/errors.h>
#include <explore/sinks/output_file.h>
#include <explore/sinks/output_folder.h>
#include <zlib.h>

#include <fstream>
#include <sstream>
#include <utility>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

/** The first line of the file: states of other versions have other fields. */
std::string headLine()
{
	return "explore-mrpt state 4 of version " + version() + "\n";
}

/** What stands between the first line and the packed bytes. */
struct Seal
{
	std::uint64_t bytes = 0, packed_bytes = 0;
	std::uint32_t crc = 0;  ///< of the packed bytes, CRC-32
};

std::uint32_t crcOf(std::string_view bytes)
{
	return static_cast<std::uint32_t>(
	    ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));  // NOLINT: zlib's own type
}

std::string packed(const std::string& bytes)
{
	uLongf size = ::compressBound(bytes.size());
	std::string result(size, '\0');
	// NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): zlib's own type
	const int failed = ::compress2(reinterpret_cast<Bytef*>(result.data()), &size,
	                               reinterpret_cast<const Bytef*>(bytes.data()),  // NOLINT: the same
	                               bytes.size(), Z_BEST_SPEED);
	if (failed != Z_OK) throw OutputError("the run's state cannot be packed: out of memory");
	result.resize(size);
	return result;
}

/** No value for what is not so packed. */
std::optional<std::string> unpacked(std::string_view bytes, std::uint64_t size)
{
	if (size > kMostBytes) return std::nullopt;
	std::string result(size, '\0');
	uLongf got = size;
	// NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): zlib's own type
	const int failed = ::uncompress(reinterpret_cast<Bytef*>(result.data()), &got,
	                                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());  // NOLINT: the same
	if (failed != Z_OK || got != size) return std::nullopt;
	return result;
}

std::string fileContent(Checkpoint& checkpoint)
{
	ByteWriter content;
	content(checkpoint);
	const std::string body = packed(content.bytes());
	Seal seal{content.bytes().size(), body.size(), crcOf(body)};
	ByteWriter sealed;
	sealed(seal);
	return headLine() + sealed.bytes() + body;
}

[[noreturn]] void failReading(const fs::path& file, const std::string& why)
{
	throw InputError(file.string() + ": " + why);
}

std::string readWhole(const fs::path& file)
{
	std::ifstream stream(file, std::ios::binary);
	if (!stream)
		failReading(
		    file,
		    "there is no state of a run to go on from: --resume takes the folder of a run that kept one, which a "
		    "run with a camera does not: its frames are gone");
	std::ostringstream content;
	content << stream.rdbuf();
	return std::move(content).str();
}

/** Waits until the files of the run are on disk as far as they were written. */
void syncOutputs(const fs::path& folder, const OutputSizes& sizes)
{
	const OutputPaths paths = outputPaths(folder);
	const auto sync = [](const fs::path& path, std::uint64_t bytes)
	{
		if (bytes > 0) syncFile(path);
	};
	sync(paths.frames, sizes.frames), sync(paths.timing, sizes.timing);
	sync(paths.trajectory, sizes.trajectory), sync(paths.truth, sizes.truth);
	sync(paths.report_log, sizes.report), sync(paths.annotated, sizes.annotated);
}
}  // namespace

RunBeginning beginningOf(const Options& options, const LoadedConfig& loaded)
{
	RunBeginning beginning;
	beginning.ini = options.ini;
	beginning.rawlog = options.rawlog;
	beginning.oni = options.oni;
	beginning.world = options.world;
	beginning.max_frames = options.max_frames;
	beginning.realtime = options.realtime;
	beginning.working_folder = fs::current_path().string();
	beginning.loaded_ini = loaded.ini.string();
	// What was given is kept as it was given: an ini cannot hold every name.
	AppConfig config = loaded.config;
	if (!options.rawlog.empty()) config.source.rawlog.clear();
	if (!options.oni.empty()) config.source.oni.clear();
	if (!options.world.empty()) config.source.simulator.world.clear();
	beginning.config = dumpConfig(config);
	beginning.sensor_poses = loaded.config.source.sensor_poses;
	return beginning;
}

LoadedConfig loadedConfig(const RunBeginning& beginning)
{
	LoadedConfig loaded;
	loaded.ini = beginning.loaded_ini;
	loadIniText("the state's configuration", beginning.config, {},
	            [&](FieldVisitor& visitor) { describe(visitor, loaded.config); });
	SourceConfig& source = loaded.config.source;
	if (!beginning.rawlog.empty()) source.rawlog = beginning.rawlog;
	if (!beginning.oni.empty()) source.oni = beginning.oni;
	if (!beginning.world.empty()) source.simulator.world = beginning.world;
	source.sensor_poses = beginning.sensor_poses;
	return loaded;
}

Options continuedOptions(const Options& given, const RunBeginning& beginning)
{
	Options options = given;
	options.ini = beginning.ini;
	options.rawlog = beginning.rawlog;
	options.oni = beginning.oni;
	options.world = beginning.world;
	if (!options.max_frames) options.max_frames = beginning.max_frames;
	options.realtime = options.realtime || beginning.realtime;
	options.out = given.resume;
	return options;
}

Checkpoint readCheckpoint(const fs::path& folder)
{
	const fs::path file = outputPaths(folder).state;
	const std::string content = readWhole(file);
	const std::string head = headLine();
	if (!content.starts_with("explore-mrpt state ")) failReading(file, "is not the state of a run of explore-mrpt");
	if (!content.starts_with(head))
		failReading(file, "was written by another version of explore-mrpt: \"" + content.substr(0, content.find('\n')) +
		                      "\" instead of \"" + head.substr(0, head.size() - 1) + "\"");
	ByteReader sealed(std::string_view(content).substr(head.size()));
	Seal seal;
	sealed(seal);
	const std::string_view body = sealed.rest();
	if (!sealed.good() || body.size() != seal.packed_bytes)
		failReading(file, "is cut off after " + std::to_string(content.size()) + " bytes");
	const auto bytes = crcOf(body) == seal.crc ? unpacked(body, seal.bytes) : std::nullopt;
	if (!bytes) failReading(file, "is damaged: its checksum is wrong");
	Checkpoint checkpoint;
	ByteReader reader(*bytes);
	reader(checkpoint);
	if (!reader.good() || !reader.atEnd()) failReading(file, "is damaged: it is not what its version writes");
	return checkpoint;
}

CheckpointKeeper::CheckpointKeeper(std::optional<fs::path> file, double period_s)
    : m_file(std::move(file)), m_period_s(period_s)
{
	if (keeps()) makeFolder(m_file->parent_path());
}

bool CheckpointKeeper::due() const
{
	using namespace std::chrono_literals;
	if (!keeps()) return false;
	if (!m_kept_at) return true;
	if (m_writing.valid() && m_writing.wait_for(0s) != std::future_status::ready) return false;
	return std::chrono::duration<double>(std::chrono::steady_clock::now() - *m_kept_at).count() >= m_period_s;
}

void CheckpointKeeper::keep(Checkpoint checkpoint)
{
	finish();
	m_kept_at = std::chrono::steady_clock::now();
	m_writing = std::async(std::launch::async,
	                       [file = *m_file, checkpoint = std::move(checkpoint)]() mutable
	                       {
		                       const std::string content = fileContent(checkpoint);
		                       syncOutputs(file.parent_path().parent_path(), checkpoint.files);
		                       writeFileAtomically(file, content);
	                       });
}

void CheckpointKeeper::finish()
{
	if (m_writing.valid()) m_writing.get();
}
}  // namespace explore::app
