#include "support/test_files.h"
#include "support/test_sockets.h"

#include <explore/core/errors.h>
#include <explore/sinks/robot_link/robot_listener.h>
#include <gmock/gmock.h>

#include <random>

using namespace explore;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::ThrowsMessage;

namespace
{
const auto kNow = mrpt::Clock::fromDouble(1.6e9);

double seconds(mrpt::Clock::time_point time)
{
	return mrpt::Clock::toDouble(time);
}

/** All of the messages that doc/robot-link.md shows. */
const std::vector<std::string> kGood{
    R"({"pose":{"t":1600000000.25,"x":1.5,"y":-2,"z":0.1,"yaw":0.5,"pitch":0.1,"roll":-0.1}})",
    R"({"imu":{"t":1600000000.5,"acceleration":[0.1,0.2,9.8]}})", R"({"bumper":{"t":1600000000.5,"pressed":true}})",
    R"({"cliff":{"t":1600000000.5,"seen":true}})",
    R"({"scan":{"t":1600000000.5,"aperture":3.14,"ranges":[1.0,2.5,null,0,12],"max_range":10,"pose":[0.1,0,0.2,0,0,0]}})"};

/** Waits until `done()`; false after 10 s. */
template <class Done>
bool waitUntil(const Done& done)
{
	for (int i = 0; i < 1000 && !done(); ++i) std::this_thread::sleep_for(10ms);
	return done();
}
}  // namespace

TEST(RobotMessage, Pose)
{
	const auto message = parseRobotMessage(kGood[0], kNow);
	ASSERT_TRUE(message && message->map_from_robot);
	EXPECT_NEAR(seconds(message->map_from_robot->time), 1600000000.25, 1e-6);
	const auto& pose = message->map_from_robot->value;
	EXPECT_EQ(pose.x(), 1.5);
	EXPECT_EQ(pose.y(), -2.0);
	EXPECT_EQ(pose.z(), 0.1);
	EXPECT_NEAR(pose.yaw(), 0.5, 1e-12);
	EXPECT_NEAR(pose.pitch(), 0.1, 1e-12);
	EXPECT_NEAR(pose.roll(), -0.1, 1e-12);
	EXPECT_FALSE(message->scan || message->acceleration_mps2 || message->bumper_pressed || message->cliff_seen);
}

TEST(RobotMessage, WhatIsLeftOutIsZeroAndNow)
{
	const auto message = parseRobotMessage(R"({"pose":{"x":1,"y":2,"yaw":3}})", kNow);
	ASSERT_TRUE(message && message->map_from_robot);
	EXPECT_EQ(message->map_from_robot->time, kNow);
	EXPECT_EQ(message->map_from_robot->value.z(), 0.0);
	EXPECT_EQ(parseRobotMessage(R"({"cliff":{"t":null,"seen":false}})", kNow)->cliff_seen->time, kNow);
}

TEST(RobotMessage, ScanBecomesAnObservation)
{
	const auto message = parseRobotMessage(kGood[4], kNow);
	ASSERT_TRUE(message && message->scan);
	const auto& scan = message->scan->value;
	ASSERT_EQ(scan.getScanSize(), 5U);
	EXPECT_FLOAT_EQ(scan.aperture, 3.14F);
	EXPECT_FLOAT_EQ(scan.maxRange, 10.0F);
	EXPECT_FLOAT_EQ(scan.getScanRange(1), 2.5F);
	const std::vector<bool> valid{true, true, false, false, false};  // null, 0 and what is out of range are none
	for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(scan.getScanRangeValidity(i), valid[i]) << i;
	EXPECT_NEAR(scan.sensorPose.z(), 0.2, 1e-6);
	EXPECT_EQ(scan.timestamp, message->scan->time);
}

TEST(RobotMessage, SeveralPartsInOneMessage)
{
	const auto message = parseRobotMessage(
	    R"({"imu":{"acceleration":[0,0,9.81]},"bumper":{"pressed":false},"cliff":{"seen":true}})", kNow);
	ASSERT_TRUE(message && message->acceleration_mps2 && message->bumper_pressed && message->cliff_seen);
	EXPECT_EQ(message->acceleration_mps2->value.z(), 9.81);
	EXPECT_FALSE(message->bumper_pressed->value);
	EXPECT_TRUE(message->cliff_seen->value);
}

