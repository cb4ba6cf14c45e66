#include "evaluation/truth_maker.h"

#include <explore/evaluation/gallery_page.h>
#include <gmock/gmock.h>

#include <set>

using namespace explore;
using namespace explore::evaluation;
using testing::HasSubstr;
using testing::Not;

namespace
{
Door ajarDoor()
{
	Door door;
	door.width_m = 0.92;
	door.clear_width_m = 0.55;
	door.verdict = Verdict::ajar;
	door.confidence = 0.874;
	return door;
}
}  // namespace

TEST(GalleryPage, TellsWhatIsThereWhatWasFoundAndWhy)
{
	GalleryScene scene{"ajar_30-ground", "ground", "kinect", "images/scenes/ajar_30-ground.jpg", {}, {ajarDoor()}};
	scene.truth = {test::openDoor("a", 3, 0, 0.9), test::openDoor("b", 3, 2, 1.3)};
	scene.truth[0].verdict = Verdict::ajar;
	scene.truth[0].clear_width_m = 0.5;
	scene.truth[0].passable = false;
	scene.truth[1].visibility = Visibility::hidden;
	std::string text = galleryText({"explore-eval gallery x", "full"}, {scene});
	EXPECT_THAT(text, HasSubstr("    explore-eval gallery x\n"));
	EXPECT_THAT(text, HasSubstr("## ajar_30-ground\n\n![ajar_30-ground](images/scenes/ajar_30-ground.jpg)"));
	EXPECT_THAT(text, HasSubstr("there is: ajar, 0.90 m wide, clear 0.50 m, not to be passed\n"));
	EXPECT_THAT(text, Not(HasSubstr("1.30"))) << "hidden";
	EXPECT_THAT(text, HasSubstr("found: ajar, 0.92 m wide, clear 0.55 m, confidence 0.87\n"));
	EXPECT_THAT(text, Not(HasSubstr("why")));

	OpeningEvidence evidence;
	evidence.through = 0.62;
	evidence.stopped = 0.35;
	evidence.no_return = 0.03;
	evidence.lintel_m = 2.04;
	scene.doors[0].evidence = evidence;
	text = galleryText({"", "full"}, {scene});
	EXPECT_THAT(text, HasSubstr("why: of the rays through it 62 % lead on, 35 % end soon, 3 % come back with nothing"));
	EXPECT_THAT(text, HasSubstr("lintel 2.04 m up"));
	EXPECT_THAT(text, Not(HasSubstr("floor beyond")));
}

TEST(GalleryPage, NothingIsSaidToBeNothing)
{
	const std::string text = galleryText({"", "paper"}, {{"window-mav", "mav", "speckle", "w.jpg", {}, {}}});
	EXPECT_THAT(text, HasSubstr("there is: no opening in view"));
	EXPECT_THAT(text, HasSubstr("found: nothing"));
}

TEST(GalleryPage, EachVerdictHasAColourOfItsOwn)
{
	std::set<int> colors;
	for (const Verdict verdict : {Verdict::open, Verdict::ajar, Verdict::closed, Verdict::blocked, Verdict::passage,
	                              Verdict::drop, Verdict::partial, Verdict::unknown})
	{
		Door door = ajarDoor();
		door.verdict = verdict;
		const DoorMark mark = galleryMark(door, std::nullopt);
		colors.insert((mark.color.R << 16) + (mark.color.G << 8) + mark.color.B);
		EXPECT_EQ(mark.label, std::string(nameOf(verdict)) + " 0.55 m 87 %");
	}
	EXPECT_EQ(colors.size(), 8U);
}
