# SPDX-License-Identifier: BSD-3-Clause
"""check_package.py PREFIX TECHNIQUE...: the package lies under PREFIX, with just these techniques,
and uses no library from elsewhere."""

import os
import sys

import vtksoftshadows

prefix, expected = os.path.realpath(sys.argv[1]), sorted(sys.argv[2:])
place = os.path.realpath(vtksoftshadows.__file__)
assert place.startswith(prefix + os.sep), place

techniques = vtksoftshadows.vtkShadowTechniques
known = [techniques.GetName(i) for i in range(techniques.GetNumberOfTechniques())]
assert known == expected, (known, expected)

# What the loader has taken, and from where (Linux tells).
if os.path.exists("/proc/self/maps"):
    with open("/proc/self/maps", encoding="utf-8") as maps:
        loaded = {line.split()[-1] for line in maps if "vtkSoftShadows" in line}
    assert loaded, "no library of the package is loaded"
    # Nor does one know where it was built, but for a debugger.
    source = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))).encode()
    for path in loaded:
        with open(path, "rb") as library:
            content = library.read()
        assert source not in content or b".debug_info" in content, path
    strangers = [path for path in loaded if not path.startswith(prefix + os.sep)]
    assert not strangers, strangers
print(place, *known)
