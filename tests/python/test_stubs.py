"""The stubs name every class and method that there is, in Python that can be read."""

import ast
import importlib
import inspect
import pathlib
import unittest

import mien

PACKAGE = pathlib.Path(mien.__file__).parent
MODULES = sorted(file.stem for file in PACKAGE.glob("Mien*.so"))


class StubsTest(unittest.TestCase):
    def test_there_is_one_for_each_module(self):
        self.assertEqual(MODULES, ["MienAcquisition", "MienAnimation", "MienDeformation", "MienSurface", "MienTexture"])
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_they_name_every_method(self):
        for name in MODULES:
            tree = ast.parse((PACKAGE / f"{name}.pyi").read_text(encoding="utf-8"))
            stubs = {one.name: {f.name for f in one.body if isinstance(f, ast.FunctionDef)}
                     for one in tree.body if isinstance(one, ast.ClassDef)}
            module = importlib.import_module(f"mien.{name}")
            classes = {c.__name__: c for c in vars(module).values() if inspect.isclass(c)}
            self.assertEqual(set(stubs), set(classes))
            for class_name, one in classes.items():
                methods = {m for m, f in vars(one).items() if callable(f) and not inspect.isclass(f) and not m.startswith("_")}
                self.assertEqual(methods - stubs[class_name], set(), class_name)

    def test_every_filter_has_its_words(self):
        for name, one in inspect.getmembers(mien, inspect.isclass):
            if name.startswith("vtk"):
                self.assertGreater(len(one.__doc__), 200, name)
        for name in mien.Face.__dict__:
            if not name.startswith("_"):
                self.assertTrue(getattr(mien.Face, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
