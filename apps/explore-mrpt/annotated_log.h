// annotated.rawlog: the input as it was, and after each depth frame what was made of it.
#pragma once

#include <explore-mrpt/checkpoint.h>
#include <explore/sinks/annotations.h>
#include <explore/sinks/output_file.h>
#include <explore/sources/log_time.h>
#include <explore/sources/rawlog_reader.h>
#include <explore/sources/source.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace explore::app
{
/** What the log begins with, and where its input comes from. */
struct AnnotatedInput
{
	std::string comment;           ///< version and ini
	std::filesystem::path rawlog;  ///< empty: the frames themselves are all there is
	std::filesystem::path images;  ///< folder that the input's external files are relative to
};
AnnotatedInput annotatedInput(const RunBeginning& beginning, const SourceConfig& config, const SourceReport& source);

/** Grows by one part of a gzip file per frame, each whole: it can be read, and gone on with, after every one.
 *  The input is read a second time, in step with the frames. */
class AnnotatedLog
{
public:
	struct Files
	{
		std::filesystem::path log;
		std::filesystem::path images;  ///< becomes a link to the input's, where it has external files
	};
	/** So much was there when the state of a run was kept. */
	struct Place
	{
		std::uint64_t bytes = 0;
		std::uint64_t inputs = 0;  ///< objects of the input
	};

	/** A new log. Throws OutputError, or InputError where the input cannot be read. */
	AnnotatedLog(const Files& files, AnnotatedInput input, const RobotConfig& robot);
	/** Goes on with one. Throws InputError where it is shorter, or the input is. */
	AnnotatedLog(const Files& files, AnnotatedInput input, const RobotConfig& robot, const Place& place);

	/** The input up to the frame's own observation, or the frame itself, and its annotations. Throws OutputError. */
	void add(const DepthFrame& frame, const FrameSketch& sketch);
	/** What of the input came after the last frame. Throws OutputError. */
	void addRest();
	[[nodiscard]] Place place() const { return {m_file.bytes(), m_inputs}; }
	void close() { m_file.close(); }

private:
	bool copyOne(const std::optional<std::string>& depth_label);
	void copyUpTo(const DepthFrame& frame);
	void copy(const mrpt::obs::CObservation& observation);
	const std::string& commentWith(const std::string& text);
	void linkImages() const;
	void put(const mrpt::serialization::CSerializable& object);
	void flush();

	Files m_files;
	AnnotatedInput m_input;
	RobotConfig m_robot;
	OutputFile m_file;
	std::unique_ptr<RawlogReader> m_reader;
	std::uint64_t m_inputs = 0;            ///< objects read
	std::vector<LogTime> m_depths_copied;  ///< by the last object, and not yet followed by annotations
	std::optional<LogTime> m_last_depth;
	bool m_begun = false;
	std::string m_bytes;  ///< not yet in the file
};
}  // namespace explore::app
