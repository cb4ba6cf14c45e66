#include <explore/core/errors.h>
#include <explore/sources/checked_stream.h>
#include <zlib.h>

#include <algorithm>
#include <random>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
std::string noise(std::size_t bytes, unsigned seed)
{
	std::mt19937 random(seed);
	std::string text(bytes, '\0');
	std::generate(text.begin(), text.end(), [&] { return static_cast<char>(random() % 16 + 'a'); });
	return text;
}

void writeGzip(const std::filesystem::path& path, const std::string& bytes)
{
	gzFile file = gzopen(path.c_str(), "wb6");
	ASSERT_EQ(gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size())), static_cast<int>(bytes.size()));
	ASSERT_EQ(gzclose(file), Z_OK);
}

/** All that can be read, in reads of random sizes; `clean` tells whether the end was a clean one. */
std::string readAll(const std::filesystem::path& path, bool& clean)
{
	CheckedStream stream(path);
	std::mt19937 random(7);
	std::string all;
	clean = false;
	try
	{
		while (!stream.atEnd())
		{
			std::string part(std::min<std::size_t>(random() % 5000 + 1, stream.peek(5000).size()), '\0');
			stream.Read(part.data(), part.size());
			all += part;
			EXPECT_EQ(stream.getPosition(), all.size());
		}
		clean = true;
	}
	catch (const StreamDamage& damage)
	{
		EXPECT_EQ(stream.failure(), damage.what());
	}
	return all;
}

TEST(CheckedStream, ReadsPlainAndGzippedFilesAsTheyAre)
{
	const std::string bytes = noise(1'000'003, 1);
	writeBytes(testFolder() / "plain", bytes);
	writeGzip(testFolder() / "zipped", bytes);
	for (const char* name : {"plain", "zipped"})
	{
		bool clean = false;
		EXPECT_EQ(readAll(testFolder() / name, clean), bytes) << name;
		EXPECT_TRUE(clean) << name;
	}
	EXPECT_FALSE(CheckedStream(testFolder() / "plain").compressed());
	EXPECT_TRUE(CheckedStream(testFolder() / "zipped").compressed());
}

TEST(CheckedStream, ReadsGzipMembersOneAfterTheOther)
{
	writeGzip(testFolder() / "a", noise(70'000, 2));
	writeBytes(testFolder() / "two", readBytes(testFolder() / "a") + readBytes(testFolder() / "a"));
	bool clean = false;
	EXPECT_EQ(readAll(testFolder() / "two", clean), noise(70'000, 2) + noise(70'000, 2));
	EXPECT_TRUE(clean);
}

TEST(CheckedStream, NoticesEveryTruncationOfAGzippedFile)
{
	const std::string bytes = noise(200'000, 3);
	writeGzip(testFolder() / "whole", bytes);
	const std::string zipped = readBytes(testFolder() / "whole");
	std::mt19937 random(4);
	for (int i = 0; i < 100; ++i)
	{
		const std::size_t length =
		    i < 9 ? zipped.size() - 1 - static_cast<std::size_t>(i) : random() % (zipped.size() - 2) + 2;
		writeBytes(testFolder() / "cut", zipped.substr(0, length));
		bool clean = true;
		const std::string read = readAll(testFolder() / "cut", clean);
		EXPECT_FALSE(clean) << length << " of " << zipped.size();
		EXPECT_EQ(read, bytes.substr(0, read.size()));
	}
}

TEST(CheckedStream, NoticesEveryFlippedBitThatChangesTheContents)
{
	const std::string bytes = noise(100'000, 5);
	writeGzip(testFolder() / "whole", bytes);
	const std::string zipped = readBytes(testFolder() / "whole");
	std::mt19937 random(6);
	for (int i = 0; i < 200; ++i)
	{
		std::string flipped = zipped;
		const std::size_t bit =
		    random() % ((zipped.size() - 10) * 8) + 80;  // behind the header, which carries no contents
		flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
		writeBytes(testFolder() / "flipped", flipped);
		bool clean = true;
		readAll(testFolder() / "flipped", clean);
		EXPECT_FALSE(clean) << "bit " << bit;
	}
}

TEST(CheckedStream, NoticesWhatFollowsAGzippedFile)
{
	writeGzip(testFolder() / "a", "content");
	writeBytes(testFolder() / "a", readBytes(testFolder() / "a") + "junk");
	bool clean = true;
	EXPECT_EQ(readAll(testFolder() / "a", clean), "content");
	EXPECT_FALSE(clean);
}

TEST(CheckedStream, NeverReturnsLessThanAsked)
{
	writeBytes(testFolder() / "five", "12345");
	CheckedStream stream(testFolder() / "five");
	std::string buffer(6, '\0');
	EXPECT_THROW(stream.Read(buffer.data(), 6), StreamDamage);
}

TEST(CheckedStream, RefusesWhatIsNoReadableFileWithTheReason)
{
	const auto message_for = [](const std::filesystem::path& path) -> std::string
	{
		try
		{
			CheckedStream stream(path);
		}
		catch (const InputError& error)
		{
			return error.what();
		}
		return "accepted";
	};
	EXPECT_THAT(message_for(testFolder() / "missing"), testing::HasSubstr("missing: No such file or directory"));
	EXPECT_THAT(message_for(testFolder()), testing::HasSubstr("Is a directory"));
	EXPECT_THAT(message_for("/dev/null"), testing::HasSubstr("regular file is needed"));
}
}  // namespace
}  // namespace explore::test