TEST(RobotMessage, AllElseIsNone)
{
	for (const char* text : {"",
	                         "{}",
	                         "[]",
	                         "null",
	                         "1",
	                         "{",
	                         R"({"pose":{}})",
	                         R"({"pose":3})",
	                         R"({"pose":{"x":1,"y":2}})",
	                         R"({"pose":{"x":1,"y":2,"yaw":1e999}})",
	                         R"({"pose":{"x":"1","y":2,"yaw":0}})",
	                         R"({"pose":{"x":1e7,"y":2,"yaw":0}})",
	                         R"({"pose":{"x":1,"y":2,"yaw":0,"jaw":0}})",
	                         R"({"pose":{"t":-1,"x":1,"y":2,"yaw":0}})",
	                         R"({"pose":{"t":1e300,"x":1,"y":2,"yaw":0}})",
	                         R"({"imu":{"acceleration":[0,0]}})",
	                         R"({"imu":{"acceleration":[0,0,null]}})",
	                         R"({"bumper":true})",
	                         R"({"bumper":{"pressed":1}})",
	                         R"({"cliff":{}})",
	                         R"({"sonar":{"range":1}})",
	                         R"({"bumper":{"pressed":true},"sonar":1})",
	                         R"({"scan":{"aperture":3,"ranges":[1],"max_range":5}})",
	                         R"({"scan":{"aperture":0,"ranges":[1,2],"max_range":5}})",
	                         R"({"scan":{"aperture":3,"ranges":[1,"2"],"max_range":5}})",
	                         R"({"scan":{"aperture":3,"ranges":[1,2],"max_range":5,"pose":[1,2,3]}})"})
		EXPECT_FALSE(parseRobotMessage(text, kNow)) << text;
}

TEST(RobotInbox, KeepsMessagesInOrderAndAlarmsUntilReleased)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	for (const std::string& text : kGood) inbox.take(text, kNow);
	EXPECT_TRUE(inbox.alarms().bumper_pressed && inbox.alarms().cliff_seen);
	const auto messages = inbox.drain();
	ASSERT_THAT(messages, SizeIs(kGood.size()));
	EXPECT_TRUE(messages.front().map_from_robot && messages.back().scan);
	EXPECT_THAT(inbox.drain(), SizeIs(0));
	EXPECT_TRUE(inbox.alarms().any()) << "still pressed";
	inbox.take(R"({"bumper":{"pressed":false},"cliff":{"seen":false}})", kNow);
	EXPECT_FALSE(inbox.alarms().any());
}

TEST(RobotInbox, CountsWhatIsNoMessageAndSaysSoOnce)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	for (int i = 0; i < 7; ++i) inbox.take("hello\x01 robot", kNow);
	EXPECT_EQ(inbox.malformed(), 7U);
	EXPECT_THAT(remarks.take(), ElementsAre(HasSubstr("hello? robot")));
	EXPECT_THAT(inbox.drain(), SizeIs(0));
}

TEST(RobotInbox, ForgetsTheOldestOfTooMany)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	for (std::size_t i = 0; i < RobotInbox::kMostWaiting + 10; ++i)
		inbox.take(R"({"pose":{"y":0,"yaw":0,"x":)" + std::to_string(i) + "}}", kNow);
	const auto messages = inbox.drain();
	ASSERT_THAT(messages, SizeIs(RobotInbox::kMostWaiting));
	EXPECT_EQ(messages.front().map_from_robot->value.x(), 10.0);
}

