# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Reads the public C headers with pycparser, and asks a C compiler about them."""

from __future__ import annotations

import ctypes
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

INCLUDE = Path(os.environ.get("TYNDALL_INCLUDE", Path(__file__).parents[2] / "lib/include"))
HEADERS = ("tyndall.h", "tyndall_cl.h", "tyndall_io.h")  # which include the others

# All that the headers use of OpenCL's: handles, which are pointers.
CL = "".join(f"typedef struct {name} *{name};" for name in ("cl_context", "cl_command_queue", "cl_device_id", "cl_mem"))

BASIC: dict[str, Any] = {
    "float": ctypes.c_float,
    "double": ctypes.c_double,
    "int": ctypes.c_int,
    "int32_t": ctypes.c_int32,
    "uint32_t": ctypes.c_uint32,
    "uint64_t": ctypes.c_uint64,
    "size_t": ctypes.c_size_t,
    "char": ctypes.c_char,
    "TynStatus": ctypes.c_int32,
    "void": None,
}  # fmt: skip


@dataclass
class Declarations:
    """What the headers declare. Types are ctypes', but for records and callbacks, which are names."""

    constants: dict[str, int] = field(default_factory=dict)
    records: dict[str, list[tuple[str, Any]]] = field(default_factory=dict)
    callbacks: dict[str, tuple[Any, list[Any]]] = field(default_factory=dict)
    functions: dict[str, tuple[Any, list[Any]]] = field(default_factory=dict)
    initializers: dict[str, str] = field(default_factory=dict)
    """The record that each inline function makes."""


@dataclass(frozen=True)
class Pointer:
    """A pointer to a record, a number or another pointer."""

    to: Any


@dataclass(frozen=True)
class Vector:
    """An array in a record."""

    of: Any
    length: int


def preprocessed(folder: Path) -> str:
    """The headers without comments and macros; GCC's extensions of them removed."""
    fake = pytest.importorskip("pycparser_fake_libc").directory
    (folder / "CL").mkdir(exist_ok=True)
    (folder / "CL/cl.h").write_text(CL)
    source = "".join(f"#include <tyndall/{header}>\n" for header in HEADERS)
    command = [compiler(), "-E", "-nostdinc", "-D__attribute__(x)=", "-DINFINITY=1e999", f"-I{fake}", f"-I{folder}"]
    return run([*command, f"-I{INCLUDE}", "-x", "c", "-"], source)


def compiler() -> str:
    path = shutil.which("cc")
    if path is None:
        pytest.skip("there is no C compiler")
    return path


def run(command: list[str], source: str = "") -> str:
    return subprocess.run(command, input=source, text=True, capture_output=True, check=True).stdout


def parse(text: str) -> Declarations:
    c_parser = pytest.importorskip("pycparser.c_parser")
    found = Declarations()
    for node in c_parser.CParser().parse(text).ext:
        _take(node, found)
    return found


def _take(node: Any, found: Declarations) -> None:
    from pycparser import c_ast

    if isinstance(node, c_ast.FuncDef) and node.decl.name.startswith("tyn_"):
        found.initializers[node.decl.name] = _type(node.decl.type.type)
    elif isinstance(node, c_ast.Typedef) and node.name.startswith("Tyn"):
        target = node.type
        if isinstance(target, c_ast.PtrDecl):
            found.callbacks[node.name] = _signature(target.type)
        elif isinstance(target.type, c_ast.Struct):
            found.records[node.name] = [(one.name, _type(one.type)) for one in target.type.decls or []]
    elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.Enum):
        value = -1
        for one in node.type.values.enumerators:
            value = value + 1 if one.value is None else int(one.value.value, 0)
            found.constants[one.name] = value
    elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl) and node.name.startswith("tyn_"):
        found.functions[node.name] = _signature(node.type)


def _signature(function: Any) -> tuple[Any, list[Any]]:
    arguments = [_type(one.type) for one in function.args.params] if function.args else []
    return _type(function.type), [_decayed(one) for one in arguments if one is not None]


def _decayed(kind: Any) -> Any:
    return Pointer(kind.of) if isinstance(kind, Vector) else kind


def _type(node: Any) -> Any:
    from pycparser import c_ast

    if isinstance(node, c_ast.TypeDecl):
        return _type(node.type)
    if isinstance(node, c_ast.IdentifierType):
        name = " ".join(node.names)
        if name.startswith("cl_"):
            return ctypes.c_void_p
        return BASIC[name] if name in BASIC else name
    if isinstance(node, c_ast.ArrayDecl):
        return Vector(_type(node.type), int(node.dim.value, 0))
    assert isinstance(node, c_ast.PtrDecl)
    target = _type(node.type)
    return {ctypes.c_char: ctypes.c_char_p, None: ctypes.c_void_p}.get(target, Pointer(target))


def macros(header: str) -> dict[str, int]:
    """The numbers that a header defines."""
    text = (INCLUDE / "tyndall" / header).read_text()
    return {name: int(value, 0) for name, value in re.findall(r"#define (TYN_\w+) (0x[0-9a-f]+|\d+)u?\b", text)}


def layout(records: dict[str, list[tuple[str, Any]]], initializers: dict[str, str], folder: Path) -> str:
    """What the C compiler says: "Record size", "Record.field offset size", "initializer bytes in hexadecimal"."""
    lines = []
    for record, fields in records.items():
        if fields:
            lines.append(f'printf("{record} %zu\\n", sizeof({record}));')
        for name, _ in fields:
            where = f"offsetof({record}, {name}), sizeof((({record} *)0)->{name})"
            lines.append(f'printf("{record}.{name} %zu %zu\\n", {where});')
    for function, record in initializers.items():
        lines.append(f'{{ {record} r = {function}(); dump("{function}", &r, sizeof r); }}')
    source = "#include <stdio.h>\n" + "".join(f"#include <tyndall/{header}>\n" for header in HEADERS)
    source += (
        """
    static void dump(const char *name, const void *data, size_t size) {
      printf("%s ", name);
      for (size_t i = 0; i < size; ++i) printf("%02x", ((const unsigned char *)data)[i]);
      printf("\\n");
    }
    int main(void) {"""
        + "\n".join(lines)
        + "return 0; }"
    )
    (folder / "CL").mkdir(exist_ok=True)
    (folder / "CL/cl.h").write_text(CL)
    program = folder / "layout"
    run([compiler(), "-std=c11", f"-I{folder}", f"-I{INCLUDE}", "-x", "c", "-", "-o", str(program)], source)
    return run([str(program)])
