# page_parts.cpp: the report's page as C++ texts, made anew when one of its files changes.
set(folder ${CMAKE_CURRENT_LIST_DIR})
foreach(part page.css page.html data.js draw.js plan.js camera.js curves.js page.js)
  file(READ ${folder}/${part} ${part})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/${part})
endforeach()
configure_file(${folder}/page_parts.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp @ONLY)
target_sources(explore_sinks PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/page_parts.cpp)
