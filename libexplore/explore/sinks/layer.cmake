find_package(mrpt-img 2.5 REQUIRED)

explore_layer(sinks
  SOURCES output_config.cpp output_file.cpp output_folder.cpp json_values.cpp json_lines.cpp stage_clock.cpp timing_csv.cpp
          trajectory.cpp exploration_summary.cpp summary.cpp progress.cpp canvas.cpp picture_style.cpp camera_view.cpp plan_view.cpp frame_picture.cpp map_files.cpp
  LINKS explore::pipeline explore::memory nlohmann_json::nlohmann_json mrpt::img)
