// pictures/NNNNNN.png: what one frame showed and what was decided, side by side as camera image and plan.
#pragma once

#include <explore/sinks/picture_style.h>

#include <filesystem>

namespace explore
{
/** 1136 × 548 px: title, camera view, plan view, legend. The doors of `notes` lie below those of the results. */
mrpt::img::CImage drawFramePicture(const DepthFrame& frame, const StepResult& result, const PictureConfig& config,
                                   const PictureNotes& notes = {});

/** Writes the picture of every n-th frame into a folder, which is made with the first one. */
class FramePictures
{
public:
	FramePictures(std::filesystem::path folder, int every, const PictureConfig& config);
	/** Throws OutputError when the picture cannot be written. */
	void write(const DepthFrame& frame, const StepResult& result) const;

private:
	std::filesystem::path m_folder;
	std::size_t m_every;
	PictureConfig m_config;
};
}  // namespace explore
