#include <explore/evaluation/gallery_page.h>
#include <mrpt/core/format.h>

#include <algorithm>
#include <array>

namespace explore::evaluation
{
namespace
{
struct VerdictColor
{
	Verdict verdict;
	std::string_view name;
	mrpt::img::TColor color;
};
const std::array<VerdictColor, 8> kColors{{
    {Verdict::open, "green", {74, 222, 128}},
    {Verdict::ajar, "yellow", {250, 214, 70}},
    {Verdict::passage, "turquoise", {64, 224, 208}},
    {Verdict::closed, "red", {240, 84, 70}},
    {Verdict::blocked, "orange", {255, 150, 60}},
    {Verdict::drop, "pink", {255, 122, 198}},
    {Verdict::partial, "violet", {167, 139, 250}},
    {Verdict::unknown, "grey", {160, 168, 184}},
}};

const VerdictColor& colorOf(Verdict verdict)
{
	return *std::ranges::find(kColors, verdict, &VerdictColor::verdict);
}

std::string percent(double share)
{
	return mrpt::format("%.0f %%", 100.0 * share);
}

std::string legend()
{
	std::string text;
	for (const VerdictColor& entry : kColors)
		text.append(text.empty() ? "" : ", ").append(nameOf(entry.verdict)).append(" is ").append(entry.name);
	return text;
}

std::string truthText(const TruthDoor& door)
{
	std::string text = mrpt::format("%s, %.2f m wide", std::string(nameOf(door.verdict)).c_str(), door.width_m);
	if (door.verdict == Verdict::ajar) text += mrpt::format(", clear %.2f m", door.clear_width_m);
	if (!door.passable) text += ", not to be passed";
	if (door.visibility == Visibility::ignored) text += ", partly in view";
	return text;
}

std::string sceneText(const GalleryScene& scene)
{
	std::string text = "## " + scene.family + "\n\n![" + scene.family + "](" + scene.picture + ")\n\n";
	text += "Robot: " + scene.platform + ", noise: " + scene.noise + ".\n\n";
	bool any = false;
	for (const TruthDoor& door : scene.truth)
		if (door.visibility != Visibility::hidden)
		{
			text += "* there is: " + truthText(door) + "\n";
			any = true;
		}
	if (!any) text += "* there is: no opening in view\n";
	for (const Door& door : scene.doors)
	{
		const std::string why = evidenceText(door);
		text += "* found: " + foundText(door) + "\n";
		if (!why.empty()) text += "  * why: " + why + "\n";
	}
	if (scene.doors.empty()) text += "* found: nothing\n";
	return text + "\n";
}
}  // namespace

std::string foundText(const Door& door)
{
	std::string text = mrpt::format("%s, %.2f m wide", std::string(nameOf(door.verdict)).c_str(), door.width_m);
	text += mrpt::format(", clear %.2f m", door.clear_width_m);
	if (door.height_m) text += mrpt::format(", %.2f m high", *door.height_m);
	if (door.confidence) text += mrpt::format(", confidence %.2f", *door.confidence);
	return text;
}

std::string evidenceText(const Door& door)
{
	if (!door.evidence) return "";
	const OpeningEvidence& evidence = *door.evidence;
	std::string text = "of the rays through it " + percent(evidence.through) + " lead on, " +
	                   percent(evidence.stopped) + " end soon, " + percent(evidence.no_return) +
	                   " come back with nothing";
	if (evidence.occluded >= 0.005) text += ", and " + percent(evidence.occluded) + " of all are hidden";
	text += mrpt::format("; wall beside it: left %.2f, right %.2f", evidence.left_wall, evidence.right_wall);
	if (evidence.sill >= 0.005) text += "; wall below the knee: " + percent(evidence.sill);
	if (evidence.speckle >= 0.005) text += "; lone pixels without return: " + percent(evidence.speckle);
	if (evidence.lintel_m) text += mrpt::format("; lintel %.2f m up", *evidence.lintel_m);
	if (evidence.floor_beyond) text += "; floor beyond: " + percent(*evidence.floor_beyond);
	return text + mrpt::format("; seen from %.2f to %.2f m height, %.1f m away", evidence.lowest_seen_m,
	                           evidence.highest_seen_m, evidence.range_m);
}

DoorMark galleryMark(const Door& door, const std::optional<Ground>& ground)
{
	DoorMark mark = markOf(door, ground);
	mark.color = colorOf(door.verdict).color;
	mark.label = mrpt::format("%s %.2f m", std::string(nameOf(door.verdict)).c_str(), door.clear_width_m);
	if (door.confidence) mark.label += mrpt::format(" %.0f %%", 100.0 * *door.confidence);
	return mark;
}

std::string galleryText(const GalleryHead& head, const std::vector<GalleryScene>& scenes)
{
	std::string text = "# What is found, scene by scene\n\n";
	text +=
	    "The first look at the first scene of each log, as it comes: nothing is chosen. [scenes.md](scenes.md) tells "
	    "the families.\nFound with `method = " +
	    head.method +
	    "`. Near is pale, far is deep blue, black has no return; light blue lines are the feet of "
	    "walls.\nWhat was found is outlined in the colour of its verdict, with clear width and "
	    "confidence:\n" +
	    legend() + ".\n\n    " + head.command + "\n\n";
	for (const GalleryScene& scene : scenes) text += sceneText(scene);
	text.pop_back();
	return text;
}
}  // namespace explore::evaluation
