"""Writes the type stubs of Mien's wrapped modules beside them, from the signatures in VTK's own docstrings.

    python3 make_stubs.py FOLDER_OF_THE_PACKAGE MODULE ...
"""

from __future__ import annotations

import importlib
import keyword
import pathlib
import re
import sys

SIGNATURE = re.compile(r"^(?P<name>\w+)\((?P<arguments>.*?)\)(?: -> (?P<result>.+))?$")
CLASS_NAME = re.compile(r"\bvtk\w+\b")
KNOWN = {"str", "int", "float", "bool", "None", "Buffer", "Callback", "Pointer", "Template", "bytes", "self"}


def type_of(text: str) -> str:
    """(str, ...) is a tuple, [float, float] a list that is filled."""
    text = text.strip()
    if text.startswith("(") and text.endswith(")"):
        return f"tuple[{', '.join(type_of(part) for part in text[1:-1].split(','))}]"
    if text.startswith("[") and text.endswith("]"):
        return f"MutableSequence[{type_of(text[1:-1].split(',')[0])}]"
    if text == "...":
        return text
    return text if text in KNOWN - {"Buffer", "Callback", "Pointer", "Template"} or CLASS_NAME.fullmatch(text) else "Any"


def split_arguments(text: str) -> list[str]:
    parts, depth, part = [], 0, ""
    for character in text:
        depth += (character in "([") - (character in ")]")
        if character == "," and depth == 0:
            parts.append(part.strip())
            part = ""
        else:
            part += character
    return parts + [part.strip()] if part.strip() else parts


def argument_of(text: str, index: int) -> str:
    if text in ("self", "..."):
        return "self" if text == "self" else "*args: Any"
    name, _, rest = text.partition(":")
    kind, _, default = rest.partition("=")
    name = name.strip() if name.strip().isidentifier() and not keyword.iskeyword(name.strip()) else f"argument{index}"
    return f"{name}: {type_of(kind)}" + (" = ..." if default else "")


def signatures_of(documentation: str) -> list[re.Match[str]]:
    lines = re.sub(r",\n\s+", ", ", documentation).splitlines()
    follows = [line.startswith("C++:") for line in lines[1:]] + [False]
    return [match for line, is_signature in zip(lines, follows) if is_signature and (match := SIGNATURE.match(line))]


def method_lines(name: str, documentation: str) -> list[str]:
    matches = signatures_of(documentation)
    lines = []
    for match in matches:
        arguments = split_arguments(match["arguments"])
        is_static = not arguments or arguments[0] != "self"
        if len(matches) > 1:
            lines.append("    @overload")
        if is_static:
            lines.append("    @staticmethod")
        written = ", ".join(argument_of(text, i) for i, text in enumerate(arguments))
        lines.append(f"    def {name}({written}) -> {type_of(match['result'] or 'None')}: ...")
    return lines


def class_lines(one: type) -> list[str]:
    lines = [f"class {one.__name__}({one.__bases__[0].__name__}):"]
    for name, member in vars(one).items():
        if isinstance(member, type):
            lines.append(f"    class {name}(int): ...")
        elif isinstance(member, int):
            lines.append(f"    {name}: int")
        elif not name.startswith("_") and callable(member):
            lines += method_lines(name, member.__doc__ or "")
    return lines if len(lines) > 1 else lines + ["    ..."]


def ordered(classes: list[type]) -> list[type]:
    """Bases before what is derived from them."""
    return sorted(classes, key=lambda one: (len(one.__mro__), one.__name__))


def imports_of(text: str, module: str) -> list[str]:
    """Whence the VTK classes come that the text names and does not define."""
    defined = set(re.findall(r"^class (\w+)", text, re.MULTILINE))
    lines = []
    for name in sorted(set(CLASS_NAME.findall(text)) - defined):
        owners = [m for m in sorted(sys.modules) if m.startswith(("vtkmodules.vtk", "mien.Mien")) and m != module
                  and name in vars(sys.modules[m])]
        lines.append(f"from {owners[0]} import {name}" if owners else f"{name} = Any")
    return sorted(lines, key=lambda line: not line.startswith("from"))


def stub_of(module_name: str) -> str:
    module = importlib.import_module(module_name)
    classes = [one for one in vars(module).values() if isinstance(one, type) and one.__module__ == module_name]
    body = "\n\n".join("\n".join(class_lines(one)) for one in ordered(classes))
    head = ["from collections.abc import MutableSequence", "from typing import Any, overload", ""]
    return "\n".join(head + imports_of(body, module_name) + ["", body, ""])


def main() -> None:
    package = pathlib.Path(sys.argv[1])
    sys.path.insert(0, str(package.parent))
    for name in sys.argv[2:]:
        (package / f"{name}.pyi").write_text(stub_of(f"{package.name}.{name}"), encoding="utf-8")


main()
