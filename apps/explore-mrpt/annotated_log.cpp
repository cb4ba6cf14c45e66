#include <explore-mrpt/annotated_log.h>
#include <explore/core/errors.h>
#include <explore/sources/depth_conversion.h>
#include <explore/sources/external_files.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <algorithm>
#include <utility>

namespace explore::app
{
namespace
{
namespace fs = std::filesystem;

/** A part of the file is written when it has so many bytes, even within a frame's. */
constexpr std::size_t kPartBytes = std::size_t{8} << 20U;

/** A gzip file of its own; several one after the other are one, too. The same bytes give the same. */
std::string gzipped(const std::string& bytes)
{
	constexpr int kGzipOnly = 15 + 16, kMemory = 8;  // zlib's largest window, with gzip's header; its usual memory
	z_stream stream{};
	if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzipOnly, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
		throw std::bad_alloc();
	std::string packed(deflateBound(&stream, bytes.size()), '\0');
	// NOLINTNEXTLINE: zlib's own types; it reads only
	stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
	stream.avail_in = static_cast<uInt>(bytes.size());
	stream.next_out = reinterpret_cast<Bytef*>(packed.data());  // NOLINT: the same
	stream.avail_out = static_cast<uInt>(packed.size());
	deflate(&stream, Z_FINISH);
	packed.resize(stream.total_out);
	deflateEnd(&stream);
	return packed;
}

mrpt::obs::CObservationComment commentAt(LogTime time, std::string text)
{
	mrpt::obs::CObservationComment comment;
	comment.timestamp = time;
	comment.text = std::move(text);
	return comment;
}
}  // namespace

AnnotatedInput annotatedInput(const RunBeginning& beginning, const SourceConfig& config, const SourceReport& source)
{
	AnnotatedInput input;
	input.comment = "explore-mrpt " + version() + "\n" + source.kind + ": " + source.path + "\n\n" + beginning.config;
	if (source.kind != "rawlog") return input;
	input.rawlog = source.path;
	input.images = fs::absolute(imagesFolderOf(input.rawlog, config.images_folder));
	return input;
}

AnnotatedLog::AnnotatedLog(const Files& files, AnnotatedInput input, const RobotConfig& robot)
    : m_files(files), m_input(std::move(input)), m_robot(robot), m_file(files.log)
{
	if (!m_input.rawlog.empty()) m_reader = std::make_unique<RawlogReader>(m_input.rawlog);
}

AnnotatedLog::AnnotatedLog(const Files& files, AnnotatedInput input, const RobotConfig& robot, const Place& place)
    : m_files(files),
      m_input(std::move(input)),
      m_robot(robot),
      m_file(OutputFile::continued(files.log, place.bytes)),
      m_begun(place.bytes > 0)
{
	if (!m_input.rawlog.empty()) m_reader = std::make_unique<RawlogReader>(m_input.rawlog);
	while (m_inputs < place.inputs)
	{
		const auto object = m_reader ? m_reader->next() : nullptr;
		if (!object)
			throw InputError(m_input.rawlog.string() + ": has " + std::to_string(m_inputs) + " objects, but " +
			                 files.log.string() + " holds " + std::to_string(place.inputs) +
			                 " of it: it is not the same recording");
		++m_inputs;
		if (const auto comment = std::dynamic_pointer_cast<mrpt::obs::CObservationComment>(object))
			commentWith(comment->text);
	}
}

void AnnotatedLog::add(const DepthFrame& frame, const FrameSketch& sketch)
{
	if (!std::exchange(m_begun, true)) put(commentAt(frame.timestamp, m_input.comment));
	if (m_reader)
		copyUpTo(frame);
	else if (const auto depth = depthObservationOf(frame))
		put(*depth);
	for (const auto& annotation : annotationsOf(frame, sketch, m_robot)) put(*annotation);
	flush();
}

void AnnotatedLog::addRest()
{
	while (m_reader && copyOne({}))
	{
	}
	flush();
}

void AnnotatedLog::copyUpTo(const DepthFrame& frame)
{
	const auto copied = [&]
	{
		const auto found = std::ranges::find(m_depths_copied, frame.timestamp);
		if (found == m_depths_copied.end()) return false;
		m_depths_copied.erase(m_depths_copied.begin(), found + 1);
		return true;
	};
	while (!copied())
		if (!copyOne(frame.sensor_label)) return;
}

bool AnnotatedLog::copyOne(const std::optional<std::string>& depth_label)
{
	const auto object = m_reader->next();
	if (!object) return false;
	++m_inputs;
	m_depths_copied.clear();
	std::vector<mrpt::obs::CObservation::Ptr> observations;
	if (const auto sensory_frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object))
		observations.assign(sensory_frame->begin(), sensory_frame->end());
	else if (const auto observation = std::dynamic_pointer_cast<mrpt::obs::CObservation>(object))
		observations.push_back(observation);
	for (const auto& observation : observations)
	{
		if (!observation) continue;
		copy(*observation);
		if (depth_label && observation->sensorLabel == *depth_label && isDepthObservation(*observation))
		{
			// As the source has it: a frame without a time has that of the frame before.
			if (isUsable(observation->timestamp)) m_last_depth = observation->timestamp;
			m_depths_copied.push_back(m_last_depth.value_or(mrpt::Clock::fromDouble(0.0)));
		}
	}
	return true;
}

void AnnotatedLog::copy(const mrpt::obs::CObservation& observation)
{
	if (storesExternally(observation)) linkImages();
	if (const auto* comment = dynamic_cast<const mrpt::obs::CObservationComment*>(&observation))
		return put(commentAt(comment->timestamp, commentWith(comment->text)));
	put(observation);
}

/** MRPT keeps the last comment of a log alone: each has what those before it said. */
const std::string& AnnotatedLog::commentWith(const std::string& text)
{
	m_input.comment += "\nComment of the input:\n" + text + "\n";
	return m_input.comment;
}

/** The name is the one that MRPT's programs and this one look for beside the log. */
void AnnotatedLog::linkImages() const
{
	std::error_code error;
	if (fs::is_symlink(m_files.images, error)) return;
	fs::create_directory_symlink(m_input.images, m_files.images, error);
	if (error)
		throw OutputError(m_files.images.string() + ": cannot link it to " + m_input.images.string() +
		                  ", where the input's external images are: " + error.message());
}

void AnnotatedLog::put(const mrpt::serialization::CSerializable& object)
{
	mrpt::io::CMemoryStream stream;
	mrpt::serialization::archiveFrom(stream).WriteObject(object);
	m_bytes.append(static_cast<const char*>(stream.getRawBufferData()), stream.getTotalBytesCount());
	if (m_bytes.size() >= kPartBytes) flush();
}

void AnnotatedLog::flush()
{
	if (m_bytes.empty()) return;
	m_file.write(gzipped(std::exchange(m_bytes, {})));
}
}  // namespace explore::app
