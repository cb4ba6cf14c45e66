#include <common/guarded_main.h>
#include <explore-eval/options.h>
#include <explore-eval/run.h>
#include <explore/core/heap.h>

int main(int argc, char** argv)
{
	using namespace explore;
	keepFreedMemory();
	const auto body = [&]
	{
		const auto parsed = app::parseEvalOptions(argc, argv);
		return parsed.exit_code ? *parsed.exit_code : app::runEval(parsed.options);
	};
	return app::guardedMain("explore-eval", body);
}
