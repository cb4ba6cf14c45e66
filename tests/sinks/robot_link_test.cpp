#include <explore/core/errors.h>
#include <explore/sinks/robot_link/robot_link.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

using namespace explore;
using namespace std::chrono_literals;
using testing::HasSubstr;

namespace
{
using Clock = RobotLink::Clock;

/** What a robot was told, and when. */
struct Told
{
	Clock::time_point at;
	bool stop = true;
	double speed_mps = 0;
	std::optional<double> t_s;
};

/** Outlives the sink that fills it. */
struct Record
{
	[[nodiscard]] std::vector<Told> all() const
	{
		const std::scoped_lock lock(mutex);
		return told;
	}
	/** Waits until `count` were told; false after 10 s. */
	[[nodiscard]] bool waitFor(std::size_t count) const
	{
		const auto deadline = Clock::now() + 10s;
		while (all().size() < count && Clock::now() < deadline) std::this_thread::sleep_for(1ms);
		return all().size() >= count;
	}
	/** Waits until the robot was told to move; false after 10 s. */
	[[nodiscard]] bool waitForMove() const
	{
		const auto deadline = Clock::now() + 10s;
		while (Clock::now() < deadline)
		{
			const auto so_far = all();
			if (!so_far.empty() && !so_far.back().stop) return true;
			std::this_thread::sleep_for(1ms);
		}
		return false;
	}
	/** Waits for `count` more; false after 10 s. */
	[[nodiscard]] bool waitForMore(std::size_t count) const { return waitFor(all().size() + count); }
	mutable std::mutex mutex;
	std::vector<Told> told;
	std::atomic<bool> refuses = false;
};

class RecordingSink : public CommandSink
{
public:
	explicit RecordingSink(Record& record) : m_record(record) {}
	void send(const TimedCommand& command) override
	{
		add({Clock::now(), false, command.command.velocity_mps.x(), command.t_s});
	}
	void stop(std::optional<double> t_s) override { add({Clock::now(), true, 0.0, t_s}); }

private:
	void add(const Told& told)
	{
		if (m_record.refuses) throw OutputError("the receiver is gone");
		const std::scoped_lock lock(m_record.mutex);
		m_record.told.push_back(told);
	}
	Record& m_record;
};

Decision forward(double speed_mps)
{
	Decision decision;
	decision.command.velocity_mps.x() = speed_mps;
	return decision;
}

std::size_t movingOnes(const std::vector<Told>& told)
{
	return static_cast<std::size_t>(std::ranges::count_if(told, [](const Told& one) { return !one.stop; }));
}

struct RobotLinkTest : testing::Test
{
	Record record;
	LinkRemarks remarks;
	std::unique_ptr<RobotLink> link(const RobotLinkTiming& timing, std::function<bool()> halted = {})
	{
		return std::make_unique<RobotLink>(std::make_unique<RecordingSink>(record), timing, remarks, std::move(halted));
	}
};
}  // namespace

TEST_F(RobotLinkTest, TellsTheRobotToStopBeforeTheFirstDecision)
{
	const auto robot = link({100.0, 5.0});
	ASSERT_TRUE(record.waitFor(5));
	EXPECT_EQ(movingOnes(record.all()), 0U);
	EXPECT_FALSE(record.all().front().t_s);
	EXPECT_TRUE(remarks.take().empty()) << "it has not begun yet";
}

TEST_F(RobotLinkTest, RepeatsTheLastDecisionAtItsRate)
{
	const auto robot = link({50.0, 20.0});
	robot->decided(forward(0.4), 12.5);
	ASSERT_TRUE(record.waitForMove());
	const std::size_t first = record.all().size();
	ASSERT_TRUE(record.waitFor(first + 25)) << "repeats nothing";
	const auto told = record.all();
	const std::chrono::duration<double> elapsed = told[first + 24].at - told[first].at;
	EXPECT_GE(elapsed.count(), 0.5 * 24 / 50.0) << "faster than its rate";
	EXPECT_EQ(movingOnes({told.begin() + static_cast<std::ptrdiff_t>(first), told.end()}), told.size() - first);
	EXPECT_EQ(told.back().speed_mps, 0.4);
	EXPECT_EQ(told.back().t_s, 12.5);
	robot->decided(forward(0.1), 12.6);
	ASSERT_TRUE(record.waitForMore(3));
	EXPECT_EQ(record.all().back().speed_mps, 0.1);
}

