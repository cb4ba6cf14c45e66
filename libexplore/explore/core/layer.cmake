explore_layer(
    core SOURCES byte_archive.cpp depth_frame.cpp geometry.cpp heap.cpp matching.cpp results.cpp truth.cpp LINKS Eigen3::Eigen mrpt::poses mrpt::system)
