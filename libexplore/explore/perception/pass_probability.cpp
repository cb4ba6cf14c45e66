#include <explore/perception/pass_probability.h>

#include <cmath>

namespace explore
{
namespace
{
int voteOf(const PassTree& tree, const OpeningFeatures& features)
{
	const PassNode* node = tree.data();
	while (node->feature >= 0)
	{
		const bool yes = features.at(static_cast<std::size_t>(node->feature)) > node->threshold;
		node = &tree.at(static_cast<std::size_t>(node->next) + static_cast<std::size_t>(yes));
	}
	return node->next;
}
}  // namespace

double passProbability(const OpeningFeatures& features, std::span<const PassTree> trees)
{
	int sum = 0;
	for (const PassTree& tree : trees) sum += voteOf(tree, features);
	return 1.0 / (1.0 + std::exp(-1e-3 * sum));
}
}  // namespace explore
