// Values as bytes and back, for files that only the machine that wrote them reads.
#pragma once

#include <explore/core/for_each_field.h>
#include <mrpt/core/Clock.h>
#include <mrpt/poses/CPose3D.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace explore
{
/** Types whose bytes are their value. */
template <class Value>
inline constexpr bool kPlain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;
template <class Scalar, int kRows, int kColumns>
inline constexpr bool kPlain<Eigen::Matrix<Scalar, kRows, kColumns>> = kRows > 0 && kColumns > 0;
template <class Scalar, int kRows>
inline constexpr bool kPlain<Eigen::Array<Scalar, kRows, 1>> = kRows > 0;
template <class Value, std::size_t kSize>
inline constexpr bool kPlain<std::array<Value, kSize>> = kPlain<Value>;

/** The pose made of the same numbers: its place, its rotation and its angles are all what they were, to the last bit.
 */
mrpt::poses::CPose3D poseFrom(const Eigen::Vector3d& place, const Eigen::Matrix3d& rotation,
                              const Eigen::Vector3d& yaw_pitch_roll);

/** The shared part of ByteWriter and ByteReader: how composed values fall into plain ones. A class with private members
 *  has a member template exchange(archive); a struct may have a function template exchange(archive, struct&) beside it,
 *  else it falls into its fields, however many it has. What is exchanged is written or read: one list for both ways. */
template <class Archive>
class ByteArchive
{
public:
	template <class Value>
	void operator()(Value& value)
	{
		if constexpr (kPlain<Value>)
			self().raw(&value, sizeof(value));
		else if constexpr (requires { value.exchange(self()); })
			value.exchange(self());
		else if constexpr (requires { exchange(self(), value); })
			exchange(self(), value);
		else
			forEachField(value, [this](auto& field) { (*this)(field); });
	}
	void operator()(bool& flag)
	{
		auto byte = static_cast<std::uint8_t>(flag);
		self().raw(&byte, 1);
		flag = byte != 0;
	}
	void operator()(std::string& text) { blocks(text, 1); }
	void operator()(mrpt::Clock::time_point& time)
	{
		auto ticks = time.time_since_epoch().count();
		(*this)(ticks);
		time = mrpt::Clock::time_point(mrpt::Clock::duration(ticks));
	}
	void operator()(mrpt::poses::CPose3D& pose)
	{
		Eigen::Vector3d place(pose.x(), pose.y(), pose.z()), angles(pose.yaw(), pose.pitch(), pose.roll());
		Eigen::Matrix3d rotation = pose.getRotationMatrix().asEigen();
		(*this)(place), (*this)(rotation), (*this)(angles);
		if (Archive::kReads) pose = poseFrom(place, rotation, angles);
	}
	void operator()(Eigen::Isometry3d& transform) { (*this)(transform.matrix()); }
	template <class Key, class Value, class Less>
	void operator()(std::map<Key, Value, Less>& values)
	{
		std::vector<std::pair<Key, Value>> items(values.begin(), values.end());
		(*this)(items);
		if (Archive::kReads) values = {items.begin(), items.end()};
	}
	template <class First, class Second>
	void operator()(std::pair<First, Second>& both)
	{
		(*this)(both.first), (*this)(both.second);
	}
	template <class Value>
	void operator()(std::optional<Value>& value)
	{
		bool there = value.has_value();
		(*this)(there);
		if (there && !value) value.emplace();
		if (!there) value.reset();
		if (value) (*this)(*value);
	}
	template <class Value, std::size_t kSize>
	void operator()(std::array<Value, kSize>& values)
	{
		if constexpr (kPlain<Value>)
			self().raw(values.data(), sizeof(values));
		else
			for (Value& value : values) (*this)(value);
	}
	template <class Value>
	void operator()(std::vector<Value>& values)
	{
		if constexpr (kPlain<Value>)
			return blocks(values, sizeof(Value));
		else
		{
			resize(values, 1);
			for (Value& value : values) (*this)(value);
		}
	}

private:
	Archive& self() { return static_cast<Archive&>(*this); }
	/** Exchanges the size; `least_bytes` = how few each item can take. */
	template <class Container>
	void resize(Container& container, std::size_t least_bytes)
	{
		std::uint64_t size = container.size();
		self().raw(&size, sizeof(size));
		container.resize(self().plausible(size, least_bytes));
	}
	template <class Container>
	void blocks(Container& container, std::size_t item_bytes)
	{
		resize(container, item_bytes);
		self().raw(container.data(), container.size() * item_bytes);
	}
};

class ByteWriter : public ByteArchive<ByteWriter>
{
public:
	static constexpr bool kReads = false;

	[[nodiscard]] const std::string& bytes() const { return m_bytes; }
	void raw(const void* data, std::size_t size)
	{
		if (size > 0) m_bytes.append(static_cast<const char*>(data), size);
	}
	[[nodiscard]] static std::size_t plausible(std::uint64_t count, std::size_t /*least_bytes*/) { return count; }

private:
	std::string m_bytes;
};

/** Reads what ByteWriter wrote. Past the end, everything is zero or empty and good() is false. */
class ByteReader : public ByteArchive<ByteReader>
{
public:
	static constexpr bool kReads = true;

	/** `bytes` outlive it. */
	explicit ByteReader(std::string_view bytes) : m_bytes(bytes) {}
	[[nodiscard]] bool good() const { return m_good; }
	[[nodiscard]] bool atEnd() const { return m_bytes.empty(); }
	/** What was not read yet. */
	[[nodiscard]] std::string_view rest() const { return m_bytes; }
	void raw(void* data, std::size_t size)
	{
		m_good = m_good && size <= m_bytes.size();
		if (size == 0) return;
		if (!m_good) return void(std::memset(data, 0, size));
		std::memcpy(data, m_bytes.data(), size);
		m_bytes.remove_prefix(size);
	}
	/** `count`, or 0 when so many items cannot follow. */
	[[nodiscard]] std::size_t plausible(std::uint64_t count, std::size_t least_bytes)
	{
		m_good = m_good && count <= m_bytes.size() / least_bytes;
		return m_good ? static_cast<std::size_t>(count) : 0;
	}

private:
	std::string_view m_bytes;
	bool m_good = true;
};
}  // namespace explore
