#include <common/guarded_main.h>
#include <explore-mrpt/options.h>
#include <explore-mrpt/run.h>
#include <explore/core/heap.h>

int main(int argc, char** argv)
{
	using namespace explore;
	keepFreedMemory();
	const auto body = [&]
	{
		const auto parsed = app::parseOptions(argc, argv);
		return parsed.exit_code ? *parsed.exit_code : app::run(parsed.options);
	};
	return app::guardedMain("explore-mrpt", body);
}
