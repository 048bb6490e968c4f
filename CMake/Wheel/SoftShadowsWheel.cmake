# SPDX-License-Identifier: BSD-3-Clause
# What a wheel holds beyond our libraries: those of others that are not VTK's, their licences, the
# command's entry point.

# Libraries under the names by which they are looked for.
function (softshadows_wheel_library target)
  get_target_property(location "${target}" LOCATION)
  execute_process(
    COMMAND "${CMAKE_OBJDUMP}" -p "${location}"
    OUTPUT_VARIABLE headers
    COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCH "SONAME +([^\n]+)" matched "${headers}")
  file(REAL_PATH "${location}" location)
  install(
    PROGRAMS "${location}"
    DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    RENAME "${CMAKE_MATCH_1}"
    COMPONENT runtime)
endfunction ()
function (softshadows_wheel_licence file name)
  if (EXISTS "${file}")
    install(
      FILES "${file}"
      DESTINATION "${CMAKE_INSTALL_LIBDIR}/licences"
      RENAME "${name}.txt"
      COMPONENT runtime)
  endif ()
endfunction ()

if (SOFTSHADOWS_RAY_TRACING)
  softshadows_wheel_library(embree)
  softshadows_wheel_library(TBB::tbb)
  softshadows_wheel_licence("/usr/share/doc/libembree3-3/copyright" embree)
  softshadows_wheel_licence("/usr/share/doc/libtbb12/copyright" tbb)
endif ()
if (SOFTSHADOWS_SHADOW_VOLUMES)
  softshadows_wheel_licence("${OpenMesh_DIR}/LICENSE" openmesh)
endif ()

# The command's entry point, which says so where there is no command.
configure_file(
  "${CMAKE_CURRENT_LIST_DIR}/command.py" "${softshadows_python}/vtksoftshadows/command.py" COPYONLY)
install(
  FILES "${CMAKE_CURRENT_LIST_DIR}/command.py"
  DESTINATION "vtksoftshadows"
  COMPONENT python)
