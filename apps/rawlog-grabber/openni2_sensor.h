// Our OpenNI2 client as a sensor of MRPT's rawlog-grabber, which takes sensors of others from a shared library (-p).
#pragma once

#include <explore/openni2/live_camera.h>
#include <explore/openni2/openni2_source.h>
#include <mrpt/hwdrivers/CGenericSensor.h>

#include <optional>

namespace explore::app
{
/** The sensor `driver = ExploreOpenNI2`. Its section of rawlog-grabber's ini has, beside the keys of every sensor,
 * those of [openni2] (doc/ini-reference.md) and the mount pose_x … pose_roll (metres, degrees). Each depth image is a
 *  CObservation3DRangeScan as explore-rawlog record writes it. */
class ExploreOpenNI2 : public mrpt::hwdrivers::CGenericSensor
{
	DEFINE_GENERIC_SENSOR(ExploreOpenNI2)

public:
	/** Opens the camera. Throws ConfigError, and SensorLost with what to check. */
	void initialize() override;
	/** Hands over the latest frame, waiting for it for a twentieth of a second. Throws SensorLost when the camera is
	 * lost; until then it is opened again. */
	void doProcess() override;

protected:
	/** Throws ConfigError that names section and key; loadConfig() makes an exception of MRPT of it. */
	void loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini, const std::string& section) override;

private:
	SourceConfig m_config;
	std::optional<openni2::LiveCamera> m_camera;
	openni2::HostTime m_time;
};
}  // namespace explore::app
