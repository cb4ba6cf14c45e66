# The simulated worlds, camera and robots: a component of its own, see EXPLORE_SIMULATION.
find_package(mrpt-img 2.5 REQUIRED)

explore_layer(simulation
  SOURCES world.cpp random.cpp polygon.cpp shapes.cpp load_world.cpp sdf/world_cache.cpp
          sdf/world_builder.cpp sdf/world_labels.cpp sdf/label_attributes.cpp sdf/label_json.cpp moving_track.cpp
          sdf/text_reader.cpp sdf/xml.cpp sdf/resources.cpp sdf/warnings.cpp sdf/mesh_import.cpp
          sdf/sdf_values.cpp sdf/sdf_tree.cpp sdf/sdf_frames.cpp sdf/sdf_state.cpp sdf/sdf_actor.cpp sdf/sdf_geometry.cpp sdf/sdf_vocabulary.cpp
          ray_scene.cpp ray_packets.cpp ray_images.cpp ray_contacts.cpp baked_mesh.cpp triangle_distance.cpp
          depth_camera.cpp sensor_view.cpp projector_shadow.cpp sight.cpp pane_optics.cpp noise_random.cpp noise_samples.cpp noise_kinect.cpp noise_speckle.cpp
          speckle_pattern.cpp speckle_image.cpp speckle_contrast.cpp speckle_match.cpp
          robot_body.cpp swept_body.cpp free_paths.cpp truth_view.cpp door_visibility.cpp door_passage.cpp corridor_truth.cpp
          truth_rays.cpp log_maker.cpp
          robot_motion.cpp movers.cpp odometry.cpp simulated_robot.cpp path_follower.cpp
          path_carrier.cpp route_carrier.cpp recorder.cpp closed_loop.cpp start_pose.cpp
          plan_triangle.cpp cell_spread.cpp reachable_space.cpp
          scenes/scene_plan.cpp scenes/scene_sketch.cpp scenes/scene_walls.cpp scenes/scene_doors.cpp scenes/scene_pieces.cpp scenes/scene_furniture.cpp
          scenes/scene_clutter.cpp scenes/scene_view.cpp scenes/scene_beyond.cpp scenes/scene_rooms.cpp scenes/scene_corridor.cpp
          scenes/family_paper.cpp scenes/family_doors.cpp scenes/family_leaves.cpp scenes/family_blocked.cpp scenes/family_unseen.cpp scenes/family_decoys.cpp
          scenes/family_corridors.cpp scenes/family_obstacles.cpp scenes/scene_families.cpp scenes/scene_promise.cpp scenes/scene_approach.cpp scenes/scene.cpp scenes/scene_log.cpp
  LINKS explore::config mrpt::obs mrpt::img)
target_link_libraries(explore_simulation PRIVATE sdformat12::sdformat12 assimp::assimp embree)
