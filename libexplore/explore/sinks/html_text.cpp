#include <explore/sinks/html_text.h>

#include <cstdint>
#include <stdexcept>

namespace explore
{
namespace
{
constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::string replaced(std::string_view text, char wanted, std::string_view by)
{
	std::string result;
	result.reserve(text.size());
	for (const char c : text)
		if (c == wanted)
			result += by;
		else
			result += c;
	return result;
}
}  // namespace

std::string escapedHtml(std::string_view text)
{
	return replaced(replaced(replaced(replaced(text, '&', "&amp;"), '<', "&lt;"), '>', "&gt;"), '"', "&quot;");
}

std::string jsonInScript(std::string json)
{
	if (json.find('<') == std::string::npos) return json;
	return replaced(json, '<', "\\u003c");
}

std::string base64(std::string_view bytes)
{
	std::string text;
	text.reserve((bytes.size() + 2) / 3 * 4);
	for (std::size_t i = 0; i < bytes.size(); i += 3)
	{
		std::uint32_t group = 0;
		for (std::size_t j = 0; j < 3; ++j)
			group = (group << 8U) | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
		for (std::size_t j = 0; j < 4; ++j)
			text += i + j <= bytes.size() ? kDigits[(group >> (18U - 6U * j)) & 63U] : '=';
	}
	return text;
}

std::string bytesOfBase64(std::string_view text)
{
	if (text.size() % 4 != 0) throw std::invalid_argument("base64 comes in groups of four");
	while (text.ends_with('=')) text.remove_suffix(1);
	std::string bytes;
	std::uint32_t group = 0;
	unsigned bits = 0;
	for (const char c : text)
	{
		const std::size_t digit = kDigits.find(c);
		if (digit == std::string_view::npos) throw std::invalid_argument("base64 has no such digit");
		group = (group << 6U) | static_cast<std::uint32_t>(digit);
		bits += 6;
		if (bits < 8) continue;
		bits -= 8;
		bytes += static_cast<char>((group >> bits) & 255U);
	}
	return bytes;
}
}  // namespace explore
