// Every form in which a rawlog holds depth comes out as the depth that went in.
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <cmath>

#include "rawlog_fixture.h"

namespace explore::test
{
namespace
{
using mrpt::obs::CObservation3DRangeScan;

constexpr double kRounding_m = 1e-6;

/** Distances from the camera instead of depths, in tenths of a millimetre so that rounding stays small. */
void turnIntoRanges(CObservation3DRangeScan& scan, const DepthImage& truth)
{
	const CameraIntrinsics& camera = truth.intrinsics;
	scan.range_is_depth = false;
	scan.rangeUnits = 1e-4F;
	for (int v = 0; v < camera.height_px; ++v)
		for (int u = 0; u < camera.width_px; ++u)
		{
			const double right = (u - camera.cx_px) / camera.fx_px, down = (v - camera.cy_px) / camera.fy_px;
			const double range_m = truth.at(u, v) * std::sqrt(1.0 + right * right + down * down);
			scan.rangeImage(v, u) = static_cast<std::uint16_t>(std::min(65535L, std::lround(range_m * 1e4)));
		}
}

/** The truth where 16 bits of 0.1 mm suffice for it; beyond, whatever was read. */
DepthImage reachableByRanges(DepthImage truth, const DepthImage& read)
{
	for (std::size_t i = 0; i < truth.depth_m.size(); ++i)
		if (truth.depth_m[i] > 5.0F) truth.depth_m[i] = read.depth_m.at(i);
	return truth;
}

enum class Layout
{
	observations,
	sensory_frames
};

Objects logOf(const std::vector<CObservation3DRangeScan::Ptr>& scans, Layout layout)
{
	Objects objects;
	for (const auto& scan : scans)
	{
		if (layout == Layout::observations)
		{
			objects.push_back(scan);
			continue;
		}
		auto sensory_frame = mrpt::obs::CSensoryFrame::Create();
		sensory_frame->insert(scan);
		objects.push_back(mrpt::obs::CActionCollection::Create());
		objects.push_back(sensory_frame);
	}
	return objects;
}

struct Form
{
	Layout layout;
	Packing packing;
	bool is_depth;
	std::string external;  ///< extension of the external file, empty = embedded
};

class EveryForm : public testing::TestWithParam<Form>
{
};

TEST_P(EveryForm, RoundTrips)
{
	const Form form = GetParam();
	const auto log = testFolder() / "run.rawlog", images = testFolder() / "run_Images";
	std::filesystem::create_directories(images);
	const std::vector<DepthFrame> truth = {sceneFrame(0.0), sceneFrame(0.5), sceneFrame(1.0)};
	std::vector<CObservation3DRangeScan::Ptr> scans;
	for (std::size_t i = 0; i < truth.size(); ++i)
	{
		const auto scan = scanOf(truth[i], 0.1 * static_cast<double>(i));
		if (!form.is_depth) turnIntoRanges(*scan, truth[i].image);
		CObservation3DRangeScan::EXTERNALS_AS_TEXT(form.external == "txt");
		if (!form.external.empty())
			scan->rangeImage_convertToExternalStorage("range_" + std::to_string(i) + "." + form.external,
			                                          images.string() + "/");
		scans.push_back(scan);
	}
	writeRawlog(log, logOf(scans, form.layout), form.packing);

	SourceReport report;
	const auto frames = replay(configFor(log), &report);
	ASSERT_EQ(frames.size(), truth.size());
	for (std::size_t i = 0; i < truth.size(); ++i)
	{
		EXPECT_EQ(frames[i].index, i);
		EXPECT_EQ(frames[i].sensor_label, "CAM");
		EXPECT_EQ(frames[i].timestamp, at(0.1 * static_cast<double>(i)));
		EXPECT_TRUE(frames[i].points_in_camera.empty());
		const DepthImage stored = form.is_depth ? truth[i].image : reachableByRanges(truth[i].image, frames[i].image);
		expectSameDepths(frames[i].image, stored, form.is_depth ? kRounding_m : 1e-4);
		expectSamePose(frames[i].robot_from_camera, truth[i].robot_from_camera);
	}
	EXPECT_EQ(report.damage, "");
	EXPECT_EQ(report.frames, truth.size());
	EXPECT_EQ(report.skipped_frames, 0U);
	EXPECT_EQ(report.lost_bytes, 0U);
}

INSTANTIATE_TEST_SUITE_P(Rawlog, EveryForm,
                         testing::Values(Form{Layout::observations, Packing::gzipped, true, ""},
                                         Form{Layout::observations, Packing::plain, true, ""},
                                         Form{Layout::sensory_frames, Packing::gzipped, true, ""},
                                         Form{Layout::sensory_frames, Packing::plain, true, ""},
                                         Form{Layout::observations, Packing::gzipped, false, ""},
                                         Form{Layout::sensory_frames, Packing::plain, false, ""},
                                         Form{Layout::observations, Packing::gzipped, true, "bin"},
                                         Form{Layout::observations, Packing::plain, true, "txt"},
                                         Form{Layout::sensory_frames, Packing::gzipped, false, "bin"}));

}  // namespace
}  // namespace explore::test
