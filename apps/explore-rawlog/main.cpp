#include <common/guarded_main.h>
#include <explore-rawlog/run.h>

int main(int argc, char** argv)
{
	return explore::app::guardedMain("explore-rawlog", [&] { return explore::app::runRawlogTool(argc, argv); });
}
