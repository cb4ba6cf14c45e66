#include <explore/perception/sample_grid.h>

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
constexpr double kSamples = 19200.0;
constexpr int kReach = 2;  // grid steps to the neighbours that make a normal

std::size_t count(int rows, int columns)
{
	return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns);
}

void fillRays(SampleGrid& grid, const CameraIntrinsics& camera)
{
	grid.ray_y.reserve(static_cast<std::size_t>(grid.columns));
	grid.ray_z.reserve(static_cast<std::size_t>(grid.rows));
	for (int column = 0; column < grid.columns; ++column)
		grid.ray_y.push_back(static_cast<float>(rayOfPixel(camera, grid.pixel(column), 0).y()));
	for (int row = 0; row < grid.rows; ++row)
		grid.ray_z.push_back(static_cast<float>(rayOfPixel(camera, 0, grid.pixel(row)).z()));
}

void fillDepths(SampleGrid& grid, const DepthImage& image)
{
	grid.depth_m.resize(count(grid.rows, grid.columns));
	auto* out = grid.depth_m.data();
	for (int row = 0; row < grid.rows; ++row)
	{
		const float* in = &image.depth_m[count(grid.pixel(row), image.intrinsics.width_px)];
		for (int column = 0; column < grid.columns; ++column) *out++ = in[grid.pixel(column)];
	}
}

/** What one row of normals is made of: the samples beside, above and below, and their rays. */
struct RowInput
{
	const float *here, *up, *down, *ray_y;
	float ray_z_here, ray_z_up, ray_z_down;
};

/** Cross product of the differences up − down and left − right; branch-free, so that it vectorises. */
void fillNormalRow(const RowInput& in, int columns, float* x, float* y, float* z)
{
	for (int c = kReach; c < columns - kReach; ++c)
	{
		const float up = in.up[c], down = in.down[c], left = in.here[c - kReach], right = in.here[c + kReach];
		const float ax = up - down, ay = ax * in.ray_y[c], az = up * in.ray_z_up - down * in.ray_z_down;
		const float bx = left - right, by = left * in.ray_y[c - kReach] - right * in.ray_y[c + kReach];
		const float bz = bx * in.ray_z_here;
		const float nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
		const float nearest = std::min(std::min(up, down), std::min(std::min(left, right), in.here[c]));
		const float length = std::sqrt(nx * nx + ny * ny + nz * nz);
		const float scale = nearest > 0.0F ? 1.0F / (length + 1e-12F) : 0.0F;
		x[c] = nx * scale;
		y[c] = ny * scale;
		z[c] = nz * scale;
	}
}

void fillNormals(SampleGrid& grid)
{
	for (auto* normal : {&grid.normal_x, &grid.normal_y, &grid.normal_z}) normal->assign(grid.size(), 0.0F);
	const auto columns = static_cast<std::size_t>(grid.columns);
	for (int row = kReach; row < grid.rows - kReach; ++row)
	{
		const auto r = static_cast<std::size_t>(row);
		const std::size_t start = r * columns;
		const float* here = grid.depth_m.data() + start;
		const RowInput input{here,          here - kReach * columns, here + kReach * columns, grid.ray_y.data(),
		                     grid.ray_z[r], grid.ray_z[r - kReach],  grid.ray_z[r + kReach]};
		fillNormalRow(input, grid.columns, grid.normal_x.data() + start, grid.normal_y.data() + start,
		              grid.normal_z.data() + start);
	}
}
}  // namespace

int sampleStride(const CameraIntrinsics& intrinsics)
{
	const double pixels = static_cast<double>(intrinsics.width_px) * static_cast<double>(intrinsics.height_px);
	return std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / kSamples))));
}

SampleGrid sampleGrid(const DepthImage& image)
{
	SampleGrid grid;
	const CameraIntrinsics& camera = image.intrinsics;
	if (image.empty() || camera.width_px <= 0 || camera.height_px <= 0) return grid;
	if (image.depth_m.size() != count(camera.height_px, camera.width_px)) return grid;
	grid.stride = sampleStride(camera);
	const int first = grid.pixel(0);
	grid.columns = (camera.width_px - first + grid.stride - 1) / grid.stride;
	grid.rows = (camera.height_px - first + grid.stride - 1) / grid.stride;
	fillRays(grid, camera);
	fillDepths(grid, image);
	fillNormals(grid);
	return grid;
}
}  // namespace explore
