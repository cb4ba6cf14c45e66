// Turns the depth observations that MRPT knows into depth images and clouds in the camera frame.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/sources/lens_distortion.h>
#include <explore/sources/self_mask.h>
#include <explore/sources/source_config.h>
#include <mrpt/obs/CObservation.h>
#include <mrpt/obs/CObservation3DRangeScan.h>

#include <filesystem>

namespace explore
{
/** True for CObservation3DRangeScan, CObservationPointCloud and CObservationVelodyneScan. */
[[nodiscard]] bool isDepthObservation(const mrpt::obs::CObservation& observation);

/** z' = offset + scale·z + quadratic·z² [m]; 0 (no return) stays 0, and so does what becomes negative. */
[[nodiscard]] float correctedDepth(const CameraConfig& camera, float depth_m);

class DepthConverter
{
public:
	/** `images_folder` holds external files. Throws ConfigError for a self mask that cannot be read. */
	DepthConverter(const SourceConfig& config, std::filesystem::path images_folder);

	/** The frame with its image or cloud, label and mount; time, index and robot pose are left to the caller.
	 *  Range images: masked, lens distortion removed by resampling, ranges turned into depths, depth corrected; a range
	 *  image is preferred where a scan has points too, and its other layers are left alone. Points-only scans and other
	 *  sensors: a cloud without the non-finite points and those at the sensor; depth correction scales the points of
	 * scans along their rays, other sensors' points stay. Throws UnusableFrame, or ConfigError for a mask of the wrong
	 * size. */
	[[nodiscard]] DepthFrame convert(mrpt::obs::CObservation& observation);

private:
	[[nodiscard]] DepthImage imageOf(const mrpt::obs::CObservation3DRangeScan& scan);
	[[nodiscard]] PointCloud cloudOf(const mrpt::obs::CObservation3DRangeScan& scan) const;
	[[nodiscard]] mrpt::poses::CPose3D mountOf(const mrpt::obs::CObservation& observation) const;
	void correct(std::vector<float>& depth_m) const;

	CameraConfig m_camera;
	SensorPoses m_sensor_poses;
	std::filesystem::path m_images_folder;
	SelfMask m_mask;
	Undistorter m_undistorter;
};
}  // namespace explore
