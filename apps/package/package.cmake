# What comes with the programs where they are installed – manual pages, completion, documents – and the Debian packages
# (cpack): explore-mrpt, the programs, and libexplore-mrpt-dev, the library for programs of others.
include(GNUInstallDirs)
set(folder ${CMAKE_CURRENT_LIST_DIR})
set(work ${CMAKE_CURRENT_BINARY_DIR}/package)
set(programs explore-mrpt explore-rawlog explore-eval)
set(doc_folder ${CMAKE_INSTALL_DATADIR}/doc)

# Manual pages are made from --help, one a program and one a subcommand, as git does it.
find_program(HELP2MAN_PROGRAM help2man)
if(HELP2MAN_PROGRAM AND NOT EXPLORE_SANITIZE)
  add_custom_command(OUTPUT ${work}/man.stamp
    COMMAND ${folder}/make_manual.sh ${HELP2MAN_PROGRAM} ${PROJECT_VERSION} ${work}/man
            $<TARGET_FILE:explore-mrpt> $<TARGET_FILE:explore-rawlog> $<TARGET_FILE:explore-eval>
    COMMAND ${CMAKE_COMMAND} -E touch ${work}/man.stamp
    DEPENDS ${programs} ${folder}/make_manual.sh ${folder}/manual.inc
    COMMENT "Manual pages" VERBATIM)
  add_custom_target(man ALL DEPENDS ${work}/man.stamp)
  install(DIRECTORY ${work}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
elseif(NOT HELP2MAN_PROGRAM)
  message(STATUS "Without manual pages: help2man was not found")
endif()

foreach(program ${programs})
  install(FILES ${folder}/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ${program})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${doc_folder}/explore-mrpt)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc DESTINATION ${doc_folder}/explore-mrpt)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc/examples/ DESTINATION ${doc_folder}/libexplore-mrpt-dev/examples COMPONENT dev
  USE_SOURCE_PERMISSIONS)

# Debian wants each package's changes and copyright beside it, the changes compressed.
add_custom_command(OUTPUT ${work}/changelog.gz
  COMMAND ${CMAKE_COMMAND} -E make_directory ${work}
  COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/CHANGELOG.md > ${work}/changelog.gz
  DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md VERBATIM)
add_custom_target(package_changelog ALL DEPENDS ${work}/changelog.gz)
foreach(package_and_component "explore-mrpt=runtime" "libexplore-mrpt-dev=dev")
  string(REGEX MATCH "^(.*)=(.*)$" _ ${package_and_component})
  install(FILES ${work}/changelog.gz DESTINATION ${doc_folder}/${CMAKE_MATCH_1} COMPONENT ${CMAKE_MATCH_2})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${doc_folder}/${CMAKE_MATCH_1} RENAME copyright COMPONENT ${CMAKE_MATCH_2})
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "indoor explorer: depth-camera frames in, heading out")
set(CPACK_PACKAGE_VENDOR "The explore-mrpt authors")
set(CPACK_PACKAGE_CONTACT "The explore-mrpt authors <${EXPLORE_MAINTAINER}>")
set(CPACK_COMPONENTS_ALL runtime dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME explore-mrpt)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "Finds open doors, corridors and obstacles in the frames of a depth camera,
keeps a map of what was seen, and drives a robot until nothing is left to
see. Frames come from an OpenNI2 camera, an MRPT rawlog or a simulated world.
explore-mrpt explores, explore-rawlog makes and shows recordings,
explore-eval scores them.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libexplore-mrpt-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libmrpt-nav-dev (>= 1:2.5), libeigen3-dev, liboctomap-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS "explore-mrpt, nlohmann-json3-dev, libsdformat-dev, libassimp-dev, libembree-dev, libopenni2-dev")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Static libraries, headers and CMake files for programs of your own:
perception of doors, corridors and obstacles in depth images, the map and its
frontiers, goals and avoidance, one call a frame.")
include(CPack)
