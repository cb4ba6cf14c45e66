#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/simulation/sdf/label_attributes.h>
#include <explore/simulation/sdf/sdf_values.h>
#include <explore/simulation/sdf/text_reader.h>

namespace explore::simulation
{
std::string LabelAttributes::text(const std::string& name)
{
	m_asked.insert(name);
	std::string value(trimmed(m_element.attribute(name)));
	if (value.empty()) refuse(name, "a value");
	return value;
}

std::string LabelAttributes::text(const std::string& name, const std::string& otherwise)
{
	return has(name) ? text(name) : otherwise;
}

double LabelAttributes::number(const std::string& name, Bounds bounds, std::optional<double> otherwise)
{
	if (!has(name) && otherwise) return *otherwise;
	const std::optional<double> value = parseNumber(text(name));
	if (!value || *value < bounds.least || *value > bounds.most)
		refuse(name, "a number from " + formatNumber(bounds.least) + " to " + formatNumber(bounds.most));
	return *value;
}

bool LabelAttributes::flag(const std::string& name, bool otherwise)
{
	const std::string value = text(name, otherwise ? "true" : "false");
	if (value != "true" && value != "false") refuse(name, "true or false");
	return value == "true";
}

Eigen::Vector3d LabelAttributes::point(const std::string& name)
{
	return pointIn(name, text(name));
}

std::vector<Eigen::Vector3d> LabelAttributes::points(const std::string& name)
{
	const std::string all = text(name);
	std::vector<Eigen::Vector3d> points;
	TextReader reader(all, m_file);
	do
	{
		points.push_back(pointIn(name, reader.before(";")));
	} while (reader.accept(";"));
	return points;
}

Eigen::Vector3d LabelAttributes::pointIn(const std::string& name, std::string_view text) const
{
	constexpr double kFarthest_m = 1000;
	const auto numbers = numbersIn(text);
	if (!numbers || numbers->size() < 2 || numbers->size() > 3) refuse(name, "'x y' or 'x y z' in metres");
	Eigen::Vector3d point((*numbers)[0], (*numbers)[1], numbers->size() > 2 ? (*numbers)[2] : 0.0);
	if (point.norm() > kFarthest_m) refuse(name, "a place at most 1000 m from the origin");
	return point;
}

void LabelAttributes::finish() const
{
	for (const auto& [name, value] : m_element.attributes)
		if (!m_asked.contains(name))
		{
			std::string known;
			for (const std::string& asked : m_asked) known.append(known.empty() ? "" : ", ").append(asked);
			std::string problem = "the attribute '";
			problem.append(name).append("' is not known; used so far: ").append(known);
			refuseElement(problem);
		}
}

void LabelAttributes::refuse(const std::string& name, const std::string& needed) const
{
	refuseElement(has(name) ? name + " is '" + m_element.attribute(name) + "'; " + needed + " is needed"
	                        : "the attribute '" + name + "' is missing: " + needed + " is needed");
}

void LabelAttributes::refuseElement(const std::string& reason) const
{
	std::string message = m_file;
	message.append(":").append(std::to_string(m_element.line)).append(": <").append(m_element.name).append(">: ");
	throw InputError(message.append(reason));
}
}  // namespace explore::simulation
