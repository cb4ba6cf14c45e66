explore_layer(
    core SOURCES depth_frame.cpp geometry.cpp heap.cpp results.cpp LINKS Eigen3::Eigen mrpt::poses mrpt::system)
