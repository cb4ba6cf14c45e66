#include <common/app_config.h>
#include <explore-rawlog/noise_options.h>
#include <explore-rawlog/synth_logs.h>
#include <explore/core/errors.h>
#include <explore/evaluation/truth_file.h>
#include <explore/simulation/scenes/scene_log.h>
#include <explore/sources/rawlog_writer.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <sstream>
#include <system_error>
#include <thread>

namespace explore::app
{
namespace
{
/** Time of the first look, seconds since 1970: fixed, so that the same command gives the same bytes. */
constexpr double kStart_s = 1'500'000'000.0;

void writeLog(const SynthTask& task, const SynthConfig& config)
{
	simulation::SceneLogConfig scenes;
	scenes.seed = config.seed;
	scenes.count = config.count;
	scenes.looks = config.looks;
	scenes.robot = robotDefaults(task.robot);
	scenes.camera = config.camera;
	scenes.start = mrpt::Clock::fromDouble(kStart_s);

	const std::filesystem::path path = logPathOf(task, config);
	RawlogWriter writer(path);
	TruthLog truth = simulation::recordScenes(*task.family, scenes,
	                                          [&writer](const mrpt::obs::CObservation& o) { writer.write(o); });
	writer.close();
	truth.command = commandOf(task, config);
	truth.noise = noiseName(config.camera);
	evaluation::writeTruth(evaluation::truthPathOf(path), truth);
}

/** Which tasks are taken and done, shared by the threads. */
class Progress
{
public:
	explicit Progress(std::size_t tasks)
	    : m_done(tasks), m_errors(tasks)  // NOLINT(bugprone-throw-keyword-missing): a list of errors to come
	{
	}

	/** The next task; none after the last or after a failure. */
	std::optional<std::size_t> take()
	{
		const std::lock_guard lock(m_mutex);
		if (m_failed || m_next == m_done.size()) return std::nullopt;
		return m_next++;
	}
	void finish(std::size_t task, std::exception_ptr error)
	{
		const std::lock_guard lock(m_mutex);
		m_done[task] = true;
		m_failed = m_failed || error;
		m_errors[task] = std::move(error);
		m_changed.notify_all();
	}
	/** Waits for the task; throws what it threw. */
	void wait(std::size_t task)
	{
		std::unique_lock lock(m_mutex);
		m_changed.wait(lock, [&] { return m_done[task]; });
		if (m_errors[task]) std::rethrow_exception(m_errors[task]);
	}

private:
	std::mutex m_mutex;
	std::condition_variable m_changed;
	std::vector<bool> m_done;
	std::vector<std::exception_ptr> m_errors;
	std::size_t m_next = 0;
	bool m_failed = false;
};

void work(const std::vector<SynthTask>& tasks, const SynthConfig& config, Progress& progress)
{
	while (const auto task = progress.take())
	{
		std::exception_ptr error;
		try
		{
			writeLog(tasks[*task], config);
		}
		catch (...)
		{
			error = std::current_exception();
		}
		progress.finish(*task, error);
	}
}

void makeFolder(const std::filesystem::path& folder)
{
	std::error_code error;
	std::filesystem::create_directories(folder, error);
	if (error) throw OutputError(folder.string() + ": the folder cannot be made: " + error.message());
}
}  // namespace

std::filesystem::path logPathOf(const SynthTask& task, const SynthConfig& config)
{
	std::string name(task.family->name);
	return config.out / name.append("-").append(nameOf(task.robot)).append(".rawlog");
}

std::string commandOf(const SynthTask& task, const SynthConfig& config)
{
	std::ostringstream command;
	command << "explore-rawlog synth --family " << task.family->name << " --count " << config.count << " --seed "
	        << config.seed << " --robot " << nameOf(task.robot) << " --looks " << config.looks << " --size "
	        << config.camera.intrinsics.width_px << " --noise " << simulation::nameOf(config.camera.noise)
	        << noiseArguments(config.camera.noise_scale, config.camera.hole_share)
	        << (config.camera.color ? " --color" : "") << " --out .";
	return command.str();
}

void writeLogs(const std::vector<SynthTask>& tasks, const SynthConfig& config, int jobs,
               const std::function<void(const SynthTask&)>& written)
{
	makeFolder(config.out);
	Progress progress(tasks.size());
	std::vector<std::jthread> threads;
	for (int i = 0; i < std::min(jobs, static_cast<int>(tasks.size())); ++i)
		threads.emplace_back([&] { work(tasks, config, progress); });
	// Tasks are taken in their order: those before one that failed are done, or will be.
	for (std::size_t task = 0; task < tasks.size(); ++task)
	{
		progress.wait(task);
		written(tasks[task]);
	}
}
}  // namespace explore::app
