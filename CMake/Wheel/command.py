# SPDX-License-Identifier: BSD-3-Clause
"""The command softshadows of the wheel: a program of its own beside this file."""

import os
import sys


def main():
    # Its libraries are those of the VTK that this Python has.
    program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "softshadows")
    if not os.path.exists(program):
        sys.exit("softshadows: this wheel was built without the command (SOFTSHADOWS_BUILD_APPS)")
    os.execv(program, [program, *sys.argv[1:]])