TEST_F(RobotLinkTest, StopsTheRobotWhenNoDecisionComes)
{
	const auto robot = link({50.0, 0.2});
	const auto decided = Clock::now();
	// Again and again until one got through: on a busy machine the first may be late already.
	Clock::time_point last;
	for (bool moves = false; !moves && Clock::now() < decided + 10s;)
	{
		last = Clock::now();
		robot->decided(forward(0.4), 12.5);
		std::this_thread::sleep_for(30ms);
		moves = movingOnes(record.all()) > 0;
	}
	std::this_thread::sleep_for(1s);
	const auto told = record.all();
	const auto last_move = std::find_if(told.rbegin(), told.rend(), [](const Told& one) { return !one.stop; });
	ASSERT_NE(last_move, told.rend()) << "never told to move";
	ASSERT_NE(last_move, told.rbegin()) << "never stopped";
	const auto first_stop = std::prev(last_move);
	// A period after the watchdog, and half a second for a busy machine.
	EXPECT_LT(first_stop->at - last, 200ms + 20ms + 500ms);
	const auto said = remarks.take();
	ASSERT_EQ(said.size(), 1U);
	EXPECT_THAT(said[0], HasSubstr("no new decision for 0.2 s"));
}

TEST_F(RobotLinkTest, GoesOnAfterAStallAndSaysSoOnce)
{
	const auto robot = link({100.0, 0.05});
	for (int i = 0; i < 2; ++i)
	{
		robot->decided(forward(0.3), i);
		std::this_thread::sleep_for(500ms);
		EXPECT_TRUE(record.all().back().stop);
	}
	EXPECT_EQ(remarks.take().size(), 1U);
	const std::size_t before = movingOnes(record.all());
	for (int i = 0; i < 1000 && movingOnes(record.all()) == before; ++i)
	{
		robot->decided(forward(0.3), 5.0);
		std::this_thread::sleep_for(10ms);
	}
	EXPECT_GT(movingOnes(record.all()), before);
}

TEST_F(RobotLinkTest, ADecisionToStopIsAStop)
{
	const auto robot = link({100.0, 5.0});
	robot->decided(forward(0.3), 1.0);
	Decision stop = forward(0.3);
	stop.stop = true;
	robot->decided(stop, 1.1);
	ASSERT_TRUE(record.waitForMore(3));
	EXPECT_TRUE(record.all().back().stop);
}

TEST_F(RobotLinkTest, AHaltNeedsNoNewDecision)
{
	std::atomic<bool> pressed = false;
	const auto robot = link({100.0, 60.0}, [&] { return pressed.load(); });
	robot->decided(forward(0.3), 1.0);
	ASSERT_TRUE(record.waitForMove());
	pressed = true;
	ASSERT_TRUE(record.waitForMore(3));
	EXPECT_TRUE(record.all().back().stop);
	pressed = false;
	ASSERT_TRUE(record.waitForMore(3));
	EXPECT_FALSE(record.all().back().stop) << "released";
}

TEST_F(RobotLinkTest, TheLastWordsAreStops)
{
	{
		const auto robot = link({10.0, 20.0});
		robot->decided(forward(0.4), 3.0);
		ASSERT_TRUE(record.waitForMove());
		robot->stop();
		robot->decided(forward(0.4), 3.1);  // too late
	}
	const auto told = record.all();
	EXPECT_GT(movingOnes(told), 0U);
	ASSERT_GE(told.size(), 4U);
	for (std::size_t i = told.size() - 3; i < told.size(); ++i) EXPECT_TRUE(told[i].stop);
	EXPECT_EQ(told.back().t_s, 3.0);
}

TEST_F(RobotLinkTest, AnExceptionOnTheWayStopsTheRobot)
{
	const auto drive = [&]
	{
		const auto robot = link({50.0, 20.0});
		robot->decided(forward(0.4), 3.0);
		ASSERT_TRUE(record.waitForMove());
		throw std::runtime_error("the explorer fails");
	};
	EXPECT_THROW(drive(), std::runtime_error);
	const auto told = record.all();
	EXPECT_GT(movingOnes(told), 0U);
	EXPECT_TRUE(told.back().stop);
	EXPECT_TRUE(told[told.size() - 2].stop);
}

TEST_F(RobotLinkTest, TellsTheRunThatCommandsAreNotDelivered)
{
	const auto robot = link({100.0, 5.0});
	record.refuses = true;
	const auto deadline = Clock::now() + 10s;
	const auto decide_for_long = [&]
	{
		while (Clock::now() < deadline) robot->decided(forward(0.1), 1.0), std::this_thread::sleep_for(5ms);
	};
	EXPECT_THROW(decide_for_long(), OutputError);
}
