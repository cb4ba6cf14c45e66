// Which of very many frames are kept, so that all together stay below a size.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace explore
{
/** Every frame at first; where the kept ones become too many or too large, every second of them goes, and only every
 *  second one is kept from then on. Depends on the frames it was given alone. */
class Thinning
{
public:
	struct Limits
	{
		std::size_t bytes = 0, count = 0;  ///< at most, together; what is kept first is kept whatever its size
		std::size_t stride = 1;            ///< to begin with, at most every so many frames
	};
	explicit Thinning(const Limits& limits) : m_limits(limits), m_stride(limits.stride) {}

	/** Whether the frame, later than all before, is one of those to keep. */
	[[nodiscard]] bool wants(std::size_t frame) const { return frame % m_stride == 0; }
	/** It has so many bytes. Nothing happens where it is not wanted. */
	void add(std::size_t frame, std::size_t bytes);
	/** Frames with numbers that this divides are the ones that are still kept. */
	[[nodiscard]] std::size_t stride() const { return m_stride; }

private:
	void halve();

	Limits m_limits;
	std::size_t m_stride;
	std::size_t m_bytes = 0;
	std::vector<std::pair<std::size_t, std::size_t>> m_kept;  ///< frame, bytes
};
}  // namespace explore
