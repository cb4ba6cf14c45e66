#include <explore/perception/near_field.h>

#include <algorithm>
#include <vector>

namespace explore
{
namespace
{
constexpr int kSampledColumns = 160;  // of the image: strips are far coarser than that
constexpr double kFloorClearance_m = 0.1;
constexpr double kNearestShare = 0.01;  // of a strip's pixels: fewer are noise
constexpr std::size_t kMinPixels = 4;

/** Heights above `ground` of the points along the pixel rays: height = offset + depth · (forward + u-part + v-part). */
class HeightOfPixel
{
public:
	HeightOfPixel(const DepthFrame& frame, const Plane& ground) : m_intrinsics(frame.image.intrinsics)
	{
		const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
		m_normal_in_camera = robot_from_camera.linear().transpose() * ground.normal;
		m_offset = ground.signedDistance(robot_from_camera.translation());
	}
	[[nodiscard]] double operator()(int u, int v, double depth_m) const
	{
		return m_offset + depth_m * m_normal_in_camera.dot(rayOfPixel(m_intrinsics, u, v));
	}

private:
	CameraIntrinsics m_intrinsics;
	Eigen::Vector3d m_normal_in_camera;
	double m_offset;
};

NearField::Sector sectorOf(const DepthFrame& frame, const std::optional<HeightOfPixel>& height, int u_begin, int u_end)
{
	const int pixel_step = std::max(1, frame.image.intrinsics.width_px / kSampledColumns);
	const DepthImage& image = frame.image;
	std::vector<float> standing;
	std::size_t seen = 0, missing = 0;
	for (int v = 0; v < image.intrinsics.height_px; v += pixel_step)
		for (int u = u_begin; u < u_end; u += pixel_step)
		{
			const float depth_m = image.at(u, v);
			++seen;
			if (depth_m <= 0.0F)
				++missing;
			else if (!height || (*height)(u, v, depth_m) > kFloorClearance_m)
				standing.push_back(depth_m);
		}
	NearField::Sector sector;
	sector.no_return_share = seen == 0 ? 1.0F : static_cast<float>(missing) / static_cast<float>(seen);
	const auto rank = std::max(kMinPixels, static_cast<std::size_t>(kNearestShare * static_cast<double>(seen)));
	if (standing.size() > rank)
	{
		const auto nth = standing.begin() + static_cast<std::ptrdiff_t>(rank);
		std::nth_element(standing.begin(), nth, standing.end());
		sector.nearest_m = *nth;
	}
	return sector;
}
}  // namespace

void describe(FieldVisitor& fields, NearFieldConfig& config)
{
	fields.real("sensor_min_range", config.sensor_min_range_m, {0.0, 5.0}, "m",
	            "The sensor measures nothing nearer than this; an obstacle that slips under it stops the robot.");
}

NearField nearField(const DepthFrame& frame, const std::optional<Plane>& ground)
{
	NearField result;
	if (frame.image.empty())
	{
		result.valid_pixels = frame.points_in_camera.size();
		return result;
	}
	result.organised = true;
	result.valid_pixels = static_cast<std::size_t>(
	    std::ranges::count_if(frame.image.depth_m, [](float depth_m) { return depth_m > 0.0F; }));

	std::optional<HeightOfPixel> height;
	if (ground) height.emplace(frame, *ground);
	const int width = frame.image.intrinsics.width_px;
	for (std::size_t i = 0; i < NearField::kSectors; ++i)
	{
		const int begin = width * static_cast<int>(i) / static_cast<int>(NearField::kSectors);
		const int end = width * static_cast<int>(i + 1) / static_cast<int>(NearField::kSectors);
		result.sectors[i] = sectorOf(frame, height, begin, end);
	}
	return result;
}
}  // namespace explore
