// Points as three coordinate arrays, so that the loops over them vectorise.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace explore
{
/** N points [m]; x, y and z have the same length N. The variable that holds a cloud names its frame. */
struct PointCloud
{
	std::vector<float> x, y, z;

	[[nodiscard]] std::size_t size() const { return x.size(); }
	[[nodiscard]] bool empty() const { return x.empty(); }
	[[nodiscard]] Eigen::Vector3f operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }

	void push_back(const Eigen::Vector3f& point)
	{
		x.push_back(point.x());
		y.push_back(point.y());
		z.push_back(point.z());
	}
	void reserve(std::size_t n)
	{
		x.reserve(n);
		y.reserve(n);
		z.reserve(n);
	}
	void resize(std::size_t n)
	{
		x.resize(n);
		y.resize(n);
		z.resize(n);
	}
};

/** Some points on their way from one stage to the next, owned by whoever hands them over. */
struct PointBlock
{
	const float *x, *y, *z;
	std::size_t count;
};

/** All points of a cloud, which must outlive the block. */
inline PointBlock blockOf(const PointCloud& points)
{
	return {points.x.data(), points.y.data(), points.z.data(), points.size()};
}
}  // namespace explore
