#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""write_manual.py COMMAND FILE: the manual page of the command, from what it says of itself (--help)."""

import re
import subprocess
import sys


def ask(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def options(lines):
    """The options of a part of the help: a paragraph each, name and meaning."""
    page = []
    for line in lines:
        named = re.match(r"  (\S.*?)(?:  +(\S.*))?$", line)
        if named and not line.startswith("   "):
            page += [".TP", "\\fB%s\\fR" % escaped(named[1])]
            if named[2]:
                page.append(escaped(named[2]))
        elif line.strip():
            page.append(escaped(line.strip()))
    return page


def manual(command):
    version = ask(command, "--version").split()[1]
    about = ask(command, "--help").split("\n")[0]
    commands = re.findall(r"^  (\w+)  ", ask(command, "--help").split("Subcommands:")[1], re.M)
    page = ['.TH SOFTSHADOWS 1 "" "softshadows %s" "Soft Shadows for VTK"' % escaped(version),
            ".SH NAME", "softshadows \\- soft shadows for VTK, drawn, compared, measured and viewed",
            ".SH SYNOPSIS"]
    for name in commands:
        page += [".B softshadows %s" % name, "[OPTIONS] ...", ".br"]
    page += [".SH DESCRIPTION", escaped(about)]
    for name in commands:
        text, _, keys = ask(command, name, "--help").partition("Keys and mouse:")
        page += [".SH %s" % name.upper()]
        head, *parts = re.split(r"^([A-Z][a-z]+):$", text, flags=re.M)
        page += [escaped(line) for line in head.split("Usage:")[0].strip().split("\n")]
        for title, part in zip(parts[::2], parts[1::2]):
            page += [".SS %s" % title] + options(part.split("\n"))
        if keys:
            page += [".SS Keys and mouse", ".nf"]
            page += [escaped(line) for line in keys.strip().split("\n")] + [".fi"]
    page += [".SH EXIT STATUS", "0 when done, 1 for a failure that it names, 2 for wrong usage,",
             "130 when the user ended it.",
             ".SH ENVIRONMENT", ".TP", ".B DISPLAY", "The X server that is drawn with.",
             ".TP", ".B SOFTSHADOWS_DATA", "Folder of the models that built\\-in scenes use."]
    return "\n".join(page) + "\n"


def main():
    page = manual(sys.argv[1])
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(page)


if __name__ == "__main__":
    main()
