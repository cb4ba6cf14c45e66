explore_layer(perception
  SOURCES range_filter.cpp near_field.cpp voxel_grid.cpp planes.cpp ground.cpp walls.cpp door_gaps.cpp vanishing_point.cpp
          obstacles.cpp obstacle_tiles.cpp sight_lines.cpp mount.cpp perceive.cpp
          wall_rays.cpp wall_profile.cpp jamb_fit.cpp clear_width.cpp doorway_plan.cpp opening_rays.cpp far_jamb.cpp opening_evidence.cpp
          opening_features.cpp pass_probability.cpp pass_trees.cpp opening_verdict.cpp opening_candidates.cpp openings.cpp full_view.cpp perceive_full.cpp remedies.cpp
          corridor_points.cpp corridor_walls.cpp corridor_sides.cpp corridor_edges.cpp corridor.cpp corridor_end.cpp
          corridor_companion.cpp corridor_pairs.cpp corridor_end_evidence.cpp
          sensor_noise.cpp sample_grid.cpp ground_memory.cpp up_prior.cpp floor_samples.cpp floor.cpp level_view.cpp
          plan_scan.cpp plan_line.cpp wall_lines.cpp upright_walls.cpp wall_bend.cpp
  LINKS explore::config)
