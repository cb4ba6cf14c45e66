// Finds what returned light a moment ago and returns none any more, although nothing hides it.
#pragma once

#include <explore/core/depth_frame.h>
#include <explore/memory/block_store.h>
#include <explore/memory/frame_rays.h>
#include <explore/memory/reach_pyramid.h>
#include <explore/memory/stations.h>

#include <vector>

namespace explore
{
/** A voxel that was looked at again and is not seen. */
struct MissedVoxel
{
	VoxelBlock* block;
	int place;
};

/** One frame, as the second look needs it: its hits and passes are marked, but not yet counted. */
struct LookInput
{
	const FrameRays& rays;
	const DepthImage& image;
	const ReachPyramid& pyramid;
	const BlockStore& store;
	const Stations& stations;
	const OccupancyConfig& config;
};

/** A person who leaves an open hall, where the rays return nothing, would stay in the map for ever: no ray passes. The
 *  spatio-temporal voxel layer (Macenski et al. 2020) therefore lets what is in view and not confirmed fade. Here a
 * pixel without return says something only about a voxel of which all of this holds:
 *  - no ray of the frame ends in it or passes through it;
 *  - it is occupied, within the second-look range, and was last hit from the same place (Stations), not from nearer:
 * what returned light then would do so again;
 *  - of the pixels that see it, the middle one has no return and none has one that is not from behind it;
 *  - the next return below it in the image comes from well behind it: no near thing that the sensor cannot see stands
 *    before it, as it would hide what is below too;
 *  - no near thing in its row may keep the sensor's pattern from it;
 *  - nothing else in the map stands well in front of it.
 *  Walls, furniture and poles return light when they are looked at again; panes of glass may not.
 *
 *  Each such voxel is to get one miss; one that is not occupied any more becomes unknown, as no ray went through. */
std::vector<MissedVoxel> missedAtSecondLook(const LookInput& input);
}  // namespace explore
