explore_layer(navigation
  SOURCES level_frame.cpp goal_choice.cpp open_path.cpp best_direction.cpp mrpt_avoiders.cpp avoider.cpp
    near_field_guard.cpp heading.cpp
  LINKS explore::perception mrpt::nav)
