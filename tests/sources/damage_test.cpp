// Damaged input is read up to the damage, reported, and never crashes or invents values.
#include <explore/core/errors.h>

#include <algorithm>
#include <optional>
#include <random>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
/** What a damaged file gives; no value where it is refused outright. */
struct Outcome
{
	std::vector<DepthFrame> frames;
	SourceReport report;
};

std::optional<Outcome> outcomeOf(const std::string& bytes)
{
	writeBytes(testFolder() / "damaged.rawlog", bytes);
	Outcome outcome;
	try
	{
		outcome.frames = replay(configFor(testFolder() / "damaged.rawlog"), &outcome.report);
	}
	catch (const InputError& error)
	{
		EXPECT_THAT(error.what(), testing::HasSubstr("damaged.rawlog"));
		return std::nullopt;
	}
	return outcome;
}

/** The frames that were delivered are the first ones of the truth, unchanged. */
void expectPrefix(const Outcome& outcome, const std::vector<DepthFrame>& truth)
{
	ASSERT_LE(outcome.frames.size(), truth.size());
	for (std::size_t i = 0; i < outcome.frames.size(); ++i)
	{
		EXPECT_EQ(outcome.frames[i].image.depth_m, truth[i].image.depth_m);
		EXPECT_EQ(outcome.frames[i].timestamp, truth[i].timestamp);
	}
}

std::vector<std::size_t> objectEnds(const Objects& objects)
{
	std::vector<std::size_t> ends;
	for (std::size_t n = 1; n <= objects.size(); ++n)
	{
		writeRawlog(testFolder() / "part.rawlog",
		            Objects(objects.begin(), objects.begin() + static_cast<std::ptrdiff_t>(n)), Packing::plain);
		ends.push_back(std::filesystem::file_size(testFolder() / "part.rawlog"));
	}
	return ends;
}

TEST(Truncation, OfAPlainLogIsReportedWithItsBytes)
{
	const std::string whole = sampleBytes(Packing::plain);
	const auto truth = outcomeOf(whole)->frames;
	const std::vector<std::size_t> ends = objectEnds(sampleLog());
	std::mt19937 random(1);
	for (int i = 0; i < 100; ++i)
	{
		const std::size_t length = random() % (whole.size() - 1) + 1;
		const auto complete =
		    static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), length) - ends.begin());
		const auto outcome = outcomeOf(whole.substr(0, length));
		if (complete < 2)
		{
			EXPECT_FALSE(outcome && !outcome->frames.empty()) << length;
			continue;
		}
		ASSERT_TRUE(outcome) << length;
		EXPECT_EQ(outcome->frames.size(), complete / 2);
		expectPrefix(*outcome, truth);
		const std::size_t behind = length - ends[complete - 1];
		EXPECT_EQ(outcome->report.lost_bytes, behind);
		EXPECT_EQ(outcome->report.lost_objects, behind > 0 ? 1U : 0U);
		EXPECT_EQ(outcome->report.damage.empty(), behind == 0);
		const std::string place = behind > 0 ? "at byte " + std::to_string(ends[complete - 1]) : "";
		EXPECT_THAT(outcome->report.damage, testing::HasSubstr(place));
	}
}

TEST(Truncation, OfAGzippedLogNeverPasses)
{
	const std::string whole = sampleBytes(Packing::gzipped);
	const auto truth = outcomeOf(whole)->frames;
	std::mt19937 random(2);
	for (int i = 0; i < 100; ++i)
	{
		const std::size_t length =
		    i < 10 ? whole.size() - 1 - static_cast<std::size_t>(i) : random() % (whole.size() - 1) + 1;
		const auto outcome = outcomeOf(whole.substr(0, length));
		if (!outcome) continue;
		expectPrefix(*outcome, truth);
		EXPECT_NE(outcome->report.damage, "") << length;
		EXPECT_GE(outcome->report.lost_objects, 1U);
	}
}

