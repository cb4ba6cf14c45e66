# Cameras and recordings through OpenNI2: a component of its own, see EXPLORE_OPENNI2.
explore_layer(openni2
  SOURCES library.cpp raw_depth.cpp stream_frame.cpp color_stream.cpp depth_stream.cpp device_choice.cpp capture.cpp live_camera.cpp oni_structure.cpp oni_file.cpp frame_maker.cpp openni2_source.cpp oni_source.cpp
  LINKS explore::sources mrpt::obs)
target_link_libraries(explore_openni2 PRIVATE PkgConfig::OPENNI2)
