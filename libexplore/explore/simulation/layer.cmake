# The simulated worlds, camera and robots: a component of its own, see EXPLORE_SIMULATION.
find_package(mrpt-img 2.5 REQUIRED)

explore_layer(simulation
  SOURCES world.cpp random.cpp polygon.cpp shapes.cpp load_world.cpp world_cache.cpp
          world_builder.cpp world_labels.cpp label_attributes.cpp label_json.cpp moving_track.cpp
          text_reader.cpp xml.cpp resources.cpp warnings.cpp mesh_import.cpp
          sdf_values.cpp sdf_tree.cpp sdf_frames.cpp sdf_state.cpp sdf_actor.cpp sdf_geometry.cpp sdf_vocabulary.cpp
          ray_scene.cpp ray_packets.cpp ray_images.cpp ray_contacts.cpp baked_mesh.cpp triangle_distance.cpp
          depth_camera.cpp sensor_view.cpp projector_shadow.cpp sight.cpp pane_optics.cpp noise_random.cpp noise_kinect.cpp noise_speckle.cpp
          speckle_pattern.cpp speckle_image.cpp speckle_contrast.cpp speckle_match.cpp
          robot_body.cpp swept_body.cpp free_paths.cpp truth_view.cpp door_visibility.cpp door_passage.cpp corridor_truth.cpp
          truth_rays.cpp log_maker.cpp
          simulated_robot_config.cpp robot_motion.cpp movers.cpp odometry.cpp simulated_robot.cpp path_follower.cpp
          path_carrier.cpp route_carrier.cpp recorder.cpp
          scene_plan.cpp scene_sketch.cpp scene_walls.cpp scene_doors.cpp scene_pieces.cpp scene_furniture.cpp
          scene_clutter.cpp scene_view.cpp scene_beyond.cpp scene_rooms.cpp scene_corridor.cpp
          family_paper.cpp family_doors.cpp family_leaves.cpp family_blocked.cpp family_unseen.cpp family_decoys.cpp
          family_corridors.cpp family_obstacles.cpp scene_families.cpp scene_promise.cpp scene_approach.cpp scene.cpp scene_log.cpp
  LINKS explore::config mrpt::obs mrpt::img)
target_link_libraries(explore_simulation PRIVATE sdformat12::sdformat12 assimp::assimp embree)