TEST(RobotInbox, SurvivesRandomBytesAndBrokenMessages)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	std::mt19937 random(7);
	const auto below = [&](std::size_t end) { return random() % end; };
	std::size_t taken = 0;
	for (int i = 0; i < 30'000; ++i)
	{
		std::string text;
		if (i % 2 == 0)
			for (std::size_t n = below(200); n > 0; --n) text += static_cast<char>(random());
		else
		{
			text = kGood[below(kGood.size())];
			for (std::size_t n = below(4); n > 0; --n) switch (below(3))
				{
					case 0:
						text[below(text.size())] = static_cast<char>(random());
						break;
					case 1:
						text.erase(below(text.size()), 1 + below(5));
						break;
					default:
						text.insert(below(text.size()), 1, "{}[]\",:0e-."[below(11)]);
				}
		}
		inbox.take(text, kNow);
		for (const RobotMessage& message : inbox.drain())
		{
			++taken;
			if (message.map_from_robot)
			{
				EXPECT_LE(std::abs(message.map_from_robot->value.x()), 1e6);
			}
			if (message.scan)
			{
				EXPECT_GE(message.scan->value.getScanSize(), 2U);
			}
		}
	}
	EXPECT_EQ(taken + inbox.malformed(), 30'000U);
	EXPECT_GT(taken, 3'000U) << "the messages that were left whole";
	EXPECT_GT(inbox.malformed(), 15'000U);
	inbox.take(std::string(60'000, '['), kNow);
	EXPECT_THAT(inbox.drain(), SizeIs(0));
}

TEST(RobotListener, TakesDatagrams)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	const int port = test::freePort();
	const RobotListener listener(linkAddress("listen", "udp://127.0.0.1:" + std::to_string(port)), inbox);
	const test::TestSocket robot = test::udpSender(port);
	robot.send(kGood[0]);
	robot.send("nonsense");
	robot.send(kGood[2] + "\n");
	EXPECT_TRUE(waitUntil([&] { return inbox.alarms().bumper_pressed; }));
	EXPECT_THAT(inbox.drain(), SizeIs(2));
	EXPECT_EQ(inbox.malformed(), 1U);
}

TEST(RobotListener, TakesLinesOfSeveralStreams)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	const auto path = test::freshFolder() / "in.sock";
	{
		const RobotListener listener(linkAddress("listen", "unix://" + path.string()), inbox);
		const test::TestSocket one = test::unixClient(path), two = test::unixClient(path);
		one.send(kGood[2].substr(0, 10));
		std::this_thread::sleep_for(100ms);
		two.send(kGood[3] + "\n\n" + kGood[0] + "\n");
		EXPECT_TRUE(waitUntil([&] { return inbox.alarms().cliff_seen; }));
		EXPECT_FALSE(inbox.alarms().bumper_pressed) << "half a line";
		one.send(kGood[2].substr(10) + "\n");
		EXPECT_TRUE(waitUntil([&] { return inbox.alarms().bumper_pressed; }));
		two.send(std::string(200'000, 'x') + "\n" + R"({"bumper":{"pressed":false}})" + "\n");
		EXPECT_TRUE(waitUntil([&] { return !inbox.alarms().bumper_pressed; })) << "after a line that is too long";
		EXPECT_EQ(inbox.malformed(), 1U);
	}
	EXPECT_FALSE(std::filesystem::exists(path)) << "its name is removed";
}

TEST(RobotListener, ReplacesALeftoverSocketButNoOneElses)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	const auto path = test::freshFolder() / "in.sock";
	const LinkAddress address = linkAddress("listen", "unix://" + path.string());
	{
		const test::TestSocket left = test::unixServer(path);
		EXPECT_THAT([&] { RobotListener(address, inbox); },
		            ThrowsMessage<InputError>(HasSubstr("another program listens there")));
	}
	ASSERT_TRUE(std::filesystem::exists(path));
	EXPECT_NO_THROW(RobotListener(address, inbox));
	test::writeFile(path, "a file");
	EXPECT_THROW(RobotListener(address, inbox), InputError);
	EXPECT_EQ(test::readFile(path), "a file");
}

TEST(RobotListener, APortThatIsTakenIsAnError)
{
	LinkRemarks remarks;
	RobotInbox inbox(remarks);
	const test::UdpReceiver taken;
	EXPECT_THAT([&] { RobotListener(linkAddress("listen", taken.uri()), inbox); },
	            ThrowsMessage<InputError>(HasSubstr("cannot listen")));
}
