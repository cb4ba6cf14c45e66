#include "support/test_files.h"
#include "support/test_sockets.h"

#include <explore/config/ini.h>
#include <explore/core/errors.h>
#include <explore/sinks/robot_link/json_command_sink.h>
#include <explore/sinks/robot_link/link_config.h>
#include <explore/sinks/robot_link/link_socket.h>
#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

using namespace explore;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

namespace
{
TimedCommand command()
{
	TimedCommand result;
	result.t_s = 1.5e9;
	result.command.velocity_mps = {0.4, 0.0, -0.1};
	result.command.yaw_rate_radps = 0.25;
	return result;
}

void expectMovingThenStop(const json& moving, const json& stop)
{
	EXPECT_EQ(moving, (json{{"t", 1.5e9}, {"v", {0.4, 0.0, -0.1}}, {"yaw_rate", 0.25}, {"stop", false}, {"seq", 0}}));
	EXPECT_EQ(stop, (json{{"t", 1.5e9}, {"v", {0.0, 0.0, 0.0}}, {"yaw_rate", 0.0}, {"stop", true}, {"seq", 1}}));
}
}  // namespace

TEST(LinkAddress, IsNoneOrStdoutOrUdpOrUnix)
{
	EXPECT_EQ(linkAddress("commands", "none").kind, LinkKind::none);
	EXPECT_EQ(linkAddress("commands", "stdout").kind, LinkKind::standard_output);
	const LinkAddress udp = linkAddress("commands", "udp://robot.local:5005");
	EXPECT_EQ(udp.kind, LinkKind::udp);
	EXPECT_EQ(udp.host, "robot.local");
	EXPECT_EQ(udp.port, "5005");
	EXPECT_EQ(linkAddress("listen", "udp://[::1]:80").host, "::1");
	const LinkAddress stream = linkAddress("commands", "unix:///run/robot.sock");
	EXPECT_EQ(stream.kind, LinkKind::unix_stream);
	EXPECT_EQ(stream.path, "/run/robot.sock");
}

TEST(LinkAddress, RefusesAllElseWithWhatIsAccepted)
{
	const std::string long_path = "unix:///" + std::string(200, 'a');
	for (const std::string text : {"", "tcp://a:1", "udp://a", "udp://:5", "udp://a:0", "udp://a:65536", "udp://a:-1",
	                               "udp://a:12x", "udp://a:", "unix://relative", "unix://", long_path.c_str(), "None"})
		EXPECT_THAT([&] { linkAddress("commands", text); },
		            ThrowsMessage<ConfigError>(AllOf(HasSubstr("[robot_link] commands = " + text),
		                                             HasSubstr("udp://host:port or unix:///path"))))
		    << text;
}

TEST(LinkConfig, LoadsAndIsChecked)
{
	RobotLinkConfig config;
	loadIniText("test", "[robot_link]\ncommands = udp://127.0.0.1:5005\nrate = 50\nwatchdog = 0.5\nlisten = none\n", {},
	            [&](FieldVisitor& fields) { describe(fields, config); });
	EXPECT_EQ(config.commands, "udp://127.0.0.1:5005");
	EXPECT_EQ(config.rate_hz, 50.0);
	EXPECT_EQ(config.watchdog_s, 0.5);
	EXPECT_NO_THROW(check(config));
	EXPECT_FALSE(usesStandardOutput(config));
	config.listen = "stdout";
	EXPECT_THAT([&] { check(config); }, ThrowsMessage<ConfigError>(HasSubstr("[robot_link] listen = stdout")));
}

TEST(CommandLine, HoldsNoNumberThatIsNone)
{
	TimedCommand wrong = command();
	wrong.command.yaw_rate_radps = std::numeric_limits<double>::quiet_NaN();
	EXPECT_THROW(commandLine(wrong, false, 0), std::logic_error);
	EXPECT_TRUE(json::parse(commandLine({}, true, 7))["t"].is_null()) << "before the first frame";
}

