# SPDX-License-Identifier: BSD-3-Clause
# Python package vtksoftshadows: the wrapped modules and an __init__ that puts every class on top.

if (NOT SOFTSHADOWS_WRAP_PYTHON)
  return ()
endif ()
if (NOT BUILD_SHARED_LIBS)
  message(FATAL_ERROR "SOFTSHADOWS_WRAP_PYTHON needs BUILD_SHARED_LIBS: a static build makes a "
    "package that cannot import itself")
endif ()

vtk_module_wrap_python(
  MODULES ${softshadows_modules}
  TARGET SoftShadows::Python
  INSTALL_EXPORT VTKSoftShadows
  PYTHON_PACKAGE "vtksoftshadows"
  MODULE_DESTINATION "lib/python"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/VTKSoftShadows"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)

set(softshadows_python_imports)
foreach (module IN LISTS softshadows_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
  string(APPEND softshadows_python_imports "from .${library} import *\n")
endforeach ()
configure_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtksoftshadows_init.py.in"
  "${CMAKE_BINARY_DIR}/lib/python/vtksoftshadows/__init__.py" @ONLY)
install(
  FILES "${CMAKE_BINARY_DIR}/lib/python/vtksoftshadows/__init__.py"
  DESTINATION "lib/python/vtksoftshadows")

# Stubs, for editors and type checkers: from the package itself, once it is there.
set(softshadows_stubs "${CMAKE_BINARY_DIR}/lib/python/vtksoftshadows/__init__.pyi")
add_custom_target(softshadows_stubs ALL
  COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${CMAKE_BINARY_DIR}/lib/python"
    "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/CMake/write_stubs.py" "${softshadows_stubs}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${CMAKE_BINARY_DIR}/lib/python/vtksoftshadows/py.typed"
  BYPRODUCTS "${softshadows_stubs}"
  COMMENT "Writing the stubs of vtksoftshadows"
  VERBATIM)
foreach (module IN LISTS softshadows_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
  add_dependencies(softshadows_stubs "${library}Python")
endforeach ()
install(
  FILES "${softshadows_stubs}" "${CMAKE_BINARY_DIR}/lib/python/vtksoftshadows/py.typed"
  DESTINATION "lib/python/vtksoftshadows")
