explore_layer(config
  SOURCES
    fields.cpp field_list.cpp field_value.cpp number_text.cpp suggestions.cpp
    ini_file.cpp ini_text.cpp ini_lines.cpp ini_document.cpp ini_check.cpp ini_load.cpp ini_dump.cpp ini_reference.cpp
    sensor_poses.cpp simulated_camera.cpp simulated_robot.cpp
  LINKS explore::core mrpt::config mrpt::poses)
