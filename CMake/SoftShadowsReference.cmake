# SPDX-License-Identifier: BSD-3-Clause
# The reference of the public headers by Doxygen, where it is: the target softshadows_reference. A test
# holds that it warns of nothing.

find_program(SOFTSHADOWS_DOXYGEN doxygen)
mark_as_advanced(SOFTSHADOWS_DOXYGEN)
if (NOT SOFTSHADOWS_DOXYGEN)
  return ()
endif ()

file(GLOB softshadows_reference_input LIST_DIRECTORIES true "${CMAKE_SOURCE_DIR}/Modules/*")
list(APPEND softshadows_reference_input "${CMAKE_SOURCE_DIR}/Data")
list(JOIN softshadows_reference_input " " softshadows_reference_input)
configure_file("${CMAKE_SOURCE_DIR}/Documentation/Doxyfile.in" "${CMAKE_BINARY_DIR}/Doxyfile" @ONLY)
add_custom_target(softshadows_reference
  COMMAND "${SOFTSHADOWS_DOXYGEN}" "${CMAKE_BINARY_DIR}/Doxyfile"
  COMMENT "Writing the reference into ${CMAKE_BINARY_DIR}/reference/html"
  VERBATIM)
if (BUILD_TESTING)
  add_test(NAME Documentation.Reference
    COMMAND "${SOFTSHADOWS_DOXYGEN}" "${CMAKE_BINARY_DIR}/Doxyfile")
endif ()
