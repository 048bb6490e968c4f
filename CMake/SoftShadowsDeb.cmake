# SPDX-License-Identifier: BSD-3-Clause
# cpack -G DEB, in the build folder: a package of everything that is installed.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME "vtksoftshadows")
set(CPACK_PACKAGE_VENDOR "The Soft Shadows for VTK project")
set(CPACK_PACKAGE_CONTACT "The Soft Shadows for VTK project <nobody@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Soft shadows for VTK: libraries, Python package and command")
set(CPACK_PACKAGE_DESCRIPTION
  "Shadow techniques for any VTK pipeline, from depth maps to rays, each an object that a render\n\
pass owns; lights with a size; a command that draws, compares, measures and shows them.")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION "libs")
# What the programs and libraries need, from what they are linked with; Python's modules besides.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
if (SOFTSHADOWS_WRAP_PYTHON)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-vtk9, python3-numpy")
  # Debian's Python looks into dist-packages, and follows what is named there, wherever the prefix is.
  file(WRITE "${CMAKE_BINARY_DIR}/vtksoftshadows.pth" "../../python\n")
  install(FILES "${CMAKE_BINARY_DIR}/vtksoftshadows.pth" DESTINATION "lib/python3/dist-packages")
endif ()
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libvtk9-dev, libglm-dev")
install(FILES "${CMAKE_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/vtksoftshadows" RENAME copyright)
install(FILES "${CMAKE_SOURCE_DIR}/CHANGELOG.md"
  DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/vtksoftshadows")
include(CPack)
