// Finding and reading ini files on disk.
#include <explore/config/ini_file.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "every_kind.h"
#include "support/test_files.h"

namespace explore
{
namespace
{
namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class IniFile : public testing::Test
{
protected:
	void SetUp() override { fs::create_directories(m_folder / "inis"); }

	fs::path write(const std::string& name, const std::string& text) const
	{
		std::ofstream(m_folder / name, std::ios::binary) << text;
		return m_folder / name;
	}
	static std::string refusalOf(const fs::path& path)
	{
		test::EveryKind config;
		try
		{
			loadIni(path, {}, test::fieldsOf(config));
			return "";
		}
		catch (const ConfigError& error)
		{
			return error.what();
		}
	}

	fs::path m_folder = test::freshFolder();
};

TEST_F(IniFile, loadsFromDiskAndNamesTheFile)
{
	test::EveryKind config;
	loadIni(write("good.ini", "[shape]\ncount = 8\n"), {"shape.gain=0.5"}, test::fieldsOf(config));
	EXPECT_EQ(config.count, 8);
	EXPECT_EQ(config.gain, 0.5);
	const auto bad = write("bad.ini", "[shape]\ncount = x\n");
	EXPECT_THAT(refusalOf(bad), testing::StartsWith(bad.string() + ":2: [shape] count = \"x\""));
}

TEST_F(IniFile, whatCannotBeReadIsRefusedByName)
{
	EXPECT_THAT(refusalOf(m_folder / "none.ini"), AllOf(HasSubstr("none.ini"), HasSubstr("No such file")));
	EXPECT_THAT(refusalOf(m_folder), AllOf(HasSubstr(m_folder.string()), HasSubstr("is a folder")));
	EXPECT_THAT(refusalOf(write("huge.ini", std::string((1U << 20U) + 1, '#'))), HasSubstr("larger than 1 MiB"));
	EXPECT_THAT(refusalOf(write("a.rawlog", std::string("\x1f\x8b\x08\x00\x00", 5))), HasSubstr("not an ini file"));
}

TEST_F(IniFile, emptyFilesAndVeryLongLinesAreFine)
{
	EXPECT_EQ(refusalOf(write("empty.ini", "")), "");
	EXPECT_EQ(refusalOf(write("long.ini", "# " + std::string(1000000, 'x') + "\n[shape]\ncount = 1")), "");
	EXPECT_EQ(refusalOf(write("limit.ini", std::string(1U << 20U, '\n'))), "");
}

TEST_F(IniFile, isFoundAsAPathFirstThenInTheFolders)
{
	const auto here = write("here.ini", "");
	const auto shipped = write("inis/shipped.ini", "");
	EXPECT_EQ(findIni(here.string(), {m_folder / "inis"}), here);
	EXPECT_EQ(findIni("shipped.ini", {m_folder, m_folder / "inis"}), shipped);
}

TEST_F(IniFile, aMissListsEveryPlace)
{
	try
	{
		findIni("inis", {m_folder, m_folder / "inis"});
		FAIL() << "a folder was taken for an ini file";
	}
	catch (const ConfigError& error)
	{
		EXPECT_THAT(error.what(), AllOf(HasSubstr("'inis'"), HasSubstr((m_folder / "inis").string() + " (a folder)"),
		                                HasSubstr((m_folder / "inis" / "inis").string())));
	}
}
}  // namespace
}  // namespace explore
