explore_layer(perception
  SOURCES range_filter.cpp near_field.cpp voxel_grid.cpp planes.cpp ground.cpp walls.cpp door_gaps.cpp vanishing_point.cpp
          obstacles.cpp mount.cpp perceive.cpp
  LINKS explore::config)
