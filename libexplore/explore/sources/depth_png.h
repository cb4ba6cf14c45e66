// 16-bit greyscale PNG files as raw depth counts.
#pragma once

#include <mrpt/math/CMatrixDynamic.h>

#include <cstdint>
#include <filesystem>

namespace explore
{
/** height × width counts, 0 = no return. Throws InputError for a file that is missing, damaged, or not one channel of
 * 16 bits. */
mrpt::math::CMatrix_u16 readDepthPng(const std::filesystem::path& path);
}  // namespace explore
