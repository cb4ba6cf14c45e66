// What is written is read again, to the last bit, whatever it is composed of; what is cut off is noticed.
#include <explore/core/byte_archive.h>
#include <gtest/gtest.h>

#include <limits>

using namespace explore;

namespace
{
enum class Kind
{
	one,
	two
};
struct Inner
{
	double value = 0;
	std::optional<Eigen::Vector3d> place;
	bool operator==(const Inner&) const = default;
};
struct Outer
{
	Kind kind = Kind::one;
	std::array<std::optional<float>, 3> shares;
	std::vector<Inner> inner;
	std::map<std::string, std::vector<float>, std::less<>> by_name;
	std::string text;
	bool flag = false;
	Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
	mrpt::Clock::time_point time;
	bool operator==(const Outer&) const = default;
};

class Secret
{
public:
	explicit Secret(int value = 0) : m_value(value) {}
	template <class Archive>
	void exchange(Archive& archive)
	{
		archive(m_value);
	}
	[[nodiscard]] int value() const { return m_value; }

private:
	int m_value;
};

Outer example()
{
	Outer value;
	value.kind = Kind::two;
	value.shares = {0.5F, std::nullopt, -0.0F};
	value.inner = {{1.0 / 3.0, std::nullopt}, {std::numeric_limits<double>::denorm_min(), Eigen::Vector3d(1, 2, 3)}};
	value.by_name = {{"a", {1.0F, 2.0F}}, {"b", {}}};
	value.text = std::string("a\0b", 3);
	value.flag = true;
	value.matrix << 1, 2, 3, 4;
	value.time = mrpt::Clock::fromDouble(1.6e9);
	return value;
}

template <class Value>
std::string bytesOf(Value value)
{
	ByteWriter writer;
	writer(value);
	return writer.bytes();
}

void expectSame(const mrpt::poses::CPose3D& a, const mrpt::poses::CPose3D& b)
{
	EXPECT_EQ(a.getRotationMatrix(), b.getRotationMatrix());
	for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(a[i], b[i]) << i;
}

mrpt::poses::CPose3D again(const mrpt::poses::CPose3D& pose)
{
	const std::string bytes = bytesOf(pose);
	ByteReader reader(bytes);
	mrpt::poses::CPose3D result;
	reader(result);
	return result;
}
}  // namespace

TEST(ByteArchive, AStructIsReadAsItWasWritten)
{
	const std::string bytes = bytesOf(example());
	ByteReader reader(bytes);
	Outer read;
	read.shares[1] = 4.0F;
	read.inner.resize(5);
	read.by_name["c"] = {1.0F};
	reader(read);
	EXPECT_TRUE(reader.good());
	EXPECT_TRUE(reader.atEnd());
	EXPECT_EQ(read, example());
}

TEST(ByteArchive, CountsTheFieldsOfAStruct)
{
	EXPECT_EQ(fieldCount<Inner>(), 2U);
	EXPECT_EQ(fieldCount<Outer>(), 8U);
}

TEST(ByteArchive, AClassSaysItself)
{
	const std::string bytes = bytesOf(Secret(7));
	ByteReader reader(bytes);
	Secret read;
	reader(read);
	EXPECT_EQ(read.value(), 7);
}

TEST(ByteArchive, WhatIsCutOffIsNotGood)
{
	const std::string bytes = bytesOf(example());
	for (std::size_t size = 0; size < bytes.size(); ++size)
	{
		ByteReader reader(std::string_view(bytes).substr(0, size));
		Outer read;
		reader(read);
		EXPECT_FALSE(reader.good()) << size;
	}
}

TEST(ByteArchive, PosesKeepTheirRotationAndTheirAnglesToTheLastBit)
{
	mrpt::poses::CPose3D composed(0.3, -1.2, 0.7, 0.4, -0.2, 0.1);
	for (int i = 0; i < 200; ++i)
	{
		const double angle = 0.037 * i;
		const mrpt::poses::CPose3D given(0.1 * i, -0.3, 1.0 / (i + 1), angle - 3.0, 0.3 - 0.001 * i, -0.1 + 0.002 * i);
		expectSame(again(given), given);
		composed = composed + given;
		expectSame(again(composed), composed);
		expectSame(again(again(composed)), composed);
	}
}
