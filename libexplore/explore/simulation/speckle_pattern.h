// The dots that a structured-light projector throws: fixed at the factory, repeated over the image.
#pragma once

#include <cstdint>
#include <vector>

namespace explore::simulation
{
/** A tile of bright dots at random places on a dark ground, periodic both ways. Columns and rows are those of a camera
 *  beside the projector with the same focal length that looks at something infinitely far away. */
class SpecklePattern
{
public:
	static constexpr int kColumns_px = 512, kRows_px = 128;

	SpecklePattern();

	/** Brightness, about 0–1, at any column and row, linear between samples a quarter of a pixel apart. */
	[[nodiscard]] float brightness(float column_px, int row_px) const;

private:
	void addDot(float column_px, float row_px, float peak);

	std::vector<float> m_samples;
};

/** The pattern of all projectors. */
const SpecklePattern& specklePattern();
}  // namespace explore::simulation
