# find_package(VTKSoftShadows) for projects outside.

include(CMakePackageConfigHelpers)
set(softshadows_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/VTKSoftShadows")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtksoftshadows-config.cmake.in"
  "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config.cmake"
  INSTALL_DESTINATION "${softshadows_cmake_destination}")
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config.cmake"
    "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config-version.cmake"
  DESTINATION "${softshadows_cmake_destination}")
