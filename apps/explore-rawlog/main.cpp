#include <common/guarded_main.h>
#include <explore-rawlog/run.h>

#include <csignal>

int main(int argc, char** argv)
{
	// Beyond a file size limit the write then fails, and is reported as any other.
	std::signal(SIGXFSZ, SIG_IGN);
	return explore::app::guardedMain("explore-rawlog", [&] { return explore::app::runRawlogTool(argc, argv); });
}
