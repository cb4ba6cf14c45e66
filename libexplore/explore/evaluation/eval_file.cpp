#include <explore/core/errors.h>
#include <explore/evaluation/eval_file.h>
#include <explore/evaluation/results_text.h>

#include <algorithm>

namespace explore::evaluation
{
namespace
{
constexpr int kSchema = 1;

Json setupJson(const EvalSetup& setup)
{
	Json set = Json::array();
	for (const std::string& item : setup.set) set.push_back(item);
	return {{"version", setup.version},
	        {"ini", jsonOrNull(setup.ini)},
	        {"robot", jsonOrNull(setup.robot)},
	        {"set", set},
	        {"config", setup.config}};
}

std::string textOrEmpty(const JsonPlace& place)
{
	return place.isNull() ? "" : place.text();
}

EvalSetup setupOf(const JsonPlace& place)
{
	EvalSetup setup;
	setup.version = place.at("version").text();
	setup.ini = textOrEmpty(place.at("ini"));
	setup.robot = textOrEmpty(place.at("robot"));
	for (const JsonPlace& item : place.at("set").items()) setup.set.push_back(item.text());
	setup.config = place.at("config").text();
	return setup;
}
}  // namespace

std::string evalText(const Evaluation& evaluation, const Results& results)
{
	std::string text = "{\"schema\":" + std::to_string(kSchema);
	text.append(",\n\"setup\":").append(jsonText(setupJson(evaluation.setup))).append(",\n\"logs\":[");
	for (std::size_t i = 0; i < evaluation.logs.size(); ++i)
		text.append(i == 0 ? "\n" : ",\n").append(jsonText(logJson(evaluation.logs[i])));
	return text.append("\n],\n\"results\":").append(jsonText(resultsJson(results), 1)).append("}\n");
}

Evaluation readEval(const std::filesystem::path& path)
{
	const Json document = readJson(path);
	const JsonPlace place(document, path.string());
	if (place.at("schema").count() != kSchema) place.at("schema").refuse("1");
	Evaluation evaluation{setupOf(place.at("setup")), {}};
	for (const JsonPlace& item : place.at("logs").items()) evaluation.logs.push_back(logOf(item));
	return evaluation;
}

void checkOrder(const std::vector<LogScore>& logs)
{
	const auto twice = std::ranges::adjacent_find(logs, {}, &LogScore::log);
	if (twice != logs.end()) throw InputError(twice->log + ": scored twice; each log may be there once");
}
}  // namespace explore::evaluation
