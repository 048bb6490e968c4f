# SPDX-License-Identifier: BSD-3-Clause
# find_package(VTKSoftShadows) for projects outside.

include(CMakePackageConfigHelpers)

# What the exported targets name: public dependencies, and in a static build the private ones too.
set(softshadows_vtk_dependencies)
set(softshadows_components)
foreach (module IN LISTS softshadows_modules)
  string(REPLACE "SoftShadows::" "" component "${module}")
  list(APPEND softshadows_components "${component}")
  _vtk_module_get_module_property("${module}" PROPERTY "depends" VARIABLE depends)
  _vtk_module_get_module_property("${module}" PROPERTY "private_depends" VARIABLE private_depends)
  if (BUILD_SHARED_LIBS)
    set(private_depends)
  endif ()
  list(APPEND softshadows_vtk_dependencies ${depends} ${private_depends})
endforeach ()
list(FILTER softshadows_vtk_dependencies INCLUDE REGEX "^VTK::")
list(TRANSFORM softshadows_vtk_dependencies REPLACE "^VTK::" "")
list(REMOVE_DUPLICATES softshadows_vtk_dependencies)
list(SORT softshadows_vtk_dependencies)

set(softshadows_find_dependencies "find_dependency(glm)\n")
if (NOT BUILD_SHARED_LIBS)
  string(APPEND softshadows_find_dependencies
    "find_dependency(OpenGL COMPONENTS OpenGL)\n"
    "find_dependency(nlohmann_json)\n")
  if (SOFTSHADOWS_SHADOW_VOLUMES)
    string(APPEND softshadows_find_dependencies "find_dependency(OpenMesh)\n")
  endif ()
  if (SOFTSHADOWS_RAY_TRACING)
    string(APPEND softshadows_find_dependencies
      "find_dependency(embree 3)\n"
      "find_dependency(TBB COMPONENTS tbb)\n")
  endif ()
  if (SOFTSHADOWS_IMAGE_METRICS AND SOFTSHADOWS_OPENIMAGEIO)
    string(APPEND softshadows_find_dependencies "find_dependency(OpenImageIO)\n")
  endif ()
endif ()

list(JOIN softshadows_vtk_dependencies " " softshadows_vtk_dependencies)
list(JOIN softshadows_components " " softshadows_components)
set(softshadows_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/VTKSoftShadows")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtksoftshadows-config.cmake.in"
  "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config.cmake"
  INSTALL_DESTINATION "${softshadows_cmake_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(
  "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config.cmake"
    "${CMAKE_BINARY_DIR}/${softshadows_cmake_destination}/vtksoftshadows-config-version.cmake"
  DESTINATION "${softshadows_cmake_destination}")
