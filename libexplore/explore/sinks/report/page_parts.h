// The page's own files – page.css, page.html and the scripts beside this header – as texts; CMake makes them.
#pragma once

#include <array>
#include <string_view>

namespace explore::page_parts
{
extern const std::string_view kStyle, kBody;
/** In the order in which they run, all in one function. */
extern const std::array<std::string_view, 6> kScripts;
}  // namespace explore::page_parts
