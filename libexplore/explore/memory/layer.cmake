explore_layer(memory
  SOURCES occupancy_config.cpp voxel_block.cpp block_tree.cpp block_store.cpp frame_rays.cpp cube_view.cpp
          reach_pyramid.cpp ray_ends.cpp octet_look.cpp voxel_crossing.cpp ray_passes.cpp stations.cpp second_look.cpp
          occupancy.cpp floor_map.cpp
  LINKS explore::perception octomap octomath)
