explore_layer(memory
  SOURCES occupancy_config.cpp voxel_block.cpp block_store.cpp block_tree.cpp frame_rays.cpp reach_pyramid.cpp ray_ends.cpp cube_view.cpp octet_look.cpp voxel_crossing.cpp ray_passes.cpp stations.cpp second_look.cpp
          occupancy.cpp floor_map.cpp
  LINKS explore::perception octomap octomath)

