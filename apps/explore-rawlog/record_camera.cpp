#include <common/app_config.h>
#include <common/exit_codes.h>
#include <common/interrupt.h>
#include <explore-rawlog/record_camera.h>
#include <explore/core/errors.h>
#include <explore/openni2/oni_source.h>
#include <explore/openni2/openni2_source.h>
#include <explore/sources/log_time.h>
#include <explore/sources/rawlog_writer.h>

#include <iostream>

namespace explore::app
{
namespace
{
using namespace explore::openni2;
using namespace std::chrono_literals;

void say(const std::string& text)
{
	std::cerr << "explore-rawlog: " << text << '\n';
}

int printList()
{
	const Library library;
	const std::string list = textOf(listDevices());
	if (list.empty()) throw SensorLost("no depth camera was found through OpenNI2\n" + whatToCheck());
	std::cout << list;
	return kDone;
}

SourceConfig sourceConfigOf(const CameraRecordOptions& options)
{
	ConfigChoices choices;
	choices.ini = options.ini;
	choices.set = options.set;
	SourceConfig config = loadConfig(choices).config.source;
	if (options.device && !options.device->empty()) config.openni2.device = *options.device;
	return config;
}

ScanHeader headerFor(const CameraRecordOptions& options, const SourceConfig& config)
{
	ScanHeader header = headerOf(config);
	if (!options.mount.empty()) header.robot_from_camera = poseOfOption(options.mount);
	return header;
}

/** The log as it grows. */
class Log
{
public:
	Log(const CameraRecordOptions& options, const SourceConfig& config)
	    : m_header(headerFor(options, config)),
	      m_path(options.out),
	      m_seconds(options.seconds),
	      m_color(config.openni2.color)
	{
	}

	/** Returns false when it was taken after the time that was asked for, and so was not written. */
	bool write(const RawDepth& raw, LogTime time)
	{
		if (m_frames == 0) m_first = time;
		if (m_seconds > 0.0 && secondsBetween(m_first, time) >= m_seconds) return false;
		if (!m_writer) m_writer.emplace(m_path);  // late: what cannot be opened leaves an older file alone
		m_writer->write(scanOf(raw, time, m_header));
		m_last = time;
		++m_frames;
		if (!raw.color) ++m_without_color;
		return true;
	}
	void close()
	{
		if (m_writer) m_writer->close();
		if (m_frames == 0) return;
		std::cout << m_path << ": " << m_frames << " frames, " << secondsBetween(m_first, m_last) << " s\n";
		if (m_color && m_without_color > 0)
			say("warning: " + std::to_string(m_without_color) + " frames have no colour image: none came with them");
	}
	[[nodiscard]] std::size_t frames() const { return m_frames; }

private:
	ScanHeader m_header;
	std::string m_path;
	double m_seconds;
	bool m_color;
	std::optional<RawlogWriter> m_writer;
	std::size_t m_frames = 0, m_without_color = 0;
	LogTime m_first, m_last;
};

void pass(LiveCamera& camera)
{
	for (const std::string& text : camera.takeTold()) say("warning: " + text);
}

int recordLive(const CameraRecordOptions& options, const SourceConfig& config)
{
	catchSignals();
	LiveCamera camera(config.openni2);
	Log log(options, config);
	HostTime times;
	std::optional<std::string> loss;
	try
	{
		for (bool goes_on = true; goes_on && signalReceived() == 0; pass(camera))
			if (const auto raw = camera.take(500ms)) goes_on = log.write(*raw, times.of(*raw));
	}
	catch (const SensorLost& error)
	{
		loss = error.what();
	}
	log.close();
	const Mailbox::Counts counts = camera.counts();
	if (counts.dropped > 0) say("warning: " + std::to_string(counts.dropped) + " frames came too fast to be written");
	if (counts.bad > 0) say("warning: " + std::to_string(counts.bad) + " frames were not whole");
	if (loss) throw SensorLost(*loss);
	return signalReceived() != 0 ? kSignalBase + signalReceived() : kDone;
}

int recordFile(const CameraRecordOptions& options, const SourceConfig& config)
{
	catchSignals();
	OniFile file(options.oni, config.openni2);
	Log log(options, config);
	RecordedTime times;
	std::size_t bad = 0;
	for (bool goes_on = true; goes_on && signalReceived() == 0;) try
		{
			const auto raw = file.next();
			goes_on = raw && log.write(*raw, times.of(*raw));
		}
		catch (const BadFrame& why)
		{
			if (bad++ == 0) say("warning: " + options.oni + ": a frame cannot be used: " + why.what());
		}
	log.close();
	if (signalReceived() != 0) return kSignalBase + signalReceived();
	if (!file.damage().empty()) throw InputError(options.oni + ": damaged: " + file.damage());
	if (bad > 0 || log.frames() == 0)
		throw InputError(options.oni + ": " + std::to_string(bad) + " frames cannot be used");
	return kDone;
}
}  // namespace

int recordCamera(const CameraRecordOptions& options)
{
	if (options.device == "list") return printList();
	if (options.out.empty()) throw ConfigError("--out LOG.rawlog is needed");
	const SourceConfig config = sourceConfigOf(options);
	return options.device ? recordLive(options, config) : recordFile(options, config);
}
}  // namespace explore::app
