#include <explore-eval/process_pool.h>
#include <explore/core/errors.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>
#include <set>

using namespace explore;
using namespace explore::app;

namespace
{
const std::vector<std::string> kNames{"a.rawlog", "b.rawlog", "c.rawlog", "d.rawlog"};

template <class Error>
std::string messageOf(const std::function<std::string(std::size_t)>& work)
{
	try
	{
		inProcesses(kNames, 2, work, [](std::size_t) {});
	}
	catch (const Error& error)
	{
		return error.what();
	}
	return "no such error";
}
}  // namespace

TEST(EvalProcesses, TextsComeBackInOrder)
{
	const std::string large(3'000'000, 'x');
	std::set<std::size_t> done;
	const auto texts = inProcesses(
	    kNames, 3, [&](std::size_t i) { return i == 1 ? large : std::to_string(i) + " from a child"; },
	    [&](std::size_t i) { done.insert(i); });
	ASSERT_EQ(texts.size(), 4U);
	EXPECT_EQ(texts[0], "0 from a child");
	EXPECT_EQ(texts[1], large);
	EXPECT_EQ(texts[3], "3 from a child");
	EXPECT_EQ(done.size(), 4U);
	EXPECT_TRUE(inProcesses(
	                {}, 2, [](std::size_t) { return ""; }, [](std::size_t) {})
	                .empty());
}

TEST(EvalProcesses, ErrorsKeepTheirType)
{
	EXPECT_EQ(messageOf<InputError>([](std::size_t i) -> std::string
	                                { return i == 2 ? throw InputError("bad log") : "fine"; }),
	          "bad log");
	EXPECT_EQ(messageOf<OutputError>([](std::size_t) -> std::string { throw OutputError("disk full"); }), "disk full");
	EXPECT_EQ(messageOf<std::runtime_error>([](std::size_t) -> std::string { throw std::logic_error("bug"); }), "bug");
}

TEST(EvalProcesses, ACrashNamesItsTask)
{
	const auto crash = [](std::size_t i) -> std::string
	{
		if (i == 1) ::kill(::getpid(), SIGKILL);
		return "";
	};
	EXPECT_THAT(messageOf<std::runtime_error>(crash),
	            testing::HasSubstr("b.rawlog: its process was ended by signal 9"));
}
