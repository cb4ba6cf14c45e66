// The rules of doc/ARCHITECTURE.md, applied to the project's own sources.
#include "layer_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace explore::test;

namespace
{
constexpr int kMaxLines = 250;

SourceTree projectSources()
{
	SourceTree tree = readSources(EXPLORE_SOURCE_DIR, {"libexplore", "apps"});
	EXPECT_TRUE(tree.contains("libexplore/explore/core/geometry.h")) << "sources were not found";
	return tree;
}

void expectNone(const std::vector<std::string>& violations)
{
	for (const std::string& violation : violations) ADD_FAILURE() << violation;
}
}  // namespace

TEST(Project, IncludesFollowTheLayerOrder)
{
	expectNone(includeViolations(projectSources(), projectLayers()));
}
TEST(Project, LinksFollowTheLayerOrder)
{
	expectNone(linkViolations(projectSources(), projectLayers()));
}
TEST(Project, ReadsClocksAtItsEndsOnly)
{
	expectNone(clockViolations(projectSources(), projectLayers()));
}
TEST(Project, HasNoIncludeCycle)
{
	expectNone(includeCycles(projectSources()));
}
TEST(Project, FilesHaveAPurposeAndASize)
{
	expectNone(shapeViolations(projectSources(), kMaxLines));
}

TEST(Project, HasAFolderForEveryLayer)
{
	const SourceTree tree = projectSources();
	for (const Layer& layer : projectLayers())
	{
		const auto first = tree.lower_bound(layer.folder);
		EXPECT_TRUE(first != tree.end() && first->first.starts_with(layer.folder)) << layer.folder << " has no sources";
	}
}
