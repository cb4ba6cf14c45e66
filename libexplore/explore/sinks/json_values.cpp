#include <explore/sinks/json_values.h>

#include <cmath>
#include <stdexcept>

namespace explore
{
Json jsonNumber(double value)
{
	if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number: " + std::to_string(value));
	return value == 0.0 ? 0.0 : value;  // never −0
}

Json jsonVector(const Eigen::Vector3d& value)
{
	return Json::array({jsonNumber(value.x()), jsonNumber(value.y()), jsonNumber(value.z())});
}

Json jsonOrNull(const std::optional<double>& value)
{
	return value ? jsonNumber(*value) : Json();
}

Json jsonOrNull(const std::optional<int>& value)
{
	return value ? Json(*value) : Json();
}

Json jsonOrNull(const std::string& text)
{
	return text.empty() ? Json() : Json(text);
}

std::string jsonText(const Json& value, int indent)
{
	return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}
}  // namespace explore
