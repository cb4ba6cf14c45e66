explore_layer(navigation
  SOURCES level_frame.cpp goal_choice.cpp open_path.cpp level_sight.cpp unseen_space.cpp ways.cpp best_direction.cpp mrpt_avoiders.cpp avoider.cpp
    near_field_guard.cpp heading.cpp
    plan_config.cpp mission_config.cpp keep_out.cpp capped_distance.cpp plan_map.cpp pockets.cpp travel_field.cpp look_gain.cpp
    look_targets.cpp coarse_map.cpp tour.cpp tour_search.cpp tour_worth.cpp goal_pick.cpp goal_kind.cpp left_over.cpp mission_plan.cpp barred_ways.cpp mission_goal.cpp mission.cpp map_obstacles.cpp way_ahead.cpp steering.cpp
  LINKS explore::memory mrpt::nav)
