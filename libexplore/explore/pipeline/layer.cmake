explore_layer(pipeline
  SOURCES explorer_config.cpp intent.cpp explorer.cpp
  LINKS explore::navigation)
