#include <explore/sinks/progress.h>
#include <gmock/gmock.h>

using namespace explore;
using testing::HasSubstr;

namespace
{
struct Screen
{
	std::string text;
	StatusLine::Write write()
	{
		return [this](std::string_view more) { text += more; };
	}
};
}  // namespace

TEST(ProgressText, KnownInputHasShareAndTimeLeft)
{
	// A quarter took 30 s, so three quarters take 90.
	EXPECT_EQ(progressText({120, 0.25, 2}, 85.2, 30.0), "frame 120  25 %  85 Hz  doors 2  left 1:30");
}

TEST(ProgressText, UnknownShareIsLeftOut)
{
	EXPECT_EQ(progressText({120, std::nullopt, 0}, 10.0, 30.0), "frame 120  10 Hz  doors 0");
	EXPECT_EQ(progressText({1, 0.0, 0}, 0.0, 0.0), "frame 1  0 %  doors 0");
}

TEST(ProgressText, GoalAndKnownFloorWhereThereAreSome)
{
	EXPECT_EQ(progressText({7, std::nullopt, 1, "frontier", 42.4}, 0.0, 1.0),
	          "frame 7  doors 1  known 42 m2  goal frontier");
}

TEST(ProgressText, ShareBeyondTheEndIsTheEnd)
{
	EXPECT_EQ(progressText({9, 1.5, 0}, 10.0, 30.0), "frame 9  100 %  10 Hz  doors 0  left 0:00");
}

TEST(StatusLine, TerminalRewritesOneLineTenTimesASecond)
{
	Screen screen;
	StatusLine status(StatusLine::Style::terminal, screen.write());
	for (std::size_t i = 1; i <= 100; ++i) status.update({i, std::nullopt, 0}, 0.01 * static_cast<double>(i));
	EXPECT_EQ(screen.text.find('\n'), std::string::npos);
	const auto shown = std::count(screen.text.begin(), screen.text.end(), '\r');
	EXPECT_GE(shown, 9);
	EXPECT_LE(shown, 10);
	EXPECT_THAT(screen.text, HasSubstr("100 Hz"));
}

TEST(StatusLine, LogLinesStandAboveTheTerminalLine)
{
	Screen screen;
	StatusLine status(StatusLine::Style::terminal, screen.write());
	status.update({1, std::nullopt, 0}, 1.0);
	screen.text.clear();
	status.log("careful");
	EXPECT_EQ(screen.text, "\r\033[Kcareful\n");
	screen.text.clear();
	status.finish();
	EXPECT_EQ(screen.text, "");  // nothing stands any more
}

TEST(StatusLine, PlainStyleWritesWholeLinesEveryFiveSeconds)
{
	Screen screen;
	StatusLine status(StatusLine::Style::plain, screen.write());
	for (std::size_t i = 1; i <= 12; ++i) status.update({i, std::nullopt, 0}, static_cast<double>(i));
	EXPECT_EQ(screen.text, "frame 5  1 Hz  doors 0\nframe 10  1 Hz  doors 0\n");
}

TEST(StatusLine, SilentStyleStillLogs)
{
	Screen screen;
	StatusLine status(StatusLine::Style::silent, screen.write());
	status.update({1, std::nullopt, 0}, 100.0);
	EXPECT_EQ(screen.text, "");
	status.log("careful");
	EXPECT_EQ(screen.text, "careful\n");
}
