// Follows a camera's line of sight through panes of glass and off mirrors.
#pragma once

#include <explore/simulation/depth_camera.h>
#include <explore/simulation/noise_random.h>

namespace explore::simulation
{
/** What one pixel sees at last. */
struct Sight
{
	double distance = 0;  ///< all the way, in multiples of the first direction; 0 = nothing
	float cosine = 0;     ///< of the incidence there
	float reflectance = 0;
	bool lost = false;      ///< black, or swallowed by a pane
	bool mirrored = false;  ///< seen in a mirror
	Eigen::Vector3f color = Eigen::Vector3f::Zero();
};

/** Colour where there is nothing to see. */
Eigen::Vector3f backgroundColor();

/** Colour of a surface in the light of the room. */
Eigen::Vector3f shaded(const Material& material, const Eigen::Vector3f& normal);

class SightFollower
{
public:
	/** Which pixels a pane swallows depends on `seed`. */
	SightFollower(const RayScene& scene, double reach_m, double glass_dropout, std::uint64_t seed);

	/** Goes on from the `first` hit of the ray of pixel (u, v) from `origin` along `direction`. */
	[[nodiscard]] Sight follow(const RayHit& first, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
	                           int u_px, int v_px) const;

private:
	void seeSurface(Sight& sight, const RayHit& hit, const Eigen::Vector3d& direction) const;

	const RayScene& m_scene;
	double m_reach_m, m_glass_dropout;
	NoiseKey m_dropout_key, m_itself_key;
};
}  // namespace explore::simulation
