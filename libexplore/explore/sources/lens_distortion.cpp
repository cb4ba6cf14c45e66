#include "lens_distortion.h"

#include <algorithm>
#include <cmath>

namespace explore
{
namespace
{
using mrpt::img::DistortionModel;
using mrpt::img::TCamera;

Eigen::Vector2d plumbBob(const std::array<double, 8>& k, const Eigen::Vector2d& p)
{
	const double x = p.x(), y = p.y(), r2 = p.squaredNorm();
	const double radial = (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
	return {x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x),
	        y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y};
}

Eigen::Vector2d kannalaBrandt(const std::array<double, 8>& k, const Eigen::Vector2d& p)
{
	const double r = p.norm(), theta = std::atan(r), t2 = theta * theta;
	if (r < 1e-12) return p;
	return p * (theta * (1 + t2 * (k[0] + t2 * (k[1] + t2 * (k[4] + t2 * k[5])))) / r);
}
}  // namespace

Eigen::Vector2d distortPixel(const TCamera& camera, double u_px, double v_px)
{
	const Eigen::Vector2d ideal((u_px - camera.cx()) / camera.fx(), (v_px - camera.cy()) / camera.fy());
	Eigen::Vector2d seen = ideal;
	if (camera.distortion == DistortionModel::plumb_bob) seen = plumbBob(camera.dist, ideal);
	if (camera.distortion == DistortionModel::kannala_brandt) seen = kannalaBrandt(camera.dist, ideal);
	return {camera.cx() + camera.fx() * seen.x(), camera.cy() + camera.fy() * seen.y()};
}

bool hasDistortion(const TCamera& camera)
{
	if (camera.distortion == DistortionModel::none) return false;
	// A fisheye bends even with all coefficients 0.
	return camera.distortion == DistortionModel::kannala_brandt ||
	       std::any_of(camera.dist.begin(), camera.dist.end(), [](double k) { return k != 0.0; });
}

void Undistorter::prepare(const TCamera& camera)
{
	if (m_camera && *m_camera == camera) return;
	m_camera = camera;
	const int width = static_cast<int>(camera.ncols), height = static_cast<int>(camera.nrows);
	m_source.clear();
	m_source.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
	for (int v = 0; v < height; ++v)
		for (int u = 0; u < width; ++u)
		{
			const Eigen::Vector2d from = distortPixel(camera, u, v);
			const bool inside = from.x() > -0.5 && from.x() < width - 0.5 && from.y() > -0.5 && from.y() < height - 0.5;
			m_source.push_back(inside ? static_cast<int>(std::lround(from.y())) * width +
			                                static_cast<int>(std::lround(from.x()))
			                          : -1);
		}
}

void Undistorter::apply(const TCamera& camera, std::vector<float>& values)
{
	prepare(camera);
	std::vector<float> straight(values.size());
	for (std::size_t i = 0; i < straight.size(); ++i)
		straight[i] = m_source[i] < 0 ? 0.0F : values[static_cast<std::size_t>(m_source[i])];
	values.swap(straight);
}
}  // namespace explore
