// Values as bytes and back, for files that only the machine that wrote them reads.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace explore::simulation
{
/** Types whose bytes are their value. */
template <class Value>
inline constexpr bool kPlain = std::is_arithmetic_v<Value> || std::is_enum_v<Value>;
template <class Scalar, int kRows>
inline constexpr bool kPlain<Eigen::Matrix<Scalar, kRows, 1>> = kRows > 0;
template <class Value, std::size_t kSize>
inline constexpr bool kPlain<std::array<Value, kSize>> = kPlain<Value>;

/** The shared part of ByteWriter and ByteReader: how composed values fall into plain ones. Structs have a function
 *  template exchange(archive, struct&) of their own beside them. */
template <class Archive>
class ByteArchive
{
public:
	template <class Value>
	void operator()(Value& value)
	{
		if constexpr (kPlain<Value>)
			self().raw(&value, sizeof(value));
		else
			exchange(self(), value);
	}
	void operator()(bool& flag)
	{
		auto byte = static_cast<std::uint8_t>(flag);
		self().raw(&byte, 1);
		flag = byte != 0;
	}
	void operator()(std::string& text) { blocks(text, 1); }
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
	/** `bytes` outlive it. */
	explicit ByteReader(std::string_view bytes) : m_bytes(bytes) {}
	[[nodiscard]] bool good() const { return m_good; }
	[[nodiscard]] bool atEnd() const { return m_bytes.empty(); }
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
}  // namespace explore::simulation
