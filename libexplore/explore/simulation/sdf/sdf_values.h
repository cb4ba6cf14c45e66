// Numbers, vectors and poses as SDF writes them.
#pragma once

#include <explore/simulation/sdf/xml.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string_view>
#include <vector>

namespace explore::simulation
{
/** The finite numbers that `text` consists of, blanks between them; no value when anything else stands there. */
std::optional<std::vector<double>> numbersIn(std::string_view text);

/** The number in the child of that name, `otherwise` when there is none. Throws InputError when it is no finite number.
 */
double numberAt(const XmlNode& node, std::string_view child, double otherwise);
/** As numberAt(), for `size` numbers. */
Eigen::VectorXd vectorAt(const XmlNode& node, std::string_view child, const Eigen::VectorXd& otherwise);
/** "true" or "1". */
bool flagAt(const XmlNode& node, std::string_view child);

/** parent_from_element of the `<pose>` in `node` (x y z roll pitch yaw, or with the attributes `degrees` and
 *  `rotation_format`); identity when there is none. Throws InputError when it is not six (seven) finite numbers. */
Eigen::Isometry3d poseOf(const XmlNode& node);
/** The text of a `<pose>`. */
std::string poseText(const Eigen::Isometry3d& parent_from_element);
}  // namespace explore::simulation
