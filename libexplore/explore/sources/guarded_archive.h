// Deserialises MRPT objects from damaged bytes without letting a wrong size take the process down.
#pragma once

#include <explore/sources/checked_stream.h>
#include <mrpt/serialization/CArchive.h>

#include <cstdint>
#include <string>
#include <vector>

namespace explore
{
/** MRPT resizes its containers to whatever counts it reads. Where they are ordinary vectors, AllocationLimit turns an
 *  absurd count into std::bad_alloc; its aligned ones (range images, matrices, 2D scans, point maps) write to the null
 *  pointer instead. This archive knows where in their classes those counts stand and refuses the absurd ones. It
 * refuses flags of range scans that are neither 0 nor 1, too: MRPT copies them into bools, and to look at such a bool
 * is undefined. */
class GuardedArchive : public mrpt::serialization::CArchive
{
public:
	explicit GuardedArchive(CheckedStream& stream) : m_stream(&stream) {}

	/** Why the object was refused; empty when it was not. MRPT replaces exceptions that pass through it. */
	[[nodiscard]] const std::string& refusal() const { return m_refusal; }

protected:
	size_t read(void* buffer, size_t count) override;
	size_t write(const void* buffer, size_t count) override;

private:
	[[noreturn]] void refuse(const std::string& why);
	void checkFlags(const unsigned char* bytes, std::size_t count);
	void endObject();
	void followObjects(const unsigned char* bytes, std::size_t count);
	void followNumbers(const unsigned char* bytes, std::size_t count);
	/** Bytes that MRPT will allocate on account of the number just read; 0 where it is no count or a harmless one. */
	[[nodiscard]] double bytesAskedFor() const;
	[[nodiscard]] double bytesOfRangeScan(std::size_t length, double count, double area) const;
	[[nodiscard]] bool inside(const char* class_name) const;

	CheckedStream* m_stream;
	std::string m_refusal;
	std::vector<std::string> m_classes;  ///< of the objects that are open, innermost last
	std::size_t m_name_length = 0;       ///< of the class name that a header announced
	bool m_version_next = false;
	bool m_is_text = false;      ///< the last read was a text: as many bytes as the number before it said
	bool m_scan_closed = false;  ///< the range scan that is the whole object has met its end
	bool m_movement_by_odometry = false;
	int m_flags_after_time = -1;  ///< of the range scan; −1 before its timestamp

	std::vector<std::uint32_t> m_run;  ///< numbers of equal size read one after the other, the last three
	std::size_t m_run_size = 0;        ///< bytes of each of them
	/** The read before the run. */
	struct Opener
	{
		std::size_t size;
		unsigned char value;  ///< its first byte
		bool is_version;      ///< of an object whose class name has just been read
		bool follows_end;     ///< the read before it closed an object
	};
	Opener m_opener{};
	bool m_last_is_end = false;
};
}  // namespace explore
