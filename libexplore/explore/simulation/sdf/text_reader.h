// Walks through a text character by character and knows its line: the base of the XML and JSON readers.
#pragma once

#include <string>
#include <string_view>

namespace explore::simulation
{
/** `text` and `name` (of the file) outlive it. Whatever does not fit throws InputError "name:line: reason". */
class TextReader
{
public:
	TextReader(std::string_view text, std::string_view name) : m_text(text), m_name(name) {}

	[[nodiscard]] bool atEnd() const { return m_place == m_text.size(); }
	[[nodiscard]] int line() const { return m_line; }
	[[nodiscard]] bool sees(std::string_view word) const { return m_text.substr(m_place).starts_with(word); }
	/** The next character, which is passed. */
	char next();
	/** Passes `word` if it stands here. */
	bool accept(std::string_view word);
	void expect(std::string_view word);
	void skipBlanks();
	/** Everything before the next `end`, which is passed too. */
	std::string_view until(std::string_view end);
	/** Everything before the next of `letters`, or before the end. */
	std::string_view before(std::string_view letters);
	/** As many characters as `belongs` accepts. */
	template <class Predicate>
	std::string_view whileIt(const Predicate& belongs)
	{
		std::size_t count = 0;
		while (m_place + count < m_text.size() && belongs(m_text[m_place + count])) ++count;
		const std::string_view word = m_text.substr(m_place, count);
		pass(count);
		return word;
	}
	[[noreturn]] void fail(std::string_view reason) const;

private:
	void pass(std::size_t count);

	std::string_view m_text, m_name;
	std::size_t m_place = 0;
	int m_line = 1;
};

/** Space, tab and line ends. */
bool isBlank(char letter);
/** `text` without the blanks around it. */
std::string_view trimmed(std::string_view text);
/** Appends the character with that Unicode number. */
void appendUtf8(std::string& text, unsigned long code);
}  // namespace explore::simulation
