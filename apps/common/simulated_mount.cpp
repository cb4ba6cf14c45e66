#include <common/simulated_mount.h>
#include <explore/simulation/recorder.h>

namespace explore::app
{
mrpt::poses::CPose3D simulatedMount(const CameraConfig& camera, RobotKind kind)
{
	if (camera.mount != MountPolicy::ini) return simulation::usualMount(kind);
	return {camera.x_m, camera.y_m, camera.z_m, camera.yaw_rad, camera.pitch_rad, camera.roll_rad};
}
}  // namespace explore::app
