// Text and bytes as they may stand in a page of HTML.
#pragma once

#include <string>
#include <string_view>

namespace explore
{
/** With & < > and " as entities: for text and for attributes in double quotes. */
std::string escapedHtml(std::string_view text);

/** JSON that may stand inside `<script>`: every `<` as `\u003c`, which JSON takes for the same, so that no text in it
 * can end the element. */
std::string jsonInScript(std::string json);

/** RFC 4648, with padding. */
std::string base64(std::string_view bytes);
/** What base64() was given. Throws std::invalid_argument for anything else. */
std::string bytesOfBase64(std::string_view text);
}  // namespace explore
