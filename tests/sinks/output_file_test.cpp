#include "support/test_files.h"

#include <explore/core/errors.h>
#include <explore/sinks/output_file.h>
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>

using namespace explore;
using testing::HasSubstr;

namespace
{
std::string messageOf(const std::function<void()>& action)
{
	try
	{
		action();
	}
	catch (const OutputError& error)
	{
		return error.what();
	}
	return "no OutputError";
}

/** Files of this process may not grow beyond a size, as on a full disk, while it lives. */
class FileSizeLimit
{
public:
	explicit FileSizeLimit(rlim_t bytes)
	{
		std::signal(SIGXFSZ, SIG_IGN);
		getrlimit(RLIMIT_FSIZE, &m_before);
		rlimit limit = m_before;
		limit.rlim_cur = bytes;
		setrlimit(RLIMIT_FSIZE, &limit);
	}
	FileSizeLimit(const FileSizeLimit&) = delete;
	FileSizeLimit& operator=(const FileSizeLimit&) = delete;
	~FileSizeLimit()
	{
		setrlimit(RLIMIT_FSIZE, &m_before);
		std::signal(SIGXFSZ, SIG_DFL);
	}

private:
	rlimit m_before{};
};
}  // namespace

TEST(OutputFile, WritesAreOnDiskBeforeTheFileIsClosed)
{
	const auto path = test::freshFolder() / "file";
	OutputFile file(path);
	file.write("first\n");
	EXPECT_EQ(test::readFile(path), "first\n");
	file.write("second\n");
	EXPECT_EQ(test::readFile(path), "first\nsecond\n");
}

TEST(OutputFile, EmptiesAnOldFile)
{
	const auto path = test::freshFolder() / "file";
	test::writeFile(path, "old content");
	OutputFile(path).write("new");
	EXPECT_EQ(test::readFile(path), "new");
}

TEST(OutputFile, FullDiskIsNoticedAtTheWrite)
{
	if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
	OutputFile file("/dev/full");
	EXPECT_THAT(messageOf([&] { file.write("text"); }), AllOf(HasSubstr("/dev/full"), HasSubstr("No space left")));
}

TEST(OutputFile, WhatDoesNotFitIsCutBackToWholeTexts)
{
	const auto path = test::freshFolder() / "file";
	OutputFile file(path);
	file.write("twelve bytes");
	{
		const FileSizeLimit limit(16);
		EXPECT_THAT(messageOf([&] { file.write("ten bytes."); }), HasSubstr("File too large"));
	}
	EXPECT_EQ(test::readFile(path), "twelve bytes");
}

TEST(OutputFile, NamesTheFileThatCannotBeOpened)
{
	const auto path = test::freshFolder() / "missing" / "file";
	EXPECT_THAT(messageOf([&] { const OutputFile file(path); }),
	            AllOf(HasSubstr(path.string()), HasSubstr("No such file or directory")));
}

TEST(OutputFile, AtomicWriteReplacesTheFileAndLeavesNothingElse)
{
	const auto folder = test::freshFolder();
	test::writeFile(folder / "summary.json", "old and longer");
	writeFileAtomically(folder / "summary.json", "new");
	EXPECT_EQ(test::readFile(folder / "summary.json"), "new");
	EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(OutputFile, FailedAtomicWriteKeepsTheOldFile)
{
	const auto path = test::freshFolder() / "summary.json";
	test::writeFile(path, "old");
	{
		const FileSizeLimit limit(4);
		EXPECT_THROW(writeFileAtomically(path, "longer than four bytes"), OutputError);
	}
	EXPECT_EQ(test::readFile(path), "old");
}
