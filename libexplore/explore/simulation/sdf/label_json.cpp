#include <explore/simulation/sdf/label_json.h>
#include <explore/simulation/sdf/text_reader.h>

#include <charconv>
#include <optional>

namespace explore::simulation
{
namespace
{
/** The four digits of \uXXXX. */
unsigned long hexDigits(TextReader& reader)
{
	std::string digits;
	for (int i = 0; i < 4; ++i) digits.push_back(reader.next());
	unsigned long code = 0;
	const char* const last = digits.data() + digits.size();
	const auto [end, error] = std::from_chars(digits.data(), last, code, 16);
	if (error != std::errc() || end != last || (code >= 0xD800 && code < 0xE000) || code == 0)
		reader.fail("\\u" + digits + " in a string: a character below U+D800 or above U+DFFF is needed");
	return code;
}

std::string stringHere(TextReader& reader)
{
	std::string text;
	for (reader.expect("\"");;)
	{
		text += reader.before("\"\\\n");
		const char letter = reader.next();
		if (letter == '"') return text;
		if (letter == '\n') reader.fail("a string ends on the line it starts on");
		const char escaped = reader.next();
		if (escaped == 'u')
			appendUtf8(text, hexDigits(reader));
		else if (escaped == 'n' || escaped == 't' || escaped == 'r')
			text.push_back(' ');
		else if (escaped == '"' || escaped == '\\' || escaped == '/')
			text.push_back(escaped);
		else
			reader.fail(R"(an escape in a string is one of \" \\ \/ \n \t \r \uXXXX)");
	}
}

/** Calls `item` for each of the values between `open` and `close`. */
template <class Item>
void list(TextReader& reader, std::string_view open, std::string_view close, const Item& item)
{
	reader.skipBlanks();
	reader.expect(open);
	reader.skipBlanks();
	if (reader.accept(close)) return;
	do
	{
		reader.skipBlanks();
		item();
		reader.skipBlanks();
	} while (reader.accept(","));
	reader.expect(close);
}

/** A string, number, true, false or (no value) null. */
std::optional<std::string> scalarHere(TextReader& reader)
{
	if (reader.sees("\"")) return stringHere(reader);
	const auto belongs = [](char letter)
	{
		return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') || letter == '-' || letter == '+' ||
		       letter == '.' || letter == 'E';
	};
	const std::string word(reader.whileIt(belongs));
	if (word == "null") return std::nullopt;
	if (word.empty()) reader.fail("a value was expected");
	return word;
}

/** A scalar, or a list of them joined by blanks, or a list of lists joined by ";". */
std::optional<std::string> valueHere(TextReader& reader, int depth = 0)
{
	if (!reader.sees("[")) return scalarHere(reader);
	if (depth == 2) reader.fail("lists are nested at most twice here");
	std::string joined;
	const auto item = [&]
	{
		const std::string between = reader.sees("[") ? "; " : " ";
		const std::optional<std::string> value = valueHere(reader, depth + 1);
		if (!joined.empty()) joined += between;
		joined += value.value_or("null");
	};
	list(reader, "[", "]", item);
	return joined;
}

/** {"id": "a", "at": [1, 2, 0]} */
XmlNode elementHere(TextReader& reader, const std::string& kind)
{
	XmlNode element;
	element.name = kind;
	element.line = reader.line();
	const auto member = [&]
	{
		const std::string key = stringHere(reader);
		if (element.hasAttribute(key)) reader.fail("\"" + key + "\" is there twice");
		reader.skipBlanks();
		reader.expect(":");
		reader.skipBlanks();
		if (std::optional<std::string> value = valueHere(reader)) element.setAttribute(key, std::move(*value));
	};
	list(reader, "{", "}", member);
	return element;
}
}  // namespace

XmlNode parseLabelJson(std::string_view text, const std::string& name)
{
	TextReader reader(text, name);
	XmlNode labels;
	const auto kinds = [&]
	{
		std::string kind = stringHere(reader);
		if (kind.ends_with('s')) kind.pop_back();  // "doors" holds doors
		reader.skipBlanks();
		reader.expect(":");
		list(reader, "[", "]", [&] { labels.children.push_back(elementHere(reader, kind)); });
	};
	list(reader, "{", "}", kinds);
	reader.skipBlanks();
	if (!reader.atEnd()) reader.fail("something follows after the last }");
	return labels;
}
}  // namespace explore::simulation
