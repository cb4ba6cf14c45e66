#include <explore/openni2/raw_depth.h>

#include <algorithm>

namespace explore::openni2
{
void unmirror(std::vector<std::uint16_t>& depth, int width_px)
{
	for (auto row = depth.begin(); depth.end() - row >= width_px; row += width_px) std::reverse(row, row + width_px);
}

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
	scan.cameraParams.ncols = static_cast<std::uint32_t>(camera.width_px);
	scan.cameraParams.nrows = static_cast<std::uint32_t>(camera.height_px);
	scan.cameraParams.setIntrinsicParamsFromValues(camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
	scan.rangeImage.resize(camera.height_px, camera.width_px);
	std::copy(raw.depth.begin(), raw.depth.end(), scan.rangeImage.data());
	return scan;
}
}  // namespace explore::openni2
