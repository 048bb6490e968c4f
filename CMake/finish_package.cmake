# SPDX-License-Identifier: BSD-3-Clause
# Run by CPack in the tree that is to be packed: Debian's Python looks into dist-packages, and follows
# what a .pth there names.

set(packed "${CMAKE_INSTALL_PREFIX}")
if (DEFINED ENV{DESTDIR})
  set(packed "$ENV{DESTDIR}/${packed}")
endif ()
if (EXISTS "${packed}/lib/python/vtksoftshadows")
  file(WRITE "${packed}/lib/python3/dist-packages/vtksoftshadows.pth" "../../python\n")
endif ()
