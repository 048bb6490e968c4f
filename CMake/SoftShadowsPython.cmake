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
  MODULE_DESTINATION "${softshadows_python_destination}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/VTKSoftShadows"
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF)

set(softshadows_python_imports)
set(softshadows_python_targets)
foreach (module IN LISTS softshadows_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
  # Some have nothing to wrap.
  if (TARGET "${library}Python")
    string(APPEND softshadows_python_imports "from .${library} import *\n")
    list(APPEND softshadows_python_targets "${library}Python")
  endif ()
endforeach ()
set(softshadows_vtk_hint)
if (SOFTSHADOWS_WHEEL)
  set(softshadows_vtk_hint " (pip install vtk==${VTK_VERSION})")
endif ()
configure_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtksoftshadows_init.py.in"
  "${softshadows_python}/vtksoftshadows/__init__.py" @ONLY)
configure_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtksoftshadows_pyvista.py"
  "${softshadows_python}/vtksoftshadows/pyvista.py" COPYONLY)
install(
  FILES
    "${softshadows_python}/vtksoftshadows/__init__.py"
    "${softshadows_python}/vtksoftshadows/pyvista.py"
  DESTINATION "${softshadows_python_destination}/vtksoftshadows"
  COMPONENT python)

# Stubs, for editors and type checkers: from the package itself, once it is there.
set(softshadows_stubs "${softshadows_python}/vtksoftshadows/__init__.pyi")
add_custom_target(softshadows_stubs ALL
  COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${softshadows_pythonpath}"
    "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/CMake/write_stubs.py" "${softshadows_stubs}"
  COMMAND "${CMAKE_COMMAND}" -E touch "${softshadows_python}/vtksoftshadows/py.typed"
  BYPRODUCTS "${softshadows_stubs}"
  COMMENT "Writing the stubs of vtksoftshadows"
  VERBATIM)
add_dependencies(softshadows_stubs ${softshadows_python_targets})
install(
  FILES "${softshadows_stubs}" "${softshadows_python}/vtksoftshadows/py.typed"
  DESTINATION "${softshadows_python_destination}/vtksoftshadows"
  COMPONENT python)
