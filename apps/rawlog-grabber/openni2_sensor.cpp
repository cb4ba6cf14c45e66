#include <explore/config/field_list.h>
#include <explore/config/ini.h>
#include <mrpt/system/string_utils.h>
#include <rawlog-grabber/openni2_sensor.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace explore::app
{
namespace
{
using namespace std::chrono_literals;
using mrpt::system::lowerCase;

/** What rawlog-grabber and CGenericSensor read from every sensor's section. */
constexpr std::array<std::string_view, 7> kOfEverySensor{"driver",
                                                         "process_rate",
                                                         "max_queue_len",
                                                         "grab_decimation",
                                                         "sensorlabel",
                                                         "external_images_format",
                                                         "external_images_jpeg_quality"};

/** The keys of one section of rawlog-grabber's ini as an ini of ours, where they belong to two. */
std::string iniTextOf(const mrpt::config::CConfigFileBase& ini, const std::string& section,
                      const std::vector<Section>& sections)
{
	std::vector<std::string> keys;
	ini.getAllKeys(section, keys);
	const Section& camera = *findSection(sections, "camera");
	std::string of_openni2 = "[openni2]\n", of_camera = "[camera]\nmount = ini\n";
	for (const std::string& key : keys)
	{
		if (std::ranges::find(kOfEverySensor, lowerCase(key)) != kOfEverySensor.end()) continue;
		const bool of_mount = lowerCase(key).starts_with("pose_") && findField(camera, key) != nullptr;
		(of_mount ? of_camera : of_openni2) += key + " = " + ini.read_string(section, key, "") + '\n';
	}
	return of_openni2 + of_camera;
}
}  // namespace

IMPLEMENTS_GENERIC_SENSOR(ExploreOpenNI2, explore::app)

void ExploreOpenNI2::loadConfig_sensorSpecific(const mrpt::config::CConfigFileBase& ini, const std::string& section)
{
	SourceConfig config;
	const DescribeFields fields = [&config](FieldVisitor& visitor) { describe(visitor, config); };
	loadIniText("section " + section, iniTextOf(ini, section, listSections(fields)), {}, fields);
	config.sensor_label = m_sensorLabel;
	m_config = config;
}

void ExploreOpenNI2::initialize()
{
	m_state = ssInitializing;
	m_camera.emplace(m_config.openni2);
	m_state = ssWorking;
}

void ExploreOpenNI2::doProcess()
{
	try
	{
		const auto raw = m_camera->take(50ms);
		for (const std::string& text : m_camera->takeTold()) std::cerr << m_sensorLabel << ": " << text << '\n';
		if (!raw) return;
		appendObservation(std::make_shared<mrpt::obs::CObservation3DRangeScan>(
		    openni2::scanOf(*raw, m_time.of(*raw), openni2::headerOf(m_config))));
	}
	catch (const std::exception&)
	{
		m_state = ssError;
		throw;
	}
}

namespace
{
/** Whoever loads the library has the sensor. */
const bool kRegistered = (ExploreOpenNI2::doRegister(), true);
}  // namespace
}  // namespace explore::app
