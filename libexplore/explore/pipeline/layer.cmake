explore_layer(pipeline
  SOURCES explorer_config.cpp explorer.cpp
  LINKS explore::navigation)
