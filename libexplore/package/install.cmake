# The library for others: archives, headers, and what find_package(explore-mrpt) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/explore-mrpt)
set(EXPLORE_LIBRARY_LAYERS core config perception memory navigation pipeline sources)
set(EXPLORE_MRPT_VERSION 2.5)

# install_part(NAME LAYER...): those of the layers that were built, as one file of targets.
function(install_part name)
  set(built)
  foreach(layer ${ARGN})
    if(TARGET explore_${layer})
      set_target_properties(explore_${layer} PROPERTIES EXPORT_NAME ${layer})
      list(APPEND built explore_${layer})
      if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/explore/${layer})  # or it shares another layer's
        install(DIRECTORY explore/${layer} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/explore COMPONENT dev
          FILES_MATCHING PATTERN "*.h")
      endif()
    endif()
  endforeach()
  if(built)
    install(TARGETS ${built} EXPORT explore-mrpt-${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
    install(EXPORT explore-mrpt-${name} NAMESPACE explore:: DESTINATION ${folder} COMPONENT dev)
  endif()
endfunction()

install_part(library ${EXPLORE_LIBRARY_LAYERS})
install_part(files robot_link sinks evaluation)
install_part(simulation simulation)
install_part(openni2 openni2)

configure_package_config_file(package/explore-mrpt-config.cmake.in explore-mrpt-config.cmake
  INSTALL_DESTINATION ${folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(explore-mrpt-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/explore-mrpt-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/explore-mrpt-config-version.cmake
  DESTINATION ${folder} COMPONENT dev)
