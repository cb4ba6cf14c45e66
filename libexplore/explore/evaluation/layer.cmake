explore_layer(evaluation
  SOURCES json_place.cpp truth_file.cpp truth_reader.cpp tally.cpp heading_score.cpp door_pairs.cpp
          cause_geometry.cpp causes.cpp csv.cpp frame_score.cpp frame_rows.cpp statistics.cpp scene_bootstrap.cpp log_score.cpp worst_frames.cpp figures.cpp groups.cpp requirements.cpp text_table.cpp
          results_json.cpp group_tables.cpp results_text.cpp eval_file.cpp compare_runs.cpp compare_text.cpp reliability_diagram.cpp gallery_page.cpp page.cpp truth_marks.cpp coverage.cpp coverage_count.cpp run_watch.cpp soak.cpp soak_pairs.cpp
  LINKS explore::sinks nlohmann_json::nlohmann_json)
