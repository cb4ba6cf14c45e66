#include "openni2/virtual_camera.h"
#include "support/test_files.h"

#include <OpenNI.h>
#include <explore/core/errors.h>
#include <explore/openni2/oni_source.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

using namespace explore;
using namespace explore::openni2;
using namespace explore::test;
using testing::HasSubstr;

namespace
{
struct Quiet : mrpt::system::COutputLogger
{
	Quiet() { logging_enable_console_output = false; }
};

SourceConfig configOf(const VirtualCamera& camera, const std::filesystem::path& oni)
{
	SourceConfig config = camera.config();
	config.oni = oni.string();
	return config;
}

std::vector<DepthFrame> framesOf(FrameSource& source)
{
	std::vector<DepthFrame> frames;
	while (auto frame = source.next()) frames.push_back(*std::move(frame));
	return frames;
}

std::string errorOf(const SourceConfig& config)
{
	Quiet logger;
	try
	{
		OniSource source(config, logger);
		framesOf(source);
		return source.report().damage;
	}
	catch (const InputError& error)
	{
		return error.what();
	}
}
}  // namespace

class Oni : public testing::TestWithParam<bool>
{
};

TEST_P(Oni, GivesEveryFrameAsItWas)
{
	const VirtualCamera camera(160, 120, 40);
	const auto oni = testFolder() / "camera.oni";
	recordOni(oni, 35, {GetParam()});
	Quiet logger;
	OniSource source(configOf(camera, oni), logger);
	const auto frames = framesOf(source);
	ASSERT_GE(frames.size(), 35U);
	const int first = camera.imageOf(frames.front().image);
	ASSERT_GE(first, 0);
	for (std::size_t i = 0; i < frames.size(); ++i)
	{
		EXPECT_EQ(camera.imageOf(frames[i].image), (first + static_cast<int>(i)) % 40);
		const double t_s = mrpt::Clock::toDouble(frames[i].timestamp) - 1.4e9;
		EXPECT_NEAR(t_s, 0.033333 * static_cast<double>(i), 1e-3);
		EXPECT_NEAR(frames[i].image.intrinsics.fx_px, camera.served().fx_px, 1e-3);
	}
	EXPECT_EQ(source.report().damage, "");
	EXPECT_EQ(source.progress(), 1.0);
}
INSTANTIATE_TEST_SUITE_P(Mirrored, Oni, testing::Bool());

TEST(OniFile, TellsWhatIsNoRecording)
{
	const VirtualCamera camera(64, 48, 5);
	const auto oni = testFolder() / "bad.oni";
	EXPECT_THAT(errorOf(configOf(camera, oni)), HasSubstr("no such recording"));
	EXPECT_THAT(errorOf(configOf(camera, testFolder())), HasSubstr("is no file"));
	for (const std::string& bytes : {std::string(), std::string("junk"), std::string(10'000, 'x'), std::string("NI10"),
	                                 "NI10" + std::string(10'000, '\x7f')})
	{
		writeFile(oni, bytes);
		EXPECT_THAT(errorOf(configOf(camera, oni)), HasSubstr("bad.oni"));
	}
}

TEST(OniFile, TellsWhereItIsCutOff)
{
	const VirtualCamera camera(64, 48, 5);
	const auto oni = testFolder() / "whole.oni";
	recordOni(oni, 10, {});
	// Behind the record that ends it the file is padded with zeros.
	std::string whole = readFile(oni);
	const std::size_t end = whole.rfind(std::string("NIR\0\x0b\0\0\0", 8));
	ASSERT_NE(end, std::string::npos);
	whole.resize(end + 28);
	ASSERT_EQ(errorOf(configOf(camera, oni)), "");
	const auto cut = testFolder() / "cut.oni";
	for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.9999})
	{
		writeFile(cut, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
		EXPECT_NE(errorOf(configOf(camera, cut)), "") << share;
	}
}
