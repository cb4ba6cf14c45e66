// The objects of a rawlog one after the other, and an honest account of where and why reading stopped.
#pragma once

#include <explore/sources/checked_stream.h>
#include <mrpt/serialization/CSerializable.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace explore
{
/** What is wrong with a rawlog file. */
struct RawlogDamage
{
	std::string what;              ///< reason and byte offset
	std::uint64_t lost_bytes = 0;  ///< of the file, from the damaged object on
	/** The damaged object (or none, where only the stream's end does not check out) and those recognised behind it. */
	std::size_t lost_objects = 0;
};

class RawlogReader
{
public:
	/** Throws InputError for a file that is missing, empty or unreadable. */
	explicit RawlogReader(const std::filesystem::path& path);

	/** The next object, never null; null pointer at the end, be it a clean one or damage(). Throws InputError when not
	 *  even the first object can be read: then the file is no rawlog. */
	mrpt::serialization::CSerializable::Ptr next();

	[[nodiscard]] const std::optional<RawlogDamage>& damage() const { return m_damage; }
	[[nodiscard]] std::size_t objects() const { return m_objects; }
	[[nodiscard]] bool compressed() const { return m_stream.compressed(); }
	[[nodiscard]] std::uint64_t fileSize() const { return m_stream.fileSize(); }
	/** Share of the file that was read, 0–1. */
	[[nodiscard]] double progress() const;

private:
	/** Where an object begins. */
	struct Place
	{
		std::uint64_t position, file_position;
		std::string class_name;  ///< as its header says; empty at the end of the file or where it is no header
		bool in_object = false;
	};
	mrpt::serialization::CSerializable::Ptr readObject();
	[[nodiscard]] std::string reasonAt(const Place& place) const;
	void stopAt(const Place& place, const std::string& reason);

	std::filesystem::path m_path;
	CheckedStream m_stream;
	std::size_t m_objects = 0;
	bool m_ended = false;
	std::string m_refusal;  ///< why the last object was refused; empty where the stream or its contents say why
	std::optional<RawlogDamage> m_damage;
};
}  // namespace explore
