#include <explore/perception/far_jamb.h>

#include <algorithm>
#include <cmath>

namespace explore
{
double medianOf(std::vector<float>& values)
{
	if (values.empty()) return 0.0;
	const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
	std::ranges::nth_element(values, middle);
	return *middle;
}

OpeningFrame withFarJambFromFace(const RayJudge& judge, const OpeningFrame& frame, const BodyBand& body)
{
	const bool right_is_far = frame.left.along_m > 0.0, left_is_far = frame.right.along_m < 0.0;
	if (!right_is_far && !left_is_far) return frame;
	const PixelBox box = judge.rays().boxOf({frame.left.along_m, frame.right.along_m, body.bottom_m, body.top_m});
	const int step = std::max(1, box.pixels() / 3000);
	std::vector<float> along_m;
	along_m.reserve(4096);
	int all = 0;
	for (int v = box.first_v; v <= box.last_v; v += step)
		for (int u = box.first_u; u <= box.last_u; ++u)
		{
			const WallCrossing crossing = judge.rays().at(u, v);
			const double inset_m =
			    std::min(crossing.along_m - frame.left.along_m, frame.right.along_m - crossing.along_m);
			if (!(crossing.depth_m > 0.0F) || inset_m < 0.0 || crossing.height_m < body.bottom_m ||
			    crossing.height_m > body.top_m)
				continue;
			++all;
			const RayMet met = judge.met(u, v, crossing);
			if (met == RayMet::shallow || met == RayMet::wall)
				along_m.push_back(judge.rays().alongAt(u, v, judge.depth(u, v)));
		}
	if (along_m.size() < 40 || static_cast<int>(along_m.size()) * 5 < all) return frame;
	const double face_m = medianOf(along_m);
	for (float& value : along_m) value = std::abs(value - static_cast<float>(face_m));
	const double spread_m = medianOf(along_m);
	const double range_m = std::hypot(face_m, 1.0);
	if (spread_m > 0.03 + 0.5 * judge.noiseOf(static_cast<float>(range_m))) return frame;
	// As far from the jamb as it seems as the tolerance of the wall's surface reaches along these rays, not more.
	const double further_m = face_m - (right_is_far ? frame.right : frame.left).along_m;
	const double outward_m = right_is_far ? further_m : -further_m;
	const double rays_per_m = std::abs(face_m) / judge.distance_m();
	const double tolerance_m = 0.03 + judge.noiseOf(static_cast<float>(range_m)) / std::max(1.0, rays_per_m);
	if (outward_m < 0.0 || outward_m > 1.5 * tolerance_m * rays_per_m) return frame;
	OpeningFrame fitted = frame;
	(right_is_far ? fitted.right : fitted.left).along_m = face_m;
	return fitted;
}
}  // namespace explore
