#include <explore/core/byte_archive.h>

namespace explore
{
mrpt::poses::CPose3D poseFrom(const Eigen::Vector3d& place, const Eigen::Matrix3d& rotation,
                              const Eigen::Vector3d& yaw_pitch_roll)
{
	mrpt::poses::CPose3D pose(place.x(), place.y(), place.z(), yaw_pitch_roll.x(), yaw_pitch_roll.y(),
	                          yaw_pitch_roll.z());
	// Angles give a rotation and a rotation gives angles, each with a rounding: whichever the pose was made of fits.
	if (pose.getRotationMatrix().asEigen() != rotation)
		pose = mrpt::poses::CPose3D(mrpt::math::CMatrixDouble33(rotation), mrpt::math::CVectorFixedDouble<3>(place));
	return pose;
}
}  // namespace explore
