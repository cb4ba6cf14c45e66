# Targets that read the sources rather than build them: format, format-check, tidy.
find_program(CLANG_FORMAT_PROGRAM clang-format)
if(CLANG_FORMAT_PROGRAM)
  set(every_source find libexplore apps tests ( -name *.h -o -name *.cpp ) -exec ${CLANG_FORMAT_PROGRAM})
  add_custom_target(format
    COMMAND ${every_source} -i {} + WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
  add_custom_target(format-check
    COMMAND ${every_source} --dry-run --Werror {} + WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
endif()

# clang-tidy reads compile_commands.json: what is not configured (a missing package) is not checked. It spends its time on the
# headers, so it is run over batches of sources where the build has them (the preset tidy does), several times as fast.
find_program(RUN_CLANG_TIDY_PROGRAM NAMES run-clang-tidy run-clang-tidy-14)
find_program(CLANG_TIDY_PROGRAM clang-tidy)
if(RUN_CLANG_TIDY_PROGRAM AND CLANG_TIDY_PROGRAM)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  # The tests apart: they take twice as long as all the rest.
  foreach(target_and_folders "tidy=libexplore|apps" "tidy-tests=tests")
    string(REGEX MATCH "^([^=]+)=(.*)$" _ "${target_and_folders}")
    add_custom_target(${CMAKE_MATCH_1}
      COMMAND ${RUN_CLANG_TIDY_PROGRAM} -quiet -j ${cores} -p ${CMAKE_BINARY_DIR}
              -clang-tidy-binary ${CLANG_TIDY_PROGRAM} "^(${PROJECT_SOURCE_DIR}|${PROJECT_BINARY_DIR})/(${CMAKE_MATCH_2})/"
      VERBATIM USES_TERMINAL)
  endforeach()
endif()
