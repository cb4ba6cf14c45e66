// The attributes of one label, checked: what is missing, unknown or out of bounds is refused with its place.
#pragma once

#include <explore/simulation/sdf/xml.h>

#include <Eigen/Core>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace explore::simulation
{
/** Every function throws InputError "file:line: <element> attribute: …". */
class LabelAttributes
{
public:
	struct Bounds
	{
		double least = 0, most = 0;
	};
	/** Both arguments outlive it. */
	LabelAttributes(const XmlNode& element, const std::string& file) : m_element(element), m_file(file) {}

	[[nodiscard]] const std::string& file() const { return m_file; }
	[[nodiscard]] bool has(const std::string& name) const { return m_element.hasAttribute(name); }
	/** Not empty. */
	std::string text(const std::string& name);
	std::string text(const std::string& name, const std::string& otherwise);
	double number(const std::string& name, Bounds bounds, std::optional<double> otherwise = std::nullopt);
	bool flag(const std::string& name, bool otherwise);
	/** "x y" (z = 0) or "x y z", metres, at most 1000 from the origin. */
	Eigen::Vector3d point(const std::string& name);
	/** point() after point(), ';' between them. */
	std::vector<Eigen::Vector3d> points(const std::string& name);

	/** Refuses attributes that nobody asked for. */
	void finish() const;
	[[noreturn]] void refuse(const std::string& name, const std::string& needed) const;
	[[noreturn]] void refuseElement(const std::string& reason) const;

private:
	Eigen::Vector3d pointIn(const std::string& name, std::string_view text) const;

	const XmlNode& m_element;
	const std::string& m_file;
	std::set<std::string> m_asked;
};
}  // namespace explore::simulation
