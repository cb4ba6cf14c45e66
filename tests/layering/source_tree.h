// The project's sources as text, and the include directives in them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace explore::test
{
/** Text of each file by its path below the root, with forward slashes: "libexplore/explore/core/geometry.h". */
using SourceTree = std::map<std::string, std::string>;

/** One #include directive. `target` is what stands between <> or "", or the whole rest of the line for a macro. */
struct Include
{
	enum class Form
	{
		angled,
		quoted,
		computed
	};
	std::string target;
	Form form = Form::angled;
	int line = 0;  ///< from 1
};

/** All files below root/folder, for each of `folders`, whose name ends in .h, .cpp or .cmake. */
SourceTree readSources(const std::filesystem::path& root, const std::vector<std::string>& folders);

/** `text` with comments and the contents of literals blanked out; line breaks and the quotes of #include stay. */
std::string withoutComments(std::string_view text);

/** The include directives of `text`, those in comments and literals left out. */
std::vector<Include> includesOf(std::string_view text);

/** The file of `tree` that `include`, found in file `from`, reads; empty when it lies outside of the tree. Angled
 *  includes start at libexplore/ or apps/, quoted ones at the including file's folder. */
std::string resolve(const SourceTree& tree, const std::string& from, const Include& include);
}  // namespace explore::test
