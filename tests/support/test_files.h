// A folder for the running test, and whole files as text.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace explore::test
{
/** A folder of this process below the system's folder for temporary files; removed when the process ends. */
inline const std::filesystem::path& processFolder()
{
	struct Owned
	{
		std::filesystem::path path =
		    std::filesystem::path(testing::TempDir()) / ("explore_tests_" + std::to_string(::getpid()));
		~Owned()
		{
			std::error_code ignored;
			std::filesystem::remove_all(path, ignored);
		}
	};
	static const Owned owned;
	return owned.path;
}

/** The running test's own folder, as it is. */
inline std::filesystem::path testFolder()
{
	const auto* test = testing::UnitTest::GetInstance()->current_test_info();
	return processFolder() / (std::string(test->test_suite_name()) + "." + test->name());
}

/** testFolder(), made new and empty. */
inline std::filesystem::path freshFolder()
{
	std::filesystem::remove_all(testFolder());
	std::filesystem::create_directories(testFolder());
	return testFolder();
}

/** All bytes; empty where there is no such file. */
inline std::string readFile(const std::filesystem::path& path)
{
	std::ostringstream text;
	text << std::ifstream(path, std::ios::binary).rdbuf();
	return text.str();
}

inline void writeFile(const std::filesystem::path& path, const std::string& bytes)
{
	std::ofstream(path, std::ios::binary) << bytes;
}

inline std::vector<std::string> linesOf(const std::string& text)
{
	std::vector<std::string> lines;
	std::istringstream stream(text);
	for (std::string line; std::getline(stream, line);) lines.push_back(line);
	return lines;
}
}  // namespace explore::test
