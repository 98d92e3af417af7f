# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall.capi against the C headers: every constant, record, field, initializer and signature."""

from __future__ import annotations

import ast
import ctypes
from pathlib import Path
from typing import Any

import c_headers
import pytest
from c_headers import Declarations, Pointer, Vector

import tyndall
from tyndall import capi
from tyndall.capi import library, tyndall_io

pytestmark = pytest.mark.skipif(not c_headers.INCLUDE.exists(), reason="the C headers are not here")


@pytest.fixture(scope="module")
def declared(tmp_path_factory: pytest.TempPathFactory) -> Declarations:
    return c_headers.parse(c_headers.preprocessed(tmp_path_factory.mktemp("headers")))


def ctypes_of(kind: Any) -> Any:
    """The ctypes type that stands for a declared one."""
    if isinstance(kind, Pointer):
        return ctypes.POINTER(ctypes_of(kind.to))
    if isinstance(kind, Vector):
        return ctypes_of(kind.of) * kind.length
    return getattr(capi, kind) if isinstance(kind, str) else kind


def signatures() -> dict[str, Any]:
    tables = [header.FUNCTIONS for header in (*library._HEADERS, tyndall_io)]
    return {name: signature for table in tables for name, signature in table.items()}


def test_constants(declared: Declarations) -> None:
    expected = dict(declared.constants)
    for header in ("tyndall_base.h", "tyndall_types.h"):
        expected.update(c_headers.macros(header))
    expected["TYN_VERSION"] = capi.lib.tyn_version()
    assert {"TYN_NONE", "TYN_VERSION_MAJOR", "TYN_ERROR_INTERNAL", "TYN_LAYER_VARIANCE"} < set(expected)
    actual = {name: value for name, value in vars(capi).items() if name.startswith("TYN_")}
    assert actual == expected


def test_functions(declared: Declarations) -> None:
    actual = signatures()
    assert set(actual) == set(declared.functions)
    assert len(actual) > 90
    for name, (result, arguments) in declared.functions.items():
        assert actual[name][0] == ctypes_of(result), name
        assert list(actual[name][1]) == [ctypes_of(one) for one in arguments], name


def test_callbacks(declared: Declarations) -> None:
    assert set(declared.callbacks) == {"TynProgress", "TynWarning"}
    for name, (result, arguments) in declared.callbacks.items():
        kind = getattr(capi, name)
        assert kind._restype_ == ctypes_of(result), name
        assert list(kind._argtypes_) == [ctypes_of(one) for one in arguments], name


def test_records_have_the_declared_fields(declared: Declarations) -> None:
    records = {name: kind for name, kind in vars(capi).items() if isinstance(kind, type) and name.startswith("Tyn")}
    structures = {name for name, kind in records.items() if issubclass(kind, ctypes.Structure)}
    assert structures == set(declared.records)
    for name, fields in declared.records.items():
        actual = getattr(records[name], "_fields_", [])
        assert [(one[0], one[1]) for one in actual] == [(field, ctypes_of(kind)) for field, kind in fields], name


def test_layout_and_initializers(declared: Declarations, tmp_path: Path) -> None:
    says = c_headers.layout(declared.records, declared.initializers, tmp_path).splitlines()
    initialized = 0
    for line in says:
        what, *numbers = line.split()
        if what.startswith("tyn_"):
            record = getattr(capi, declared.initializers[what])()
            assert bytes(record).hex() == numbers[0], what
            initialized += 1
        elif "." in what:
            record_name, field = what.split(".")
            place = getattr(getattr(capi, record_name), field)
            assert [place.offset, place.size] == [int(one) for one in numbers], what
        else:
            assert ctypes.sizeof(getattr(capi, what)) == int(numbers[0]), what
    assert initialized == len(declared.initializers) > 15


def test_records_without_an_initializer_begin_as_zeros_and_their_size(declared: Declarations) -> None:
    for name in set(declared.records) - set(declared.initializers.values()):
        kind = getattr(capi, name)
        if hasattr(kind, "_fields_"):
            expected = kind.from_buffer(bytearray(ctypes.sizeof(kind)))
            if kind._fields_[0][0] == "size":
                expected.size = ctypes.sizeof(kind)
            assert bytes(kind()) == bytes(expected), name


def test_the_library_has_every_function() -> None:
    for name in signatures():
        function = getattr(capi.io if name in tyndall_io.FUNCTIONS else capi.lib, name)
        assert ctypes.cast(function, ctypes.c_void_p).value


# What Python's own ownership and tables of names stand in for, or what only libraries built on this one need.
RAW_ONLY = {
    "tyn_bssrdf_find_model",
    "tyn_bssrdf_retain",
    "tyn_context_fail",
    "tyn_context_retain",
    "tyn_renderer_retain",
    "tyn_renderer_scene",
    "tyn_scene_context",
    "tyn_scene_retain",
    "tyn_slab_quantity_name",
    "tyn_slab_result_retain",
}


def test_the_package_uses_every_function() -> None:
    used = set()
    for path in Path(tyndall.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Attribute) and node.attr.startswith("tyn_"):
                used.add(node.attr)
    assert used == set(signatures()) - RAW_ONLY


@pytest.mark.parametrize(
    ("fields", "error"),
    [
        ({"seed": -1}, ValueError),
        ({"seed": 1 << 64}, ValueError),
        ({"max_order": 1 << 32}, ValueError),
        ({"max_order": 1.5}, ValueError),
        ({"max_order": "1"}, ValueError),
        ({"max_order": None}, ValueError),
        ({"photon": 1}, AttributeError),
        ({"angle": "steep"}, TypeError),
    ],
)
def test_a_record_takes_what_its_fields_hold(fields: dict[str, Any], error: type[Exception]) -> None:
    with pytest.raises(error):
        capi.TynSlabOptions(**fields)


def test_a_record_names_the_field() -> None:
    with pytest.raises(tyndall.errors.InvalidArgumentError, match="max_order is -1; it must be an integer in"):
        capi.TynSlabOptions(max_order=-1)


def test_a_string_field_keeps_its_text() -> None:
    assert capi.TynMedium(name="Müsli").name.decode() == "Müsli"
