explore_layer(sources
  SOURCES source_config.cpp checked_stream.cpp allocation_limit.cpp guarded_archive.cpp rawlog_reader.cpp
          external_files.cpp lens_distortion.cpp self_mask.cpp depth_conversion.cpp
          pose_track.cpp recorded_poses.cpp gravity_track.cpp rawlog_source.cpp make_source.cpp
          depth_png.cpp image_folders.cpp rawlog_writer.cpp import_recording.cpp rawlog_info.cpp rawlog_info_text.cpp map_file.cpp
  LINKS explore::config mrpt::obs mrpt::maps octomap octomath ZLIB::ZLIB)
