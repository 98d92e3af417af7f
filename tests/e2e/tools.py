# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What the end-to-end tests share: running a tool, tiny models, and looking into the images it wrote."""
import json
import os
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest

BIN = os.environ.get("TYNDALL_BIN_DIR", "build/demo/bin")


def path_of(tool):
    return os.path.join(BIN, tool)


def run(tool, *arguments, env=None, timeout=120, **options):
    """Runs a tool to its end; the result has returncode, stdout and stderr."""
    full_env = dict(os.environ, **(env or {}))
    return subprocess.run([path_of(tool), *map(str, arguments)], capture_output=True, text=True,
                          env=full_env, timeout=timeout, **options)


class ToolTest(unittest.TestCase):
    """A test with a folder of its own, gone afterwards."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="tyndall-e2e-")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as out:
            out.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def check_fails(self, result, code, *words):
        """The exit status, one line that names the tool and holds every word, and nothing on standard output."""
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        lines = [line for line in result.stderr.splitlines() if ": warning: " not in line]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertRegex(lines[0], r"^tyndall-[a-z-]+: .")
        for word in words:
            self.assertIn(word, lines[0])

    def check_succeeds(self, result):
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def start(self, tool, *arguments, env=None):
        """A tool that runs, at most until the test ends."""
        process = subprocess.Popen([path_of(tool), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True, env=dict(os.environ, **(env or {})))
        self.addCleanup(process.kill)
        return process

    def interrupt(self, tool, *arguments):
        """Lets a tool run for three seconds, then interrupts it; the JSON report that it prints all the same."""
        process = self.start(tool, *arguments)
        time.sleep(3)
        self.assertIsNone(process.poll(), "it ended by itself")
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, errors)
        report = json.loads(output)
        self.assertTrue(report["interrupted"])
        return report


# ---- models ----

CUBE_CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
CUBE_TRIANGLES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4),
                  (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]

SKIN_LIKE = {
    "KHR_materials_transmission": {"transmissionFactor": 1},
    "KHR_materials_ior": {"ior": 1.3},
    "KHR_materials_volume": {"thicknessFactor": 0.001, "attenuationDistance": 0.001,
                             "attenuationColor": [0.46, 0.35, 0.23]},
    "KHR_materials_scatter": {"scatterStrengthFactor": 1, "multiscatterColorFactor": [0.6, 0.4, 0.3]},
}


def cube_document(half=0.01, triangles=CUBE_TRIANGLES, extensions=None, lights=(), cameras=()):
    """A cube as a glTF document and its binary chunk."""
    positions = b"".join(struct.pack("<3f", *(half * c for c in corner)) for corner in CUBE_CORNERS)
    indices = b"".join(struct.pack("<3H", *t) for t in triangles)
    binary = positions + indices
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "cube"}],
        "meshes": [{"name": "cube", "primitives": [
            {"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "body", "pbrMetallicRoughness": {
            "metallicFactor": 0, "roughnessFactor": 0.5}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
             "min": [-half] * 3, "max": [half] * 3},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(triangles), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)}],
        "buffers": [{"byteLength": len(binary)}]}
    if extensions:
        document["materials"][0]["extensions"] = extensions
        document["extensionsUsed"] = sorted(extensions)
    for i, name in enumerate(cameras):
        document.setdefault("cameras", []).append(
            {"name": name, "type": "perspective", "perspective": {
                "yfov": 0.5, "aspectRatio": 1.5, "znear": 0.001}})
        add_node(document, {"camera": i, "translation": [0, 0, 0.08 + 0.02 * i]})
    for i, light in enumerate(lights):
        document.setdefault("extensionsUsed", []).append("KHR_lights_punctual")
        root = document.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})
        root["lights"].append(light)
        add_node(document, {"extensions": {"KHR_lights_punctual": {"light": i}},
                            "translation": [0.03, 0.04, 0.05]})
    return document, binary


def add_node(document, node):
    document["nodes"].append(node)
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)


def glb(document, binary):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    size = 28 + len(text) + len(binary)
    return (struct.pack("<4sII", b"glTF", 2, size) + struct.pack("<I4s", len(text), b"JSON") + text +
            struct.pack("<I4s", len(binary), b"BIN\0") + binary)


def cube(**options):
    """A GLB of a cube; options as in cube_document."""
    return glb(*cube_document(**options))


# ---- images ----

def read_exr(path):
    """The attributes of a scanline OpenEXR file, name -> (type, value), and its compressed pixels. Strings are decoded,
    the channels are a list of names."""
    with open(path, "rb") as file:
        data = file.read()
    magic, _version = struct.unpack_from("<II", data)
    if magic != 20000630:
        raise ValueError(path + " is not OpenEXR")
    at = 8
    attributes = {}

    def text():
        nonlocal at
        end = data.index(b"\0", at)
        result = data[at:end].decode()
        at = end + 1
        return result

    while data[at] != 0:
        name, kind = text(), text()
        size, = struct.unpack_from("<I", data, at)
        value = data[at + 4:at + 4 + size]
        at += 4 + size
        if kind == "string":
            value = value.decode()
        elif kind == "chlist":
            value = list(channel_names(value))
        elif kind == "box2i":
            value = struct.unpack("<4i", value)
        attributes[name] = (kind, value)
    lines_in_chunk = {0: 1, 1: 1, 2: 1, 3: 16}[attributes["compression"][1][0]]
    _, first, _, last = attributes["dataWindow"][1]
    chunks = (last - first) // lines_in_chunk + 1
    return attributes, data[at + 1 + 8 * chunks:]  # a table of offsets comes first


def exr_header(path):
    return read_exr(path)[0]


def channel_names(data):
    at = 0
    while data[at] != 0:
        end = data.index(b"\0", at)
        yield data[at:end].decode()
        at = end + 1 + 16


def exr_size(path):
    x0, y0, x1, y1 = exr_header(path)["dataWindow"][1]
    return x1 - x0 + 1, y1 - y0 + 1


def png_size(path):
    with open(path, "rb") as file:
        data = file.read(24)
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(path + " is not PNG")
    return struct.unpack(">II", data[16:24])
