// The image that the virtual camera sees now, as another program leaves it for its driver.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

namespace explore::test
{
struct LiveFrame
{
	std::uint64_t number = 0, time_us = 0;  ///< by the camera's clock
	std::vector<std::uint16_t> counts;      ///< row-major
};

/** Readers see the frame before or this one, whole. */
inline void writeLiveFrame(const std::filesystem::path& path, const LiveFrame& frame)
{
	const std::filesystem::path fresh = path.string() + ".new";
	std::ofstream file(fresh, std::ios::binary);
	file.write(reinterpret_cast<const char*>(&frame.number), sizeof(frame.number));    // NOLINT: bytes
	file.write(reinterpret_cast<const char*>(&frame.time_us), sizeof(frame.time_us));  // NOLINT: bytes
	file.write(reinterpret_cast<const char*>(frame.counts.data()),                     // NOLINT: bytes
	           static_cast<std::streamsize>(frame.counts.size() * sizeof(std::uint16_t)));
	file.close();
	std::filesystem::rename(fresh, path);
}

/** No value where there is none but `last`. */
inline std::optional<LiveFrame> readLiveFrame(const std::filesystem::path& path, std::uint64_t last, std::size_t pixels)
{
	LiveFrame frame;
	std::ifstream file(path, std::ios::binary);
	file.read(reinterpret_cast<char*>(&frame.number), sizeof(frame.number));    // NOLINT: bytes
	file.read(reinterpret_cast<char*>(&frame.time_us), sizeof(frame.time_us));  // NOLINT: bytes
	if (!file || frame.number == last) return std::nullopt;
	frame.counts.resize(pixels);
	file.read(reinterpret_cast<char*>(frame.counts.data()),  // NOLINT: bytes
	          static_cast<std::streamsize>(pixels * sizeof(std::uint16_t)));
	return file ? std::optional(std::move(frame)) : std::nullopt;
}
}  // namespace explore::test
