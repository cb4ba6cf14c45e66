#include <explore/simulation/sdf/text_reader.h>
#include <explore/simulation/sdf/xml.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace explore::simulation
{
namespace
{
constexpr std::size_t kDeepest = 200;

bool isNameLetter(char letter)
{
	const auto byte = static_cast<unsigned char>(letter);
	return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
	       letter == '_' || letter == ':' || letter == '-' || letter == '.' || byte >= 0x80;
}

[[noreturn]] void malformed(const TextReader& reader, const std::string& reason)
{
	reader.fail("not well-formed XML: " + reason);
}

std::string nameHere(TextReader& reader)
{
	const std::string_view name = reader.whileIt(isNameLetter);
	const bool begun = !name.empty() && name[0] != '-' && name[0] != '.' && (name[0] < '0' || name[0] > '9');
	if (!begun) malformed(reader, "a name was expected");
	return std::string(name);
}

void appendEntity(const TextReader& reader, std::string& text, std::string_view entity)
{
	static constexpr std::array<std::pair<std::string_view, char>, 5> kNamed{
	    {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
	for (const auto& [name, letter] : kNamed)
		if (entity == name) return text.push_back(letter);
	const bool hexadecimal = entity.starts_with("#x"), decimal = !hexadecimal && entity.starts_with("#");
	const std::string_view digits = entity.substr(std::min<std::size_t>(entity.size(), hexadecimal ? 2 : 1));
	unsigned long code = 0;
	const auto [end, error] = std::from_chars(digits.begin(), digits.end(), code, hexadecimal ? 16 : 10);
	if ((!hexadecimal && !decimal) || error != std::errc() || end != digits.end() || code == 0 || code > 0x10FFFF)
		malformed(reader, std::string("the entity '&").append(entity).append(";' is not known"));
	appendUtf8(text, code);
}

/** Appends `raw` with its entities replaced. */
void appendDecoded(const TextReader& reader, std::string& text, std::string_view raw)
{
	for (std::size_t amp = raw.find('&'); amp != std::string_view::npos; amp = raw.find('&'))
	{
		const std::size_t end = raw.find(';', amp);
		if (end == std::string_view::npos) malformed(reader, "'&' without ';' (write &amp;)");
		text += raw.substr(0, amp);
		appendEntity(reader, text, raw.substr(amp + 1, end - amp - 1));
		raw.remove_prefix(end + 1);
	}
	text += raw;
}

/** Skips comments, processing instructions and the document type; false where something else stands. */
bool skipMisc(TextReader& reader)
{
	if (reader.accept("<!--")) return reader.until("-->"), true;
	if (reader.accept("<?")) return reader.until("?>"), true;
	if (!reader.accept("<!DOCTYPE")) return false;
	reader.before("[>");
	if (reader.accept("[")) reader.until("]");
	return reader.until(">"), true;
}

void skipProlog(TextReader& reader)
{
	reader.skipBlanks();
	while (skipMisc(reader)) reader.skipBlanks();
}

void readAttribute(TextReader& reader, XmlNode& node)
{
	const std::string name = nameHere(reader);
	if (node.hasAttribute(name)) malformed(reader, "the attribute '" + name + "' is there twice");
	reader.skipBlanks();
	reader.expect("=");
	reader.skipBlanks();
	const char quote = reader.next();
	if (quote != '"' && quote != '\'') malformed(reader, "the value of '" + name + "' is not in quotes");
	const std::string_view raw = reader.until(std::string_view(&quote, 1));
	if (raw.find('<') != std::string_view::npos) malformed(reader, "'<' in the value of '" + name + "'");
	appendDecoded(reader, node.attributes.emplace_back(name, std::string()).second, raw);
}

/** Reads an opening tag after its '<'; true when it has content and a closing tag. */
bool readTag(TextReader& reader, XmlNode& node)
{
	node.line = reader.line();
	node.name = nameHere(reader);
	for (;;)
	{
		reader.skipBlanks();
		if (reader.accept("/>")) return false;
		if (reader.accept(">")) return true;
		readAttribute(reader, node);
	}
}

void closeTag(TextReader& reader, XmlNode& node)
{
	const std::string name = nameHere(reader);
	if (name != node.name)
		malformed(reader, "</" + name + "> closes <" + node.name + "> of line " + std::to_string(node.line));
	reader.skipBlanks();
	reader.expect(">");
	node.text = std::string(trimmed(node.text));
}

/** The content of `root` up to its closing tag, all levels of it. */
void readContent(TextReader& reader, XmlNode& root)
{
	std::vector<XmlNode*> open{&root};
	while (!open.empty())
	{
		XmlNode& node = *open.back();
		appendDecoded(reader, node.text, reader.before("<"));
		if (reader.atEnd())
			malformed(reader, "<" + node.name + "> of line " + std::to_string(node.line) + " is not closed");
		if (reader.accept("<![CDATA["))
			node.text += reader.until("]]>");
		else if (reader.accept("</"))
			closeTag(reader, node), open.pop_back();
		else if (!skipMisc(reader))
		{
			reader.expect("<");
			XmlNode& child = node.children.emplace_back();
			if (!readTag(reader, child)) continue;
			if (open.size() >= kDeepest)
				malformed(reader, "elements are nested deeper than " + std::to_string(kDeepest));
			open.push_back(&child);  // stays where it is until its parent gets the next child
		}
	}
}
}  // namespace

const XmlNode* XmlNode::child(std::string_view child_name) const
{
	const auto found =
	    std::find_if(children.begin(), children.end(), [&](const XmlNode& node) { return node.name == child_name; });
	return found == children.end() ? nullptr : &*found;
}

const XmlNode* XmlNode::descendant(std::string_view path) const
{
	const std::size_t slash = path.find('/');
	const XmlNode* first = child(path.substr(0, slash));
	if (first == nullptr || slash == std::string_view::npos) return first;
	return first->descendant(path.substr(slash + 1));
}

std::string XmlNode::textAt(std::string_view path) const
{
	const XmlNode* found = descendant(path);
	return found != nullptr ? found->text : std::string();
}

std::string XmlNode::attribute(std::string_view attribute_name) const
{
	for (const auto& [name_here, value] : attributes)
		if (name_here == attribute_name) return value;
	return {};
}

bool XmlNode::hasAttribute(std::string_view attribute_name) const
{
	return std::any_of(attributes.begin(), attributes.end(),
	                   [&](const auto& attribute) { return attribute.first == attribute_name; });
}

void XmlNode::setAttribute(std::string_view attribute_name, std::string value)
{
	for (auto& [name_here, old] : attributes)
		if (name_here == attribute_name) return void(old = std::move(value));
	attributes.emplace_back(attribute_name, std::move(value));
}

XmlNode parseXml(std::string_view text, const std::string& name)
{
	TextReader reader(text, name);
	reader.accept("\xEF\xBB\xBF");  // byte order mark
	skipProlog(reader);
	if (!reader.accept("<")) malformed(reader, "no element where the first one was expected");
	XmlNode root;
	if (readTag(reader, root)) readContent(reader, root);
	skipProlog(reader);
	if (!reader.atEnd()) malformed(reader, "something follows after </" + root.name + ">");
	return root;
}

std::string escapeXml(std::string_view text)
{
	std::string escaped;
	for (const char letter : text)
	{
		if (letter == '<')
			escaped += "&lt;";
		else if (letter == '&')
			escaped += "&amp;";
		else if (letter == '"')
			escaped += "&quot;";
		else
			escaped += letter;
	}
	return escaped;
}
}  // namespace explore::simulation
