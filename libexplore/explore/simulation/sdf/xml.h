// A small XML reader that knows its lines: SDF files are checked, thinned and named in messages by it.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace explore::simulation
{
/** An element. */
struct XmlNode
{
	std::string name;
	std::vector<std::pair<std::string, std::string>> attributes;  ///< in the file's order, entities replaced
	std::string text;                                             ///< all character data, without the blanks around it
	std::vector<XmlNode> children;
	int line = 0;  ///< of the opening tag, from 1

	/** The first child of that name; null when there is none. */
	[[nodiscard]] const XmlNode* child(std::string_view child_name) const;
	/** child(), but through a path such as "material/script/name". */
	[[nodiscard]] const XmlNode* descendant(std::string_view path) const;
	/** The text of descendant(path); empty where there is none. */
	[[nodiscard]] std::string textAt(std::string_view path) const;
	/** The attribute's value; empty when it is not there. */
	[[nodiscard]] std::string attribute(std::string_view attribute_name) const;
	[[nodiscard]] bool hasAttribute(std::string_view attribute_name) const;
	void setAttribute(std::string_view attribute_name, std::string value);
};

/** The root element of an XML document (UTF-8, no external entities). Throws InputError "`name`:line: reason" for
 *  anything that is not well-formed, or nested deeper than 200. */
XmlNode parseXml(std::string_view text, const std::string& name);

/** `text` as character data or attribute value. */
std::string escapeXml(std::string_view text);
}  // namespace explore::simulation
