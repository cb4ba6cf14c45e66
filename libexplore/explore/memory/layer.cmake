explore_layer(memory
  SOURCES occupancy_config.cpp voxel_block.cpp block_tree.cpp block_store.cpp frame_rays.cpp cube_view.cpp
          reach_pyramid.cpp ray_ends.cpp octet_look.cpp voxel_crossing.cpp ray_passes.cpp stations.cpp second_look.cpp
          occupancy.cpp key_range.cpp floor_map.cpp
          layer_frame.cpp body_layers_config.cpp body_layers.cpp frontier_clusters.cpp frontiers.cpp
          track_existence.cpp door_place.cpp door_sighting.cpp door_belief.cpp door_track.cpp door_fusion.cpp
          door_sight.cpp door_reveal.cpp door_map_check.cpp door_objections.cpp door_upkeep.cpp door_tracks.cpp corridor_fusion.cpp
          corridor_sight.cpp corridor_tracks.cpp recent_obstacles.cpp
          frontier_memory.cpp
  LINKS explore::perception octomap octomath)
