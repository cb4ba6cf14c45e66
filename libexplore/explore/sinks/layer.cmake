find_package(mrpt-img 2.5 REQUIRED)
find_package(mrpt-opengl 2.5 REQUIRED)
find_package(Threads REQUIRED)

# By itself, for programs that only drive a robot, and so that its threads can be watched without building all the rest.
explore_layer(robot_link FOLDER sinks
  SOURCES json_values.cpp robot_link/link_config.cpp robot_link/link_address.cpp robot_link/link_socket.cpp
          robot_link/json_command_sink.cpp robot_link/robot_link.cpp robot_link/robot2nav_sink.cpp robot_link/robot_message.cpp
          robot_link/robot_inbox.cpp robot_link/robot_listener.cpp
  LINKS explore::config explore::core nlohmann_json::nlohmann_json mrpt::nav mrpt::obs Threads::Threads)

explore_layer(sinks
  SOURCES output_config.cpp output_file.cpp output_folder.cpp json_lines.cpp stage_clock.cpp timing_csv.cpp
          trajectory.cpp exploration_summary.cpp summary.cpp progress.cpp canvas.cpp picture_style.cpp camera_projection.cpp camera_view.cpp
          plan_view.cpp frame_picture.cpp map_files.cpp html_text.cpp doors_geojson.cpp
          report/depth_picture.cpp report/camera_record.cpp report/plan_grid.cpp report/plan_record.cpp report/thinning.cpp
          report/report_log.cpp report/report_recorder.cpp report/report_page.cpp
          scene/shapes.cpp scene/frame_sketch.cpp scene/run_scene.cpp annotations.cpp
  LINKS explore_robot_link explore::pipeline explore::memory nlohmann_json::nlohmann_json mrpt::img mrpt::obs mrpt::opengl)
include(${CMAKE_CURRENT_LIST_DIR}/report/page_parts.cmake)
