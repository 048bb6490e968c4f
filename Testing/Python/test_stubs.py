# SPDX-License-Identifier: BSD-3-Clause
"""What editors and shells are told of the package is what it takes."""

import ast
import inspect
import pathlib
import unittest

import vtksoftshadows as vss
from shadow_testing import describe, main, declared_names


class TestStubs(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(vss.__file__).parent
        cls.tree = ast.parse((folder / "__init__.pyi").read_text())
        cls.typed = (folder / "py.typed").exists()

    def names(self):
        return {parameter["name"].replace("-", "_")
                for technique in declared_names()
                for parameter in describe(technique)["parameters"]}

    def test_enable(self):
        self.assertTrue(self.typed)
        enable, = [node for node in self.tree.body
                   if isinstance(node, ast.FunctionDef) and node.name == "enable"]
        self.assertEqual([argument.arg for argument in enable.args.args],
                         ["renderer", "technique", "radius", "quality", "lights", "angle"])
        self.assertEqual({argument.arg for argument in enable.args.kwonlyargs}, self.names())

    def test_functions(self):
        # Each as the package has it, argument by argument.
        for name in ("studio", "visibility", "disable"):
            stub, = [node for node in self.tree.body
                     if isinstance(node, ast.FunctionDef) and node.name == name]
            self.assertEqual([argument.arg for argument in stub.args.args],
                             list(inspect.signature(getattr(vss, name)).parameters))

    def test_signature(self):
        arguments = inspect.signature(vss.enable).parameters
        self.assertLessEqual(self.names(), set(arguments))
        for name in self.names():
            self.assertIn(f"\n{name}  (", vss.enable.__doc__)

    def test_classes(self):
        stubs = {node.name: node for node in self.tree.body if isinstance(node, ast.ClassDef)}
        for name, kind in vars(vss).items():
            if not inspect.isclass(kind) or name.startswith("_"):
                continue
            methods = {node.name for node in stubs[name].body if isinstance(node, ast.FunctionDef)}
            real = {key for key, value in vars(kind).items()
                    if callable(value) and not key.startswith("_") and not inspect.isclass(value)}
            self.assertLessEqual(real, methods, name)
            self.assertTrue(ast.get_docstring(stubs[name]), name)


if __name__ == "__main__":
    main()
