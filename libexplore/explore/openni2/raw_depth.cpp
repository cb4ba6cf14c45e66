#include <explore/openni2/raw_depth.h>

#include <algorithm>

namespace explore::openni2
{
namespace
{
mrpt::img::TCamera paramsOf(const CameraIntrinsics& camera)
{
	mrpt::img::TCamera params;
	params.ncols = static_cast<std::uint32_t>(camera.width_px);
	params.nrows = static_cast<std::uint32_t>(camera.height_px);
	params.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
	return params;
}

void addColor(mrpt::obs::CObservation3DRangeScan& scan, const ColorImage& color)
{
	const auto width = static_cast<unsigned>(color.intrinsics.width_px);
	const auto height = static_cast<unsigned>(color.intrinsics.height_px);
	scan.hasIntensityImage = true;
	scan.intensityImageChannel = mrpt::obs::CObservation3DRangeScan::CH_VISIBLE;
	scan.cameraParamsIntensity = paramsOf(color.intrinsics);
	scan.intensityImage.resize(width, height, mrpt::img::CH_RGB);
	auto rgb = color.pixels.begin();
	for (unsigned v = 0; v < height; ++v)
		for (unsigned u = 0; u < width; ++u, ++rgb)
			std::reverse_copy(rgb->begin(), rgb->end(), scan.intensityImage.ptr<std::uint8_t>(u, v));
}
}  // namespace

mrpt::obs::CObservation3DRangeScan scanOf(const RawDepth& raw, mrpt::Clock::time_point time, const ScanHeader& header)
{
	const CameraIntrinsics& camera = raw.intrinsics;
	mrpt::obs::CObservation3DRangeScan scan;
	scan.timestamp = time;
	scan.sensorLabel = header.sensor_label;
	scan.sensorPose = header.robot_from_camera;
	scan.hasRangeImage = true;
	scan.range_is_depth = true;
	scan.rangeUnits = raw.unit_m;
	scan.maxRange = 65535.0F * raw.unit_m;
	scan.cameraParams = paramsOf(camera);
	scan.rangeImage.resize(camera.height_px, camera.width_px);
	std::copy(raw.depth.begin(), raw.depth.end(), scan.rangeImage.data());
	if (raw.color) addColor(scan, *raw.color);
	return scan;
}
}  // namespace explore::openni2
