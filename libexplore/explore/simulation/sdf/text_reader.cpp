#include <explore/core/errors.h>
#include <explore/simulation/sdf/text_reader.h>

#include <algorithm>

namespace explore::simulation
{
char TextReader::next()
{
	if (atEnd()) fail("the file ends too early");
	const char letter = m_text[m_place];
	pass(1);
	return letter;
}

bool TextReader::accept(std::string_view word)
{
	if (!sees(word)) return false;
	pass(word.size());
	return true;
}

void TextReader::expect(std::string_view word)
{
	if (!accept(word)) fail(std::string("'").append(word).append("' is missing"));
}

void TextReader::skipBlanks()
{
	whileIt(isBlank);
}

std::string_view TextReader::until(std::string_view end)
{
	const std::size_t found = m_text.find(end, m_place);
	if (found == std::string_view::npos) fail(std::string("'").append(end).append("' is missing before the file ends"));
	const std::string_view between = m_text.substr(m_place, found - m_place);
	pass(between.size() + end.size());
	return between;
}

std::string_view TextReader::before(std::string_view letters)
{
	const std::size_t found = std::min(m_text.find_first_of(letters, m_place), m_text.size());
	const std::string_view between = m_text.substr(m_place, found - m_place);
	pass(between.size());
	return between;
}

void TextReader::fail(std::string_view reason) const
{
	throw InputError(std::string(m_name).append(":").append(std::to_string(m_line)).append(": ").append(reason));
}

void TextReader::pass(std::size_t count)
{
	const std::string_view passed = m_text.substr(m_place, count);
	m_line += static_cast<int>(std::count(passed.begin(), passed.end(), '\n'));
	m_place += count;
}

bool isBlank(char letter)
{
	return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

std::string_view trimmed(std::string_view text)
{
	while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
	while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
	return text;
}

void appendUtf8(std::string& text, unsigned long code)
{
	const auto put = [&text](unsigned long byte) { text.push_back(static_cast<char>(byte)); };
	const auto put_rest = [&put, code](unsigned shift) { put(0x80U | (code >> shift & 0x3FU)); };
	if (code < 0x80) return put(code);
	if (code < 0x800) return put(0xC0U | code >> 6U), put_rest(0);
	if (code < 0x10000) return put(0xE0U | code >> 12U), put_rest(6), put_rest(0);
	put(0xF0U | code >> 18U), put_rest(12), put_rest(6), put_rest(0);
}
}  // namespace explore::simulation
