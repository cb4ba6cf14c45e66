#include <explore/config/number_text.h>
#include <explore/core/errors.h>
#include <explore/core/geometry.h>
#include <explore/simulation/sdf/sdf_values.h>
#include <explore/simulation/sdf/text_reader.h>

namespace explore::simulation
{
namespace
{
[[noreturn]] void refuse(const XmlNode& element, const std::string& needed)
{
	std::string message = "<";
	message.append(element.name).append("> in line ").append(std::to_string(element.line)).append(" is '");
	throw InputError(message.append(element.text).append("': ").append(needed));
}

std::vector<double> numbersOf(const XmlNode& element, std::size_t count)
{
	std::optional<std::vector<double>> numbers = numbersIn(element.text);
	if (!numbers || numbers->size() != count)
		refuse(
		    element,
		    std::to_string(count).append(count == 1 ? " finite number is" : " finite numbers are").append(" needed"));
	return *std::move(numbers);
}
}  // namespace

std::optional<std::vector<double>> numbersIn(std::string_view text)
{
	std::vector<double> numbers;
	for (text = trimmed(text); !text.empty(); text = trimmed(text))
	{
		std::size_t end = 0;
		while (end < text.size() && !isBlank(text[end])) ++end;
		const std::optional<double> number = parseNumber(text.substr(0, end));
		if (!number) return std::nullopt;
		numbers.push_back(*number);
		text.remove_prefix(end);
	}
	return numbers;
}

double numberAt(const XmlNode& node, std::string_view child, double otherwise)
{
	const XmlNode* found = node.child(child);
	return found == nullptr ? otherwise : numbersOf(*found, 1)[0];
}

Eigen::VectorXd vectorAt(const XmlNode& node, std::string_view child, const Eigen::VectorXd& otherwise)
{
	const XmlNode* found = node.child(child);
	if (found == nullptr) return otherwise;
	const std::vector<double> numbers = numbersOf(*found, static_cast<std::size_t>(otherwise.size()));
	return Eigen::Map<const Eigen::VectorXd>(numbers.data(), otherwise.size());
}

bool flagAt(const XmlNode& node, std::string_view child)
{
	const std::string text = node.textAt(child);
	return text == "1" || text == "true" || text == "True";
}

Eigen::Isometry3d poseOf(const XmlNode& node)
{
	Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
	const XmlNode* element = node.child("pose");
	if (element == nullptr || element->text.empty()) return pose;
	const bool quaternion = element->attribute("rotation_format") == "quat_xyzw";
	const std::vector<double> v = numbersOf(*element, quaternion ? 7 : 6);
	pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
	if (quaternion)
	{
		const Eigen::Quaterniond turn(v[6], v[3], v[4], v[5]);
		if (turn.norm() < 1e-6) refuse(*element, "a quaternion of length 1 is needed");
		pose.linear() = turn.normalized().toRotationMatrix();
		return pose;
	}
	const std::string degrees = element->attribute("degrees");
	const double unit = degrees == "true" || degrees == "1" ? kDegree_rad : 1.0;
	pose.linear() = (Eigen::AngleAxisd(unit * v[5], Eigen::Vector3d::UnitZ()) *
	                 Eigen::AngleAxisd(unit * v[4], Eigen::Vector3d::UnitY()) *
	                 Eigen::AngleAxisd(unit * v[3], Eigen::Vector3d::UnitX()))
	                    .toRotationMatrix();
	return pose;
}

std::string poseText(const Eigen::Isometry3d& parent_from_element)
{
	const Eigen::Vector3d place = parent_from_element.translation();
	const Eigen::Quaterniond turn(parent_from_element.linear());
	std::string text;
	for (const double number : {place.x(), place.y(), place.z(), turn.x(), turn.y(), turn.z(), turn.w()})
		text.append(text.empty() ? "" : " ").append(formatNumber(number));
	return text;
}
}  // namespace explore::simulation
