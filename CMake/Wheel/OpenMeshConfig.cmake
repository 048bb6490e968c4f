# SPDX-License-Identifier: BSD-3-Clause
# find_package(OpenMesh) for the wheel: its core from source, a part of what links it.

set(OpenMesh_VERSION "10.0") # that of the Python package's sources
if (NOT TARGET OpenMeshCore)
  file(GLOB sources "${CMAKE_CURRENT_LIST_DIR}/src/OpenMesh/Core/*/*.cc")
  list(FILTER sources EXCLUDE REGEX "/IO/")
  add_library(OpenMeshCore STATIC ${sources})
  target_include_directories(OpenMeshCore SYSTEM PUBLIC "${CMAKE_CURRENT_LIST_DIR}/src")
  target_compile_definitions(OpenMeshCore PUBLIC OM_STATIC_BUILD _USE_MATH_DEFINES)
  target_compile_options(OpenMeshCore PRIVATE -w)
  set_target_properties(OpenMeshCore PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif ()
