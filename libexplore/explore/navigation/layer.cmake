explore_layer(navigation
  SOURCES level_frame.cpp goal_choice.cpp open_path.cpp level_sight.cpp unseen_space.cpp ways.cpp best_direction.cpp mrpt_avoiders.cpp avoider.cpp
    near_field_guard.cpp heading.cpp
  LINKS explore::perception mrpt::nav)
