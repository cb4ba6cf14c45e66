#include <explore/core/geometry.h>
#include <explore/perception/near_field.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace explore
{
namespace
{
constexpr std::size_t kSampledColumns = 80;  // of the image: strips are far coarser than that
constexpr float kFloorClearance_m = 0.1F;
constexpr double kNearestShare = 0.01;  // of a strip's pixels: fewer are noise
constexpr std::size_t kMinPixels = 4;
constexpr float kNothingReturns = 0.98F;  // share of a strip's pixels: a stray return is noise
constexpr double kJustWithin_m = 0.05;

/** Height above the ground per metre of depth: the sum of a part of the row and a part of the column. */
struct HeightPerDepth
{
	float offset = 0;
	std::vector<float> of_row, of_column;

	/** Without a ground everything counts as standing. */
	HeightPerDepth(const DepthFrame& frame, const std::optional<Plane>& ground)
	    : offset(ground ? 0.0F : std::numeric_limits<float>::infinity()),
	      of_row(static_cast<std::size_t>(frame.image.intrinsics.height_px)),
	      of_column(static_cast<std::size_t>(frame.image.intrinsics.width_px))
	{
		if (!ground) return;
		const CameraIntrinsics& camera = frame.image.intrinsics;
		const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
		const Eigen::Vector3d up_in_camera = robot_from_camera.linear().transpose() * ground->normal;
		offset = static_cast<float>(ground->signedDistance(robot_from_camera.translation()));
		const double on_axis = up_in_camera.dot(rayOfPixel(camera, camera.cx_px, camera.cy_px));
		for (int v = 0; v < camera.height_px; ++v)
			of_row[static_cast<std::size_t>(v)] =
			    static_cast<float>(up_in_camera.dot(rayOfPixel(camera, camera.cx_px, v)));
		for (int u = 0; u < camera.width_px; ++u)
			of_column[static_cast<std::size_t>(u)] =
			    static_cast<float>(up_in_camera.dot(rayOfPixel(camera, u, camera.cy_px)) - on_axis);
	}
};

/** The samples of one strip. */
struct Strip
{
	std::vector<float> standing_depth_m;
	std::size_t seen = 0, missing = 0;

	void add(float depth_m, float height_m)
	{
		++seen;
		if (depth_m <= 0.0F)
			++missing;
		else if (height_m > kFloorClearance_m)
			standing_depth_m.push_back(depth_m);
	}
	[[nodiscard]] NearField::Sector sector()
	{
		NearField::Sector sector;
		sector.no_return_share = seen == 0 ? 1.0F : static_cast<float>(missing) / static_cast<float>(seen);
		const auto rank = std::max(kMinPixels, static_cast<std::size_t>(kNearestShare * static_cast<double>(seen)));
		if (standing_depth_m.size() <= rank) return sector;
		const auto nth = standing_depth_m.begin() + static_cast<std::ptrdiff_t>(rank);
		std::ranges::nth_element(standing_depth_m, nth);
		sector.nearest_m = *nth;
		return sector;
	}
};

std::size_t countValid(const std::vector<float>& depth_m)
{
	int valid = 0;
	for (const float depth : depth_m) valid += static_cast<int>(depth > 0.0F);
	return static_cast<std::size_t>(valid);
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
	result.valid_pixels = countValid(frame.image.depth_m);

	const HeightPerDepth height(frame, ground);
	const std::size_t width = height.of_column.size();
	const std::size_t step = std::max(std::size_t{1}, width / kSampledColumns);
	std::array<Strip, NearField::kSectors> strips;
	for (std::size_t v = 0; v < height.of_row.size(); v += step)
		for (std::size_t u = 0; u < width; u += step)
		{
			const float depth_m = frame.image.depth_m[v * width + u];
			const float height_m = height.offset + depth_m * (height.of_row[v] + height.of_column[u]);
			strips[u * NearField::kSectors / width].add(depth_m, height_m);
		}
	std::ranges::transform(strips, result.sectors.begin(), &Strip::sector);
	return result;
}

PointCloud hiddenNear(const DepthFrame& frame, const NearField& now, const NearFieldConfig& config)
{
	PointCloud points;
	const auto is_blind = [](const NearField::Sector& sector) { return sector.no_return_share >= kNothingReturns; };
	const auto blind = static_cast<std::size_t>(std::ranges::count_if(now.sectors, is_blind));
	if (!now.organised || 2 * blind > NearField::kSectors) return points;
	const CameraIntrinsics& camera = frame.image.intrinsics;
	const Eigen::Isometry3d robot_from_camera = isometryOf(frame.robot_from_camera);
	const double depth_m = std::max(0.0, config.sensor_min_range_m - kJustWithin_m);
	const double strip_px = static_cast<double>(camera.width_px) / NearField::kSectors;
	for (std::size_t i = 0; i < NearField::kSectors; ++i)
		for (const double part : {0.0, 0.5, 1.0})
		{
			const double u_px = (static_cast<double>(i) + part) * strip_px;
			if (is_blind(now.sectors[i]))
				points.push_back(
				    (robot_from_camera * (depth_m * rayOfPixel(camera, u_px, camera.cy_px))).cast<float>());
		}
	return points;
}
}  // namespace explore
