#include <explore/core/errors.h>
#include <explore/sinks/camera_view.h>
#include <explore/sinks/frame_picture.h>
#include <explore/sinks/plan_view.h>
#include <mrpt/core/format.h>

#include <fstream>
#include <system_error>
#include <utility>

namespace explore
{
namespace
{
constexpr int kMargin_px = 8, kTitle_px = 26, kLegend_px = 26, kCamera_px = 640, kPanel_px = 480;
constexpr int kWidth_px = kCamera_px + kPanel_px + 2 * kMargin_px;
constexpr int kHeight_px = kTitle_px + kPanel_px + kLegend_px + 2 * kMargin_px;
constexpr CanvasArea kCameraArea{0, kTitle_px + kMargin_px, kCamera_px - 1, kTitle_px + kMargin_px + kPanel_px - 1};
constexpr CanvasArea kPlanArea{kCamera_px + kMargin_px, kTitle_px + kMargin_px, kCamera_px + kMargin_px + kPanel_px - 1,
                               kTitle_px + kMargin_px + kPanel_px - 1};

std::string title(const DepthFrame& frame, const StepResult& result)
{
	const auto& ground = result.percepts.ground;
	std::string text = mrpt::format("frame %zu   %s   walls %zu   doors %zu", frame.index, frame.sensor_label.c_str(),
	                                result.percepts.walls.size(), result.percepts.doors.size());
	if (ground) text += mrpt::format("   camera %.2f m above the floor", ground->camera_height_m);
	return text;
}

void drawTitle(Canvas& canvas, const std::string& title, const Decision& decision)
{
	canvas.text({8, 8}, title, style::kText);
	const std::string text = decisionText(decision);
	canvas.text({kWidth_px - Canvas::textWidth(text) - 16.0, 8}, text, decision.stop ? style::kDoor : style::kChosen);
}

void drawLegend(Canvas& canvas)
{
	const double row = kHeight_px - kLegend_px + 2.0;
	double column = 8.0;
	const auto entry = [&](const mrpt::img::TColor& color, const std::string& name)
	{
		canvas.line({column, row + 8.0}, {column + 18.0, row + 8.0}, 5.0, {color});
		canvas.text({column + 26.0, row}, name, style::kText);
		column += 46.0 + Canvas::textWidth(name);
	};
	entry(style::kWall, "wall-floor line");
	entry(style::kDoor, "door");
	entry(style::kDoorHeading, "to the nearest door");
	entry(style::kVanishingPoint, "vanishing point");
	entry(style::kDesired, "desired");
	entry(style::kChosen, "chosen, open path");
}

/** An encoder that runs out of disk may not say so; a whole PNG ends in its IEND chunk. */
bool isWholePng(const std::filesystem::path& path)
{
	constexpr std::string_view kEnd("IEND\xAE\x42\x60\x82", 8);
	std::ifstream file(path, std::ios::binary);
	std::string tail(kEnd.size(), '\0');
	file.seekg(-static_cast<std::streamoff>(kEnd.size()), std::ios::end);
	file.read(tail.data(), static_cast<std::streamsize>(tail.size()));
	return file && tail == kEnd;
}
}  // namespace

mrpt::img::CImage drawFramePicture(const DepthFrame& frame, const StepResult& result, const PictureConfig& config,
                                   const PictureNotes& notes)
{
	Canvas canvas(kWidth_px, kHeight_px, style::kPaper);
	drawTitle(canvas, notes.title.empty() ? title(frame, result) : notes.title, result.decision);
	drawLegend(canvas);
	const auto panel = [&](const CanvasArea& area)
	{
		for (int y = area.top; y <= area.bottom; ++y)
			for (int x = area.left; x <= area.right; ++x) canvas.pixel(x, y, {style::kPanel});
	};
	panel(kCameraArea);
	panel(kPlanArea);
	drawCameraView(canvas, kCameraArea, frame, result, config, notes);
	drawPlanView(canvas, kPlanArea, frame, result, config, notes);
	return canvas.image();
}

FramePictures::FramePictures(std::filesystem::path folder, int every, const PictureConfig& config)
    : m_folder(std::move(folder)), m_every(static_cast<std::size_t>(every)), m_config(config)
{
}

void FramePictures::write(const DepthFrame& frame, const StepResult& result) const
{
	if (frame.index % m_every != 0) return;
	std::error_code error;
	std::filesystem::create_directories(m_folder, error);
	if (error) throw OutputError(m_folder.string() + ": cannot create the folder: " + error.message());
	const auto path = m_folder / mrpt::format("%06zu.png", frame.index);
	if (!drawFramePicture(frame, result, m_config).saveToFile(path.string()) || !isWholePng(path))
		throw OutputError(path.string() + ": cannot write the picture (disk full, or no permission)");
}
}  // namespace explore
