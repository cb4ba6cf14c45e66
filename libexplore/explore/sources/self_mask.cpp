#include "self_mask.h"

#include <explore/core/errors.h>
#include <mrpt/img/CImage.h>

#include <filesystem>

namespace explore
{
namespace
{
mrpt::img::CImage loadMask(const std::string& path)
{
	constexpr int kGrayscale = 0;
	mrpt::img::CImage image;
	if (!std::filesystem::exists(path))
		throw ConfigError("[camera] self_mask = " + path +
		                  ": no such file; an image of the depth image's size is needed");
	if (!image.loadFromFile(path, kGrayscale) || image.isEmpty())
		throw ConfigError("[camera] self_mask = " + path + ": cannot be read; a PNG or other image file is needed");
	return image;
}
}  // namespace

SelfMask::SelfMask(const std::string& path) : m_path(path)
{
	if (path.empty()) return;
	const mrpt::img::CImage image = loadMask(path);
	m_width_px = static_cast<int>(image.getWidth());
	m_height_px = static_cast<int>(image.getHeight());
	for (int v = 0; v < m_height_px; ++v)
		for (int u = 0; u < m_width_px; ++u)
			m_robot.push_back(image.at<std::uint8_t>(static_cast<unsigned>(u), static_cast<unsigned>(v)) != 0);
}

void SelfMask::apply(int width_px, int height_px, std::vector<float>& values) const
{
	if (m_path.empty()) return;
	if (width_px != m_width_px || height_px != m_height_px)
		throw ConfigError("[camera] self_mask = " + m_path + ": has " + std::to_string(m_width_px) + "x" +
		                  std::to_string(m_height_px) + " pixels, the depth images have " + std::to_string(width_px) +
		                  "x" + std::to_string(height_px));
	for (std::size_t i = 0; i < values.size(); ++i)
		if (m_robot[i]) values[i] = 0.0F;
}
}  // namespace explore
