#include <explore/simulation/pane_optics.h>
#include <explore/simulation/sight.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace explore::simulation
{
namespace
{
constexpr int kMostBounces = 8;
constexpr double kStepOff_m = 1e-4;        ///< past a pane or mirror, so that it is not hit again
constexpr double kPaneThickness_m = 0.05;  ///< two faces nearer than this are one pane
constexpr float kPaneItself = 0.1F;        ///< share of the pixels that see the pane: dirt and reflexes
constexpr float kPaneBlob_px = 4.0F;
constexpr float kPaneTint = 0.2F, kMirrorTint = 0.1F;
}  // namespace

Eigen::Vector3f backgroundColor()
{
	return {0.45F, 0.55F, 0.65F};
}

Eigen::Vector3f shaded(const Material& material, const Eigen::Vector3f& normal)
{
	static const Eigen::Vector3f kLight = Eigen::Vector3f(0.45F, 0.25F, 0.85F).normalized();
	return material.color * (0.3F + 0.7F * std::abs(normal.dot(kLight)));
}

SightFollower::SightFollower(const RayScene& scene, double reach_m, double glass_dropout, std::uint64_t seed)
    : m_scene(scene),
      m_reach_m(reach_m),
      m_glass_dropout(glass_dropout),
      m_dropout_key(noiseKey(seed, 1)),
      m_itself_key(noiseKey(seed, 2))
{
}

void SightFollower::seeSurface(Sight& sight, const RayHit& hit, const Eigen::Vector3d& direction) const
{
	const Material& material = m_scene.world().materials[hit.material];
	const Eigen::Vector3f along = direction.cast<float>();
	sight.cosine = std::clamp(-hit.normal.dot(along) / along.norm(), 0.0F, 1.0F);
	sight.reflectance = material.color.mean();
	sight.lost = material.surface == Surface::black;
	sight.color = shaded(material, hit.normal);
}

Sight SightFollower::follow(const RayHit& first, const Eigen::Vector3d& first_origin,
                            const Eigen::Vector3d& first_direction, int u_px, int v_px) const
{
	Sight sight;
	Eigen::Vector3d origin = first_origin, direction = first_direction;
	const double length = direction.norm(), step_off = kStepOff_m / length;
	double past = 0.0, last_pane = -m_reach_m, survival = 1.0;
	float tint = 0.0F;
	std::optional<RayHit> hit = first;
	for (int bounce = 0; hit && bounce < kMostBounces; ++bounce)
	{
		seeSurface(sight, *hit, direction);
		sight.distance = past + hit->distance;
		const Surface surface = m_scene.world().materials[hit->material].surface;
		if (surface != Surface::glass && surface != Surface::mirror) break;
		origin += hit->distance * direction;
		if (surface == Surface::mirror)
		{
			const Eigen::Vector3d normal = hit->normal.cast<double>().normalized();
			direction -= 2.0 * direction.dot(normal) * normal;
			sight.mirrored = true;
			tint += kMirrorTint;
		}
		else if ((sight.distance - last_pane) * length > kPaneThickness_m)
		{
			survival *= (1.0 - m_glass_dropout) * paneTransmission(static_cast<double>(sight.cosine));
			tint += kPaneTint;
			if (noiseOfBlob(m_itself_key, u_px, v_px, kPaneBlob_px) < kPaneItself) break;
			last_pane = sight.distance;
		}
		origin += step_off * direction;
		past = sight.distance + step_off;
		sight.distance = 0.0;  // until the ray ends somewhere
		hit = m_scene.cast(origin, direction, m_reach_m - past);
	}
	if (survival < 1.0 && noiseOfBlob(m_dropout_key, u_px, v_px, kPaneBlob_px) >= static_cast<float>(survival))
		sight.lost = true;
	if (sight.distance == 0.0) sight.color = backgroundColor();
	sight.color += std::min(tint, 1.0F) * (Eigen::Vector3f::Constant(0.8F) - sight.color);
	return sight;
}
}  // namespace explore::simulation
