// The Markdown reference names every section and key with default, accepted values and meaning.
#include <gmock/gmock.h>

#include "every_kind.h"

namespace explore
{
namespace
{
using testing::HasSubstr;

TEST(IniReference, hasOneTableASectionAndOneRowAKey)
{
	test::EveryKind config;
	const std::string text = iniReference(test::fieldsOf(config));
	EXPECT_THAT(
	    text,
	    HasSubstr("## [shape]\n\nWhat it looks like.\n\n| key | default | accepted | meaning |\n|---|---|---|---|\n"));
	EXPECT_THAT(text, HasSubstr("| `length` | `0.1` | a number from -10 to 10 m | From end to end. |\n"));
	EXPECT_THAT(text, HasSubstr("| `tilt_deg` | `15` | a number from -180 to 180 deg | Against the vertical. |\n"));
	EXPECT_THAT(text, HasSubstr("| `path` | (empty) | a text | The picture to paint. |\n"));
	EXPECT_THAT(text, HasSubstr("| `gain` | `1e-07` | a number from 0 to 1 | A pure number. |\n"));
}
}  // namespace
}  // namespace explore
