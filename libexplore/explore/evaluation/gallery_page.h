// A page in Markdown with one picture a scene: what is there, what was found, and why.
#pragma once

#include <explore/evaluation/door_pairs.h>
#include <explore/sinks/picture_style.h>

#include <string>
#include <vector>

namespace explore::evaluation
{
struct GalleryScene
{
	std::string family, platform, noise;
	std::string picture;           ///< path of the picture as seen from the page
	std::vector<TruthDoor> truth;  ///< of the frame, hidden ones included
	std::vector<Door> doors;       ///< that were found
};

/** What the page is made of besides the scenes. */
struct GalleryHead
{
	std::string command;  ///< that makes page and pictures again
	std::string method;   ///< of [perception]
};

std::string galleryText(const GalleryHead& head, const std::vector<GalleryScene>& scenes);

/** "open, 0.92 m wide, clear 0.92 m, confidence 0.97" */
std::string foundText(const Door& door);
/** What the rays through the opening met, as a sentence; "" where the method does not say. */
std::string evidenceText(const Door& door);

/** A door that was found, in its verdict's colour. */
DoorMark galleryMark(const Door& door, const std::optional<Ground>& ground);
}  // namespace explore::evaluation
