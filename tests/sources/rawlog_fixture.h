// Writes rawlogs of analytic scenes with MRPT's own classes, and replays them with the source under test.
#pragma once

#include <explore/sources/source.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <mrpt/obs/CObservation3DRangeScan.h>
#include <mrpt/serialization/CSerializable.h>

#include <filesystem>
#include <string>
#include <vector>

namespace explore::test
{
/** A logger that keeps what was said. */
class Listener : public mrpt::system::COutputLogger
{
public:
	Listener();
	/** Messages of level WARN and above that contain `part`. */
	[[nodiscard]] std::size_t warnings(const std::string& part) const;
	[[nodiscard]] bool said(const std::string& part) const;

private:
	std::vector<std::pair<mrpt::system::VerbosityLevel, std::string>> m_messages;
};

/** A folder of its own for each test, empty at first. */
std::filesystem::path testFolder();

using Objects = std::vector<mrpt::serialization::CSerializable::Ptr>;

enum class Packing
{
	gzipped,
	plain
};
/** The objects one after the other, as rawlog-grabber writes them. */
void writeRawlog(const std::filesystem::path& path, const Objects& objects, Packing packing = Packing::gzipped);

std::string readBytes(const std::filesystem::path& path);
void writeBytes(const std::filesystem::path& path, const std::string& bytes);

/** seconds after a fixed start. */
mrpt::Clock::time_point at(double seconds);

/** A corridor seen from its middle, 80×60 pixels, with depths that are whole millimetres. */
DepthFrame sceneFrame(double x_in_map_m = 0.0);

/** The frame as an observation with an embedded depth image in millimetres, label "CAM", at time `seconds`. */
mrpt::obs::CObservation3DRangeScan::Ptr scanOf(const DepthFrame& frame, double seconds);

/** Six frames of the corridor, 10 a second, each after an odometry reading. */
inline constexpr std::size_t kSampleFrames = 6;
Objects sampleLog();
/** The sample log's file, which is whole.rawlog in the test's folder. */
std::string sampleBytes(Packing packing);

SourceConfig configFor(const std::filesystem::path& rawlog);

/** All frames of the log; `report` and `listener` may be null. */
std::vector<DepthFrame> replay(const SourceConfig& config, SourceReport* report = nullptr,
                               Listener* listener = nullptr);

/** Every depth equals the truth's within `tolerance_m`. */
void expectSameDepths(const DepthImage& image, const DepthImage& truth, double tolerance_m);

/** Nothing that leaves the source may be infinite, NaN or negative. */
void expectFinite(const DepthFrame& frame);

void expectSamePose(const mrpt::poses::CPose3D& pose, const mrpt::poses::CPose3D& truth, double tolerance = 1e-9);
}  // namespace explore::test
