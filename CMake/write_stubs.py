#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write __init__.pyi of the package vtksoftshadows, for editors and type checkers.

    write_stubs.py FILE    from the package on Python's path

Classes and their methods come from what VTK's wrapping says of them, the arguments of enable() from the
declarations of the techniques.
"""

import inspect
import json
import pathlib
import re
import sys

import vtksoftshadows

SIGNATURE = re.compile(r"^(\w+)\((.*)\)(?: -> (.+))?$")
BUILTIN = {"int", "float", "str", "bool", "bytes", "None", "self", "object"}
PLAIN = {"void": "None", "string": "str", "char": "str", "unicode": "str"}


class Names:
    """Names of VTK's classes that the stubs use, by module."""

    def __init__(self):
        self.modules = {}

    def use(self, name):
        """The name as a type: itself, or Any for what Python does not see."""
        for module in sys.modules.values():
            if getattr(module, "__name__", "").startswith("vtkmodules.vtk") and hasattr(module, name):
                if getattr(getattr(module, name), "__module__", None) == module.__name__:
                    self.modules.setdefault(module.__name__, set()).add(name)
                    return name
        return name if hasattr(vtksoftshadows, name) else "Any"


def to_type(text, names):
    """A type as VTK's wrapping writes it, as Python does."""
    text = text.strip()
    text = PLAIN.get(text, text)
    if text.startswith("("):
        inner = [to_type(part, names) for part in text.strip("()").split(",") if part.strip()]
        return f"tuple[{', '.join(inner)}]" if inner else "tuple"
    if text.startswith("["):
        inner = [part for part in text.strip("[]").split(",") if part.strip()]
        return f"Sequence[{to_type(inner[0], names)}]" if inner else "Sequence"
    if text in BUILTIN:
        return text
    return names.use(text) if re.fullmatch(r"\w+", text) else "Any"


def split(arguments):
    """At the commas outside of brackets."""
    parts, depth, last = [], 0, 0
    for i, letter in enumerate(arguments + ","):
        depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append(arguments[last:i].strip())
            last = i + 1
    return [part for part in parts if part]


def to_argument(text, names):
    name, _, kind = text.partition(":")
    kind, _, default = kind.partition("=")
    if name == "self":
        return name
    if not kind or not name.isidentifier():
        return f"{name if name.isidentifier() else 'value'}: Any"
    return f"{name}: {to_type(kind, names)}" + (" = ..." if default else "")


def method(name, function, names):
    """Its lines: a signature for each overload."""
    found = []
    for line in (function.__doc__ or "").split("\n"):
        match = SIGNATURE.match(line.strip())
        if match and match.group(1) == name:
            found.append(match)
    lines = []
    for match in found:
        if len(found) > 1:
            lines.append("    @overload")
        arguments = [to_argument(part, names) for part in split(match.group(2))]
        if "self" not in arguments:
            lines.append("    @staticmethod")
        result = to_type(match.group(3), names) if match.group(3) else "None"
        lines.append(f"    def {name}({', '.join(arguments)}) -> {result}: ...")
    return lines or [f"    def {name}(self, *arguments: Any) -> Any: ..."]


def write_class(name, kind, names):
    base = kind.__bases__[0].__name__
    about = (kind.__doc__ or "").strip().split("\n\n")[0].replace("\n", " ")
    lines = [f"class {name}({names.use(base)}):", f'    """{about}"""']
    for key, value in vars(kind).items():
        if key.startswith("_"):
            continue
        if isinstance(value, int):
            lines.append(f"    {key}: int")
        elif callable(value):
            lines += method(key, value, names)
    return lines


def quoted(words):
    return ", ".join(json.dumps(word) for word in words)


def write_enable():
    """enable() with each parameter of any technique, and its type."""
    techniques = vtksoftshadows.vtkShadowTechniques
    names = [techniques.GetName(i) for i in range(techniques.GetNumberOfTechniques())]
    lines = ["def enable(", "    renderer: vtkRenderer,",
             f'    technique: Literal[{quoted(names)}] | None = None,',
             "    radius: float | None = None,",
             f"    quality: Literal[{quoted(vtksoftshadows._QUALITIES)}] | None = None,",
             '    lights: Literal["studio"] | None = None,',
             "    angle: float | None = None,", "    *,"]
    for name, uses in vtksoftshadows._parameters().items():
        choices = sorted({choice for _, one in uses for choice in one.get("choices", [])})
        kind = {"integer": "int", "real": "float", "boolean": "bool",
                "choice": f"Literal[{quoted(choices)}]"}[uses[0][1]["type"]]
        lines.append(f"    {name}: {kind} = ...,")
    lines.append(") -> vtkShadowPass:")
    about = inspect.getdoc(vtksoftshadows.enable).replace("\n", "\n    ")
    lines += [f'    """{about}', '    """']
    for name, head in (
            ("studio", "(renderer: vtkRenderer, softness: float | None = None, "
             "darkness: float | None = None, elevation: float | None = None, "
             'azimuth: float | None = None, ground: Literal["catcher", "solid"] | None = "catcher", '
             "contact: bool = False, follow_camera: bool = False, "
             'up: Literal["x", "y", "z"] | Sequence[float] | None = None) -> vtkShadowStudio'),
            ("visibility", "(renderer: vtkRenderer, light: Any = 0) -> Any"),
            ("disable", "(renderer: vtkRenderer) -> None")):
        about = inspect.getdoc(getattr(vtksoftshadows, name)).replace("\n", "\n    ")
        lines += ["", f"def {name}{head}:", f'    """{about}', '    """']
    return [line.rstrip() for line in lines]


def main():
    names = Names()
    names.use("vtkRenderer")
    classes = []
    for name, kind in sorted(vars(vtksoftshadows).items()):
        if inspect.isclass(kind) and not name.startswith("_"):
            classes += write_class(name, kind, names) + [""]
    lines = ["# Written by CMake/write_stubs.py.", "from typing import Any, Literal, Sequence, overload", ""]
    lines += [f"from {module} import {', '.join(sorted(used))}"
              for module, used in sorted(names.modules.items())]
    lines += ["", "__version__: str", "", *classes, *write_enable()]
    pathlib.Path(sys.argv[1]).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
