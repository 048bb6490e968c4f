# SPDX-License-Identifier: BSD-3-Clause
# What is built. Each family of techniques is an option; turning it off leaves out its dependency.

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

option(BUILD_SHARED_LIBS "Build shared libraries (Python needs them)" ON)
option(SOFTSHADOWS_WRAP_PYTHON "Wrap for Python (package vtksoftshadows)" ON)
option(SOFTSHADOWS_BUILD_APPS "Build the command softshadows" ON)
# Set by CMake/Wheel/vtk_sdk.py: the layout of a wheel beside VTK's.
option(SOFTSHADOWS_WHEEL "Build for the VTK of the Python package index" OFF)
mark_as_advanced(SOFTSHADOWS_WHEEL)

# The families of techniques: option, module, what it is.
set(softshadows_families
  "SHADOW_MAPS:ShadowMaps:Shadow maps and their filters, map-*"
  "PLANAR_SHADOWS:PlanarShadows:Shadows projected onto planes, planar-*"
  "OCCLUSION_TEXTURES:OcclusionTextures:Prefiltered slices of the casters, occlusion-textures"
  "SHADOW_VOLUMES:ShadowVolumes:Stencil shadow volumes (OpenMesh), volume-*"
  "VIRTUAL_SHADOW_MAPS:VirtualShadowMaps:Soft shadow maps of predicted resolution, virtual-maps"
  "RAY_TRACING:RayTracing:Ray-traced reference (Embree), ray-traced"
  "AUTOMATIC:Automatic:The technique that an error or a time asks for, auto")
set(softshadows_family_modules)
set(softshadows_switches "IMAGE_METRICS:ImageMetrics" "SCENES:Scenes")
foreach (family IN LISTS softshadows_families)
  string(REPLACE ":" ";" family "${family}")
  list(POP_FRONT family option module about)
  option("SOFTSHADOWS_${option}" "${about}" ON)
  list(APPEND softshadows_family_modules "SoftShadows::${module}")
  list(APPEND softshadows_switches "${option}:${module}")
endforeach ()

option(SOFTSHADOWS_IMAGE_METRICS "Reading, writing and comparing pictures" ON)
set(softshadows_openimageio ON)
if (SOFTSHADOWS_WHEEL)
  set(softshadows_openimageio OFF) # it passes strings, in another form than VTK's wheel
endif ()
option(SOFTSHADOWS_OPENIMAGEIO "Image files by OpenImageIO; else a few formats by VTK"
  ${softshadows_openimageio})
option(SOFTSHADOWS_SCENES "Built-in scenes" ON)
option(SOFTSHADOWS_WERROR "Warnings of our own sources are errors" OFF)
include(CTest)

foreach (pair IN LISTS softshadows_switches)
  string(REPLACE ":" ";" pair "${pair}")
  list(GET pair 0 option)
  list(GET pair 1 module)
  # In the cache: the scan reads nothing else.
  if (SOFTSHADOWS_${option})
    set("VTK_MODULE_ENABLE_SoftShadows_${module}" "YES" CACHE STRING "" FORCE)
  else ()
    set("VTK_MODULE_ENABLE_SoftShadows_${module}" "NO" CACHE STRING "" FORCE)
  endif ()
  mark_as_advanced("VTK_MODULE_ENABLE_SoftShadows_${module}")
endforeach ()
if (SOFTSHADOWS_BUILD_APPS AND NOT (SOFTSHADOWS_IMAGE_METRICS AND SOFTSHADOWS_SCENES))
  message(FATAL_ERROR
    "SOFTSHADOWS_BUILD_APPS needs SOFTSHADOWS_IMAGE_METRICS and SOFTSHADOWS_SCENES")
endif ()

if (BUILD_TESTING)
  set(softshadows_test_state WANT)
else ()
  set(softshadows_test_state OFF)
endif ()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

# Layout of the build: build/bin/softshadows, build/lib, build/lib/python.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
# A build can be moved.
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
set(softshadows_python_destination "lib/python")
if (SOFTSHADOWS_WHEEL)
  # A package beside vtkmodules, with the rest of a prefix in it.
  set(softshadows_python_destination ".")
  set(CMAKE_INSTALL_LIBDIR "vtksoftshadows/lib")
  set(CMAKE_INSTALL_BINDIR "vtksoftshadows/bin")
  set(CMAKE_INSTALL_DATADIR "vtksoftshadows/share")
  set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/lib;$ORIGIN/../lib;$ORIGIN/../vtkmodules;$ORIGIN/../../vtkmodules")
endif ()
set(softshadows_python "${CMAKE_BINARY_DIR}/${softshadows_python_destination}")

# Warnings for our own sources; wrapping sources that VTK generates are not ours.
function (softshadows_warnings target)
  # A module is given by its alias: the target behind it is named after the library since VTK 9.7.
  get_target_property(aliased "${target}" ALIASED_TARGET)
  if (aliased)
    set(target "${aliased}")
    # What is installed tells nothing of this machine: VTK's messages name their source file.
    target_compile_options("${target}" PRIVATE
      "$<$<CXX_COMPILER_ID:GNU,Clang>:-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=>")
  endif ()
  target_compile_options("${target}" PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local>
    $<$<CXX_COMPILER_ID:GNU,Clang>:-Wall -Wextra -Wno-unused-parameter>
    $<$<AND:$<BOOL:${SOFTSHADOWS_WERROR}>,$<CXX_COMPILER_ID:GNU,Clang>>:-Werror>)
endfunction ()

# GLSL files of a module's glsl/, by name, as strings: adds to its lists sources and private_headers.
macro (softshadows_encode_shaders)
  foreach (shader IN ITEMS ${ARGN})
    vtk_encode_string(
      INPUT "glsl/${shader}.glsl"
      NAME "${shader}"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source)
    list(APPEND sources "${source}")
    list(APPEND private_headers "${header}")
  endforeach ()
endmacro ()
