#include <explore/simulation/pane_optics.h>

#include <algorithm>
#include <cmath>

namespace explore::simulation
{
namespace
{
/** Through both faces and all reflexes between them, for one polarisation with the amplitude (a − b)/(a + b). */
double throughBothFaces(double a, double b)
{
	const double amplitude = (a - b) / (a + b), reflected = amplitude * amplitude;
	return (1.0 - reflected) / (1.0 + reflected);
}

double throughPane(double cosine)
{
	constexpr double kIndex = 1.52;
	const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (kIndex * kIndex));
	return 0.5 * (throughBothFaces(cosine, kIndex * inside) + throughBothFaces(inside, kIndex * cosine));
}
}  // namespace

double paneTransmission(double cosine)
{
	const double once = throughPane(std::clamp(cosine, 0.0, 1.0)) / throughPane(1.0);
	return std::min(1.0, once * once);
}
}  // namespace explore::simulation
