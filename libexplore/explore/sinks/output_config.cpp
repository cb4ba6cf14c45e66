#include <explore/sinks/output_config.h>

namespace explore
{
void describe(FieldVisitor& fields, OutputConfig& config)
{
	fields.section("output", "Which files a run leaves beside frames.jsonl and summary.json");
	fields.flag("timing", config.timing, "Write timing.csv: the time of every stage in every frame");
	fields.flag("trajectory", config.trajectory, "Write trajectory.tum: map_from_robot of every frame");
	fields.flag("report", config.report, "Write report.html: the run as one page to look at");
	fields.flag("scene", config.scene, "Write scene.3Dscene: map, way, doors and headings in 3D, for SceneViewer3D");
	fields.flag("annotated", config.annotated,
	            "Write annotated.rawlog: the input and what was made of each frame, for RawLogViewer");
	fields.integer("pictures_every", config.pictures_every, {0, 1'000'000}, "frames",
	               "Draw every n-th frame into pictures/NNNNNN.png; 0 = none");
	fields.real("checkpoint_period", config.checkpoint_period_s, {0.0, 3600.0}, "s",
	            "Keep what --resume goes on from in state/ so often; 0 = never");
}
}  // namespace explore