TEST(JsonCommandSink, SendsADatagramACommand)
{
	const test::UdpReceiver receiver;
	LinkRemarks remarks;
	const auto sink = makeCommandSink(linkAddress("commands", receiver.uri()), remarks);
	sink->send(command());
	sink->stop(1.5e9);
	const auto received = receiver.all(300);
	ASSERT_THAT(received, SizeIs(2));
	expectMovingThenStop(json::parse(received[0].text), json::parse(received[1].text));
	EXPECT_THAT(remarks.take(), IsEmpty());
}

TEST(JsonCommandSink, AUdpReceiverThatIsNotThereIsRemarkedOnceAndFoundLater)
{
	LinkRemarks remarks;
	const int port = test::freePort();
	const auto sink = makeCommandSink(linkAddress("commands", "udp://127.0.0.1:" + std::to_string(port)), remarks);
	for (int i = 0; i < 10; ++i) sink->send(command());
	EXPECT_THAT(remarks.take(), ElementsAre(HasSubstr("udp://127.0.0.1:" + std::to_string(port))));
}

TEST(JsonCommandSink, AnUnknownHostIsAnError)
{
	LinkRemarks remarks;
	EXPECT_THAT([&] { makeCommandSink(linkAddress("commands", "udp://no-such-host.invalid:5"), remarks); },
	            ThrowsMessage<OutputError>(HasSubstr("no-such-host.invalid")));
}

TEST(JsonCommandSink, SendsALineACommandToAUnixStream)
{
	const auto path = test::freshFolder() / "robot.sock";
	const test::TestSocket server = test::unixServer(path);
	LinkRemarks remarks;
	auto sink = makeCommandSink(linkAddress("commands", "unix://" + path.string()), remarks);
	const test::TestSocket robot = test::accepted(server);
	sink->send(command());
	sink->stop(1.5e9);
	sink.reset();
	std::string text;
	for (std::string part = robot.receive(); !part.empty(); part = robot.receive()) text += part;
	const auto lines = test::linesOf(text);
	ASSERT_THAT(lines, SizeIs(2));
	expectMovingThenStop(json::parse(lines[0]), json::parse(lines[1]));
}

TEST(JsonCommandSink, AUnixReceiverThatIsNotThereIsAnError)
{
	const auto path = test::freshFolder() / "nobody.sock";
	LinkRemarks remarks;
	EXPECT_THAT([&] { makeCommandSink(linkAddress("commands", "unix://" + path.string()), remarks); },
	            ThrowsMessage<OutputError>(AllOf(HasSubstr(path.string()), HasSubstr("No such file"))));
}

TEST(JsonCommandSink, AUnixReceiverThatLeavesIsAnErrorAndNoSignal)
{
	const auto path = test::freshFolder() / "robot.sock";
	const test::TestSocket server = test::unixServer(path);
	LinkRemarks remarks;
	const auto sink = makeCommandSink(linkAddress("commands", "unix://" + path.string()), remarks);
	{
		const test::TestSocket robot = test::accepted(server);
	}
	EXPECT_THAT(([&] { sink->stop(1.0), sink->stop(1.0); }),
	            ThrowsMessage<OutputError>(HasSubstr("commands cannot be delivered")));
}

TEST(JsonCommandSink, AReceiverThatReadsNothingIsAnErrorInTheEnd)
{
	const auto path = test::freshFolder() / "robot.sock";
	const test::TestSocket server = test::unixServer(path);
	LinkRemarks remarks;
	const auto sink = makeCommandSink(linkAddress("commands", "unix://" + path.string()), remarks);
	const test::TestSocket robot = test::accepted(server);
	const auto flood = [&]
	{
		for (int i = 0; i < 100'000; ++i) sink->send(command());
	};
	EXPECT_THAT(flood, ThrowsMessage<OutputError>(HasSubstr("has read nothing for a second")));
}
