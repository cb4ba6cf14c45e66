#include "rawlog_reader.h"

#include <explore/core/errors.h>
#include <explore/sources/allocation_limit.h>
#include <explore/sources/guarded_archive.h>
#include <mrpt/maps/registerAllClasses.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/obs/registerAllClasses.h>
#include <mrpt/rtti/CObject.h>

#include <algorithm>
#include <cctype>
#include <new>
#include <string_view>

namespace explore
{
namespace
{
using mrpt::serialization::CSerializable;

/** Room for the largest objects met in practice (some 100 MB), far below what a damaged count asks for. */
constexpr std::uint64_t kObjectHeadroomBytes = std::uint64_t{1} << 30U;
constexpr unsigned char kObjectEnd = 0x88;
constexpr std::size_t kLongestClassName = 120;

void registerClasses()
{
	static const bool once = []
	{
		mrpt::obs::registerAllClasses_mrpt_obs();
		mrpt::maps::registerAllClasses_mrpt_maps();
		return true;
	}();
	static_cast<void>(once);
}

/** The class name in the object header that `bytes` begin with; empty where they are none. */
std::string classNameOfHeader(std::string_view bytes)
{
	if (bytes.size() < 2) return {};
	const auto first = static_cast<unsigned char>(bytes.front());
	// Before MRPT 0.5.5 the length was a 32-bit number without the flag.
	const std::size_t begin = (first & 0x80U) != 0 ? 1 : 4;
	const std::size_t length = first & 0x7fU;
	if (length == 0 || length > kLongestClassName || begin + length > bytes.size()) return {};
	const std::string name(bytes.substr(begin, length));
	const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == ':'; };
	return std::all_of(name.begin(), name.end(), plain) ? name : std::string();
}

/** True for the classes that a rawlog is made of. */
bool isRawlogEntry(const std::string& class_name)
{
	const auto* id = mrpt::rtti::findRegisteredClass(class_name);
	return id != nullptr &&
	       (id->derivedFrom(CLASS_ID(mrpt::obs::CObservation)) || id->derivedFrom(CLASS_ID(mrpt::obs::CSensoryFrame)) ||
	        id->derivedFrom(CLASS_ID(mrpt::obs::CActionCollection)));
}

/** How many rawlog entries begin in `bytes` before `end`, each told by the end flag of its predecessor. */
std::size_t countEntries(std::string_view bytes, std::size_t end)
{
	std::size_t count = 0;
	for (std::size_t at = 0; at < end; ++at)
	{
		if (static_cast<unsigned char>(bytes[at]) != kObjectEnd) continue;
		const std::string name = classNameOfHeader(bytes.substr(at + 1, kLongestClassName + 1));
		if (!name.empty() && isRawlogEntry(name)) ++count;
	}
	return count;
}

/** The entries that can be told by their headers after the byte `position` (uncompressed) of the file. */
std::size_t countEntriesBehind(const std::filesystem::path& path, std::uint64_t position)
{
	constexpr std::size_t kChunkBytes = std::size_t{1} << 20U;
	constexpr std::size_t kHeaderBytes = kLongestClassName + 2;
	CheckedStream stream(path);
	while (stream.getPosition() < position)
		if (stream.drain(std::min<std::uint64_t>(kChunkBytes, position - stream.getPosition())).empty()) return 0;
	std::size_t count = 0;
	std::string window;
	for (std::string chunk = stream.drain(kChunkBytes); !chunk.empty(); chunk = stream.drain(kChunkBytes))
	{
		window += chunk;
		// A header that the window's end cuts is looked at again with the next chunk.
		const std::size_t safe = window.size() - std::min(window.size(), kHeaderBytes);
		count += countEntries(window, safe);
		window.erase(0, safe);
	}
	return count + countEntries(window, window.size());
}
}  // namespace

RawlogReader::RawlogReader(const std::filesystem::path& path) : m_path(path), m_stream(path)
{
	registerClasses();
	if (m_stream.fileSize() == 0) throw InputError(path.string() + ": is empty; a rawlog is needed");
}

double RawlogReader::progress() const
{
	if (m_ended) return 1.0;
	return std::clamp(static_cast<double>(m_stream.filePosition()) / static_cast<double>(m_stream.fileSize()), 0.0,
	                  1.0);
}

CSerializable::Ptr RawlogReader::readObject()
{
	const AllocationLimit limit(kObjectHeadroomBytes);
	GuardedArchive archive(m_stream);
	try
	{
		return archive.ReadObject();
	}
	catch (const std::bad_alloc&)
	{
		m_refusal = "asks for more memory than an object of a rawlog can need";
		throw;
	}
	catch (const std::exception&)
	{
		m_refusal = archive.refusal();
		throw;
	}
}

CSerializable::Ptr RawlogReader::next()
{
	while (!m_ended)
	{
		Place place{m_stream.getPosition(), m_stream.filePosition(), {}};
		try
		{
			m_ended = m_stream.atEnd();
			if (m_ended) break;
			place.in_object = true;
			place.class_name = classNameOfHeader(m_stream.peek(kLongestClassName + 4));
			CSerializable::Ptr object = readObject();
			++m_objects;
			if (object) return object;
		}
		catch (const std::exception&)
		{
			// MRPT's own text speaks of an end of file whatever happened, so the reason is found here.
			stopAt(place, reasonAt(place));
		}
	}
	return nullptr;
}

std::string RawlogReader::reasonAt(const Place& place) const
{
	if (place.class_name.empty()) return m_stream.failure().empty() ? "no object header" : m_stream.failure();
	if (mrpt::rtti::findRegisteredClass(place.class_name) == nullptr) return "unknown class '" + place.class_name + "'";
	if (!m_refusal.empty()) return place.class_name + ": " + m_refusal;
	return place.class_name + (m_stream.failure().empty() ? " does not parse" : ": " + m_stream.failure());
}

void RawlogReader::stopAt(const Place& place, const std::string& reason)
{
	m_ended = true;
	const std::string where =
	    "at byte " + std::to_string(place.position) + (m_stream.compressed() ? " (uncompressed)" : "") + ": " + reason;
	if (m_objects == 0)
		throw InputError(m_path.string() + ": not a rawlog, or damaged at its start; no object can be read " + where);
	RawlogDamage damage;
	damage.what = "damaged after " + std::to_string(m_objects) + " objects, " + where;
	damage.lost_bytes = m_stream.fileSize() - std::min(m_stream.fileSize(), place.file_position);
	damage.lost_objects = 1 + (place.in_object ? countEntriesBehind(m_path, place.position) : 0);
	m_damage = damage;
}
}  // namespace explore
