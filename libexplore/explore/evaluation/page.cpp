#include <explore/evaluation/page.h>
#include <explore/evaluation/reliability_diagram.h>
#include <explore/sinks/html_text.h>

namespace explore::evaluation
{
namespace
{
constexpr std::size_t kMostBytes = 15'000'000, kReserve = 4096;  // the reserve is for what ends the page

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --line: #8884; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 1180px; padding: 24px; }
pre { font: 13px/1.45 ui-monospace, monospace; overflow-x: auto; border: 1px solid var(--line); padding: 12px; }
h1 { font-size: 24px; } h2 { font-size: 20px; margin-top: 40px; }
figure { margin: 24px 0; border-top: 1px solid var(--line); padding-top: 16px; }
figcaption h3 { font-size: 16px; margin: 0; overflow-wrap: anywhere; }
figcaption p, figcaption ul { margin: 4px 0 12px; }
img { max-width: 100%; height: auto; display: block; }
.key span { display: inline-block; margin-right: 20px; }
.key i { display: inline-block; width: 18px; height: 5px; margin-right: 6px; vertical-align: middle; }
)";

std::string figureText(const Evaluation& evaluation, const PagePicture& picture)
{
	const LogScore& log = evaluation.logs.at(picture.selected.log);
	const WorstFrame& frame = picture.selected.frame;
	std::string text = "<figure>\n<figcaption><h3>" + escapedHtml(log.log) + ", frame " + std::to_string(frame.frame) +
	                   ", scene " + std::to_string(frame.scene) + "</h3>\n<p>";
	text += escapedHtml(log.family.empty() ? log.world : log.family) + ", " + escapedHtml(log.platform) + ", noise " +
	        escapedHtml(log.noise) + "</p>\n<ul>\n";
	for (const std::string& remark : frame.remarks) text += "<li>" + escapedHtml(remark) + "</li>\n";
	text += "</ul></figcaption>\n<img alt=\"depth image and plan of frame " + std::to_string(frame.frame) +
	        "\" src=\"data:image/jpeg;base64,";
	return text.append(base64(picture.jpeg)).append("\">\n</figure>\n");
}

std::string setupText(const EvalSetup& setup)
{
	std::string text = "explore-eval " + setup.version + ", configuration ";
	text += setup.ini.empty() ? "built-in defaults" : setup.ini;
	for (const std::string& item : setup.set) text += ", " + item;
	return text + ", robot " + (setup.robot.empty() ? "of each log's truth" : setup.robot);
}
}  // namespace

std::string pageText(const Evaluation& evaluation, const PageTables& tables, const std::vector<PagePicture>& pictures)
{
	std::string text =
	    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
	    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
	    "<title>explore-eval</title>\n<style>";
	text += kStyle;
	text += "</style>\n</head>\n<body>\n<h1>Doors, directions and headings against the truth</h1>\n<p>" +
	        escapedHtml(setupText(evaluation.setup)) + "</p>\n<pre>" + escapedHtml(tables.text) + "</pre>\n";
	if (!tables.reliability.empty()) text += "<h2>Confidences</h2>\n" + reliabilitySvg(tables.reliability);
	text +=
	    "<h2>The worst frames</h2>\n<p class=\"key\"><span><i style=\"background:#f05446\"></i>reported</span>"
	    "<span><i style=\"background:#40e0d0\"></i>true, has to be found</span>"
	    "<span><i style=\"background:#a78bfa\"></i>true, counts neither way</span>"
	    "<span><i style=\"background:#8089a0\"></i>true, hidden or not to be passed</span></p>\n";
	std::size_t shown = 0;
	for (const PagePicture& picture : pictures)
	{
		const std::string figure = figureText(evaluation, picture);
		if (text.size() + figure.size() + kReserve > kMostBytes) break;
		text += figure;
		++shown;
	}
	if (pictures.empty()) text += "<p>No frame went wrong, or no pictures were asked for.</p>\n";
	if (shown < pictures.size())
		text += "<p>" + std::to_string(pictures.size() - shown) + " more are in the folder pictures.</p>\n";
	return text + "</body>\n</html>\n";
}
}  // namespace explore::evaluation
