#include "guarded_archive.h"

#include <mrpt/obs/CObservationIMU.h>
#include <mrpt/poses/CPosePDF.h>
#include <mrpt/rtti/CObject.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace explore
{
namespace
{
constexpr const char* kRangeScan = "CObservation3DRangeScan";
constexpr unsigned char kHeaderFlag = 0x80, kEndFlag = 0x88;
/** Far beyond any sensor's image or scan, and small enough for any machine. */
constexpr double kMostBytes = 256.0 * 1024 * 1024;

/** Classes in which all numbers of four bytes are counts or lengths. */
constexpr std::array kCountsOnly = {
    "CObservationIMU",          "CObservationRobotPose", "CObservationImage", "CObservationPointCloud",
    "CObservationVelodyneScan", "CSensoryFrame",         "CActionCollection", "TCamera"};

/** Images store negative sizes where they have colours. */
double magnitude(std::uint32_t number)
{
	return std::abs(static_cast<double>(static_cast<std::int32_t>(number)));
}

bool isPoseDensity(const mrpt::rtti::TRuntimeClassId* id)
{
	return id != nullptr && id->derivedFrom(CLASS_ID(mrpt::poses::CPosePDF));
}
}  // namespace

size_t GuardedArchive::write(const void*, size_t)
{
	throw std::logic_error("GuardedArchive only reads");
}

size_t GuardedArchive::read(void* buffer, size_t count)
{
	if (m_scan_closed) refuse("more follows the byte that ends it");
	m_stream->Read(buffer, count);
	const auto* bytes = static_cast<const unsigned char*>(buffer);
	// The number 1 may also stand before an object, whose header no text of one letter looks like.
	m_is_text = m_run_size == sizeof(std::uint32_t) && m_run.back() == count && (count > 1 || bytes[0] < kHeaderFlag);
	checkFlags(bytes, count);
	followNumbers(bytes, count);
	followObjects(bytes, count);
	if (bytesAskedFor() > kMostBytes)
		refuse("a size of " + std::to_string(m_run.back()) +
		       " asks for more memory than an object of a rawlog can need");
	return count;
}

void GuardedArchive::refuse(const std::string& why)
{
	m_refusal = why;
	throw StreamDamage(why);
}

void GuardedArchive::checkFlags(const unsigned char* bytes, std::size_t count)
{
	if (m_version_next || m_is_text) return;
	const bool all_flags = inside("CObservationIMU") && count == mrpt::obs::COUNT_IMU_DATA_FIELDS;
	if (all_flags && std::any_of(bytes, bytes + count, [](unsigned char flag) { return flag > 1; }))
		refuse("one of its flags is neither 0 nor 1");
	if (!inside(kRangeScan)) return;
	if (count == 8) m_flags_after_time = 0;
	if (count != 1) return;
	// The flags behind the third one after the timestamp are not all flags, and nobody here looks at them.
	if (m_flags_after_time < 3 && bytes[0] > 1 && bytes[0] <= kHeaderFlag)
		refuse("a flag is " + std::to_string(bytes[0]) + " instead of 0 or 1");
	if (m_flags_after_time >= 0) ++m_flags_after_time;
}

void GuardedArchive::followObjects(const unsigned char* bytes, std::size_t count)
{
	const bool header_announced = m_name_length > 0;
	m_version_next = false;
	if (header_announced && count == m_name_length)
	{
		const std::string name(reinterpret_cast<const char*>(bytes), count);
		const auto* id = mrpt::rtti::findRegisteredClass(name);
		if (inside("CActionRobotMovement2D") && !m_movement_by_odometry && !isPoseDensity(id))
			refuse("a movement has a " + name + " for its probability density");
		m_version_next = id != nullptr;
		if (m_version_next) m_classes.push_back(name);
		if (m_version_next && inside(kRangeScan)) m_flags_after_time = -1;
	}
	if (header_announced && !m_version_next && inside(kRangeScan)) refuse("a flag is neither 0 nor 1");
	m_name_length = 0;
	if (count != 1 || m_is_text) return;
	if (bytes[0] == kEndFlag)
		endObject();
	else if (bytes[0] > kHeaderFlag)
		m_name_length = bytes[0] - kHeaderFlag;
}

void GuardedArchive::endObject()
{
	if (m_classes.empty()) return;
	m_scan_closed = m_classes.size() == 1 && inside(kRangeScan);
	m_classes.pop_back();
}

void GuardedArchive::followNumbers(const unsigned char* bytes, std::size_t count)
{
	// A text may well be as long as a number.
	const bool is_number = (count == 2 || count == 4) && !m_is_text;
	if (!is_number || m_run_size != count)
	{
		// A run of other numbers opens this one just as any other read does.
		if (is_number && m_run_size != 0) m_opener = {m_run_size, 0, false, false};
		m_run.clear();
		m_run_size = 0;
	}
	if (!is_number)
	{
		const bool follows_end = m_last_is_end;
		m_last_is_end = count == 1 && bytes[0] == kEndFlag;
		m_opener = {count, bytes[0], m_version_next, follows_end};
		return;
	}
	m_last_is_end = false;
	std::uint32_t number = 0;
	std::memcpy(&number, bytes, count);
	m_run_size = count;
	if (m_run.size() == 3) m_run.erase(m_run.begin());
	m_run.push_back(number);
	// The first number of a movement is its method; all but odometry (0) store a density, which MRPT does not check.
	if (m_opener.is_version && m_run.size() == 1) m_movement_by_odometry = number == 0;
}

bool GuardedArchive::inside(const char* class_name) const
{
	return !m_classes.empty() && m_classes.back().find(class_name) != std::string::npos;
}

double GuardedArchive::bytesAskedFor() const
{
	if (m_run.empty()) return 0;
	const std::size_t length = m_run.size();
	const double count = m_run.back(), area = length >= 2 ? count * m_run[length - 2] : 0;
	if (m_run_size == 2) return inside("CObservationRotatingScan") ? 2 * area : 0;
	if (inside(kRangeScan)) return bytesOfRangeScan(length, count, area);
	const bool after_object = m_opener.size == 1 && m_opener.value == kEndFlag, after_array = m_opener.size > 8;
	if (inside("CMatrix") && m_opener.is_version && length == 2) return 8 * area;
	if (inside("CImage") && length == 2 && m_opener.size == 1) return 3 * magnitude(m_run[0]) * magnitude(m_run[1]);
	if (inside("PointsMap") && length == 1 && (m_opener.is_version || after_array)) return 16 * count;
	if (inside("CObservation2DRangeScan") && length == 1 && after_object) return 4 * count;
	if (inside("CObservationVelodyneScan") && length == 1 && after_object) return 1206 * count;
	if (inside("CObservationOdometry") && length == 1 && after_object) return 16 * count;
	const bool counts_only =
	    std::any_of(kCountsOnly.begin(), kCountsOnly.end(), [&](auto* name) { return inside(name); });
	return counts_only ? 16 * count : 0;
}

double GuardedArchive::bytesOfRangeScan(std::size_t length, double count, double area) const
{
	const bool after_flag = m_opener.size == 1, after_time = m_opener.size == 8;
	// Behind the timestamp there are only lengths of names, and sizes of layers.
	if (m_flags_after_time >= 0) return length == 2 && !after_flag && !after_time ? 2 * area : 16 * count;
	// The first flag behind the sensor's pose: it has points, and this many.
	if (after_flag && length == 1 && m_opener.follows_end) return 16 * count;
	// Behind the next flag come the unit, rows and columns of the range image.
	return after_flag && length == 3 ? 2 * area : 0;
}
}  // namespace explore
