# SPDX-License-Identifier: BSD-3-Clause
# Everything from outside, found once. Debian package names stand in packages.txt.

if (SOFTSHADOWS_WRAP_PYTHON)
  # The distribution's own interpreter: another one may come first in the path and lacks VTK.
  set(Python3_EXECUTABLE "/usr/bin/python3" CACHE FILEPATH "Interpreter that has VTK")
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development)
endif ()

# OpenGL's functions come with RenderingOpenGL2, from glew or, since VTK 9.4, glad.
set(softshadows_vtk_components
  ChartsCore CommonColor CommonComputationalGeometry CommonCore CommonDataModel
  CommonExecutionModel CommonMath CommonSystem CommonTransforms FiltersCore FiltersFlowPaths
  FiltersGeneral FiltersGeometry FiltersModeling FiltersSources ImagingCore ImagingHybrid
  InteractionStyle IOCore IOGeometry IOImage IOImport IOLegacy IOPLY IOXML RenderingAnnotation
  RenderingContext2D RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingLOD RenderingOpenGL2
  RenderingUI RenderingVolume RenderingVolumeOpenGL2 TestingCore TestingRendering vtksys)
if (SOFTSHADOWS_WRAP_PYTHON)
  # The tool: a component that newer VTKs do not count as found where it is required.
  list(APPEND softshadows_vtk_components
    Python WrappingPythonCore OPTIONAL_COMPONENTS WrapPython)
endif ()
find_package(VTK 9.1 REQUIRED COMPONENTS ${softshadows_vtk_components})
# PYTHONPATH of what is run from the build: our package, and VTK's where Python has another one or none.
set(softshadows_pythonpath "${softshadows_python}")
if (SOFTSHADOWS_WHEEL)
  string(APPEND softshadows_pythonpath ":${VTK_PREFIX_PATH}")
endif ()

find_package(OpenGL REQUIRED COMPONENTS OpenGL)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
if (SOFTSHADOWS_SHADOW_VOLUMES)
  find_package(OpenMesh REQUIRED)
endif ()
if (SOFTSHADOWS_RAY_TRACING)
  find_package(embree 3 REQUIRED)
  find_package(TBB REQUIRED COMPONENTS tbb)
endif ()
if (SOFTSHADOWS_IMAGE_METRICS AND SOFTSHADOWS_OPENIMAGEIO)
  find_package(OpenImageIO REQUIRED)
  # Debian's package names an OpenCV include folder that need not exist.
  get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
  list(FILTER oiio_includes EXCLUDE REGEX "opencv")
  set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${oiio_includes}")
endif ()
if (SOFTSHADOWS_BUILD_APPS)
  find_package(CLI11 REQUIRED)
  find_package(Boost REQUIRED)
  find_package(valijson REQUIRED)
  find_path(MUSTACHE_INCLUDE_DIR kainjow/mustache.hpp REQUIRED)
endif ()