TEST(FlippedBits, OfAGzippedLogAreReportedWhereverTheyChangeTheContents)
{
	const std::string whole = sampleBytes(Packing::gzipped);
	const auto truth = outcomeOf(whole)->frames;
	std::mt19937 random(3);
	int refused = 0;
	for (int i = 0; i < 200; ++i)
	{
		std::string flipped = whole;
		const std::size_t bit = random() % ((whole.size() - 10) * 8) + 80;
		flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
		const auto outcome = outcomeOf(flipped);
		refused += outcome ? 0 : 1;
		if (!outcome) continue;
		EXPECT_NE(outcome->report.damage, "") << "bit " << bit;
		EXPECT_GE(outcome->report.lost_objects, 1U) << "bit " << bit;
		for (const DepthFrame& frame : outcome->frames) expectFinite(frame);
	}
	EXPECT_LT(refused, 100) << "most flips leave something to read";
}

TEST(FlippedBits, OfAPlainLogDoNoHarm)
{
	const std::string whole = sampleBytes(Packing::plain);
	const auto truth = outcomeOf(whole)->frames;
	const std::vector<std::size_t> ends = objectEnds(sampleLog());
	std::mt19937 random(4);
	for (int i = 0; i < 200; ++i)
	{
		std::string flipped = whole;
		const std::size_t byte = random() % whole.size();
		flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << (random() % 8)));
		const auto outcome = outcomeOf(flipped);
		if (!outcome) continue;
		for (const DepthFrame& frame : outcome->frames) expectFinite(frame);
		// What lies before the damage is as it was.
		const auto intact =
		    static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), byte) - ends.begin()) / 2;
		ASSERT_GE(outcome->frames.size(), intact) << "byte " << byte;
		for (std::size_t f = 0; f < intact; ++f) EXPECT_EQ(outcome->frames[f].image.depth_m, truth[f].image.depth_m);
		EXPECT_TRUE(outcome->frames.size() == kSampleFrames || !outcome->report.damage.empty() ||
		            outcome->report.skipped_frames > 0 || outcome->report.sensors_found.size() > 1)
		    << "byte " << byte;
	}
}

/** All flips in what is not depth data: headers, sizes, poses, intrinsics, labels. */
TEST(FlippedBits, InTheHeadOfAScanDoNoHarm)
{
	const std::string whole = sampleBytes(Packing::plain);
	const std::vector<std::size_t> ends = objectEnds(sampleLog());
	const std::size_t head_bytes = 260;
	for (std::size_t byte = ends[2]; byte < ends[2] + head_bytes; ++byte)
		for (const int bit : {0, 3, 6, 7})
		{
#ifdef __SANITIZE_ADDRESS__
			if (bit >= 6)
				continue;  // gigabytes for a label: refused elsewhere, which ends the process under the sanitizer
#endif
			std::string flipped = whole;
			flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << bit));
			const auto outcome = outcomeOf(flipped);
			ASSERT_TRUE(outcome) << "byte " << byte;
			ASSERT_GE(outcome->frames.size(), 1U);
			for (const DepthFrame& frame : outcome->frames) expectFinite(frame);
		}
}

TEST(Damage, CountsTheObjectsBehindIt)
{
	std::string bytes = sampleBytes(Packing::plain);
	const std::vector<std::size_t> ends = objectEnds(sampleLog());
	bytes[ends[3] + 15] = '#';  // in the class name of the fifth object
	const auto outcome = outcomeOf(bytes);
	ASSERT_TRUE(outcome);
	EXPECT_EQ(outcome->frames.size(), 2U);
	EXPECT_EQ(outcome->report.lost_objects, 2U * kSampleFrames - 4U);
	EXPECT_EQ(outcome->report.lost_bytes, bytes.size() - ends[3]);
	EXPECT_THAT(outcome->report.damage, testing::HasSubstr("at byte " + std::to_string(ends[3])));
}

TEST(NotARawlog, IsRefusedWithThePath)
{
	const std::string png = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(500, '\0');
	for (const std::string& bytes : {std::string(), std::string("x"), std::string("just some text\nand more of it\n"),
	                                 png, std::string(1000, '\0'), std::string(1000, '\xff'), std::string("\x1f\x8b"),
	                                 std::string("\x1f\x8b\x08garbage that is no gzip")})
		EXPECT_FALSE(outcomeOf(bytes)) << bytes.size() << " bytes";
	EXPECT_THROW(replay(configFor(testFolder())), InputError);
	EXPECT_THROW(replay(configFor(testFolder() / "missing.rawlog")), InputError);
}

}  // namespace
}  // namespace explore::test
