// Numbers, vectors and optional values as JSON; shared by the files that are written as JSON.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace explore
{
/** Keeps its keys in the order in which they were set. */
using Json = nlohmann::ordered_json;

/** A finite number. Throws std::logic_error for NaN and infinity, which JSON cannot hold and no robot may get. */
Json jsonNumber(double value);
/** [x, y, z] */
Json jsonVector(const Eigen::Vector3d& value);
/** null where there is no value. */
Json jsonOrNull(const std::optional<double>& value);
Json jsonOrNull(const std::optional<int>& value);
/** null where the text is empty. */
Json jsonOrNull(const std::string& text);

/** On one line (`indent` < 0) or indented; bytes that are no UTF-8 are replaced by U+FFFD. */
std::string jsonText(const Json& value, int indent = -1);
}  // namespace explore
