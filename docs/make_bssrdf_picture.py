#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Makes bssrdf.png: a hand and a candle with light walked through them, and with every BSSRDF model in place of the walks.

  docs/make_bssrdf_picture.py BIN_DIR [--spp N] [--output FILE] [--keep FOLDER]

BIN_DIR holds tyndall-render and tyndall-demo-scene. Needs Pillow (python3-pil). Some thirteen minutes on two cores. The
seconds on a tile are processor time, which other programs on the machine do not change much, of all samples but the first,
and so without loading and without preparing profiles and tables. tyndall-render's own figures go to standard error.
"""
import argparse
import json
import math
import os
import re
import resource
import struct
import subprocess
import sys
import tempfile

from PIL import Image, ImageChops, ImageDraw, ImageFilter, ImageFont

COLUMNS = 4
TILE = (400, 320)
GAP, LABEL = 2, 28
FROM, AT, HEIGHT_OF_VIEW = (-1.5, 15.0, 58.0), (0.7, 11.6, 1.0), 13.0  # cm, cm, degrees
DIFFERENCES = ("exact", "standard-dipole")
FULL_SCALE = 64  # of 255 display levels: the difference that has the full colour
BACKGROUND, INK, FAINT_INK = (22, 22, 24), (235, 235, 235), (150, 150, 155)
POSITIVE, NEGATIVE, NEUTRAL = (214, 60, 40), (50, 100, 220), (236, 236, 236)


# ---- the scene ----

def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add_camera(path, name):
    """A view close to the hand, as one more camera of the GLB."""
    with open(path, "rb") as file:
        data = file.read()
    size, = struct.unpack_from("<I", data, 12)
    document, rest = json.loads(data[20:20 + size]), data[20 + size:]
    back = unit([a - b for a, b in zip(FROM, AT)])
    right = unit(cross([0, 1, 0], back))
    matrix = [*right, 0, *cross(back, right), 0, *back, 0, *(0.01 * x for x in FROM), 1]
    lens = {"yfov": math.radians(HEIGHT_OF_VIEW), "aspectRatio": TILE[0] / TILE[1], "znear": 0.001}
    document["cameras"].append({"name": name, "type": "perspective", "perspective": lens})
    document["nodes"].append({"name": name, "camera": len(document["cameras"]) - 1, "matrix": matrix})
    document["scenes"][0]["nodes"].append(len(document["nodes"]) - 1)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text + rest)


# ---- rendering ----

class Renderer:
    def __init__(self, folder, scene, samples, exposure):
        self.folder, self.scene = folder, scene
        self.samples, self.exposure = samples, exposure

    def tool(self, *arguments):
        path = os.path.join(self.folder, "tyndall-render")
        return subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, check=False)

    def models(self):
        """All that it says it knows when it is asked for none of them."""
        found = re.search(r"expected one of (.*)", self.tool(self.scene, "-o", "x.exr", "--bssrdf", "?").stderr)
        if not found:
            raise SystemExit("tyndall-render --bssrdf ?: a list of models was expected")
        return found.group(1).strip().split(", ")

    def render(self, png, model, samples):
        result = self.tool(self.scene, "-o", png[:-4] + ".exr", "--png", png, "--camera", "close", "--width", TILE[0],
                           "--height", TILE[1], "--spp", samples, "--tone", "aces", "--exposure", self.exposure, "--json",
                           "-q", *(("--bssrdf", model) if model else ()))
        if result.returncode:
            raise SystemExit(result.stderr.strip())
        return json.loads(result.stdout)["seconds"]

    def timed(self, png, model):
        """The processor's seconds for all samples but the first. What is kept in caches is made before."""
        self.render(png, model, 1)
        start = processor_seconds()
        once = self.render(png, model, 1)
        middle = processor_seconds()
        seconds = self.render(png, model, self.samples)
        busy = processor_seconds() - middle - (middle - start)
        print(f"{model or 'walks'}: {busy:.1f} s of processor time; {seconds:.1f} s by the clock, {once:.1f} s for one sample",
              file=sys.stderr)
        return busy


def processor_seconds():
    """Of all programs that were run and have ended."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


# ---- the picture ----

def font(size):
    try:
        return ImageFont.truetype("DejaVuSans.ttf", size)
    except OSError:
        return ImageFont.load_default()


def difference(image, reference):
    """What is shown, less what the walks show, smoothed by two pixels: red is brighter, blue darker."""
    smooth = [one.convert("L").filter(ImageFilter.GaussianBlur(2)) for one in (image, reference)]
    grey = ImageChops.subtract(*smooth, scale=FULL_SCALE / 127, offset=128)

    def ramp(channel):
        table = []
        for level in range(256):
            share = (level - 128) / 127
            end = POSITIVE if share > 0 else NEGATIVE
            table.append(round(NEUTRAL[channel] + min(abs(share), 1) * (end[channel] - NEUTRAL[channel])))
        return table

    return Image.merge("RGB", [grey.point(ramp(channel)) for channel in range(3)])


def grid(tiles, note):
    """`tiles`: (image, name, what stands behind it)."""
    rows = -(-len(tiles) // COLUMNS)
    width, height = TILE[0] + GAP, TILE[1] + LABEL + GAP
    sheet = Image.new("RGB", (COLUMNS * width - GAP, rows * height + LABEL), BACKGROUND)
    draw = ImageDraw.Draw(sheet)
    for index, (image, name, remark) in enumerate(tiles):
        x, y = index % COLUMNS * width, index // COLUMNS * height
        sheet.paste(image, (x, y + LABEL))
        draw.text((x + 8, y + 5), name, INK, font(16))
        draw.text((x + TILE[0] - 8 - draw.textlength(remark, font(14)), y + 7), remark, FAINT_INK, font(14))
    draw.text((8, rows * height + 5), note, FAINT_INK, font(14))
    return sheet


def save(sheet, path):
    """With 256 colours, for a third of the size; dithered, or hues would shift by more than models differ."""
    palette = sheet.quantize(256, Image.Quantize.MAXCOVERAGE, kmeans=4)
    sheet.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG).save(path, optimize=True)


def picture(renderer, folder):
    images, tiles = {}, []
    models = sorted(renderer.models(), key=lambda model: model != "exact")  # beside the walks
    for model in [None, *models]:
        name = model or "walks"
        png = os.path.join(folder, name + ".png")
        seconds = renderer.timed(png, model)
        images[name] = Image.open(png).convert("RGB")
        tiles.append((images[name], name, f"{seconds:.0f} s"))
    for name in DIFFERENCES:
        tiles.append((difference(images[name], images["walks"]), f"{name} - walks", "red: brighter, blue: darker"))
    note = (f"{renderer.samples} samples a pixel. Seconds of processor time for rendering, without what is prepared once. "
            f"Differences are of what is shown, full colour at {FULL_SCALE} of 255 levels.")
    return grid(tiles, note)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="BIN_DIR", help="where the tools are")
    parser.add_argument("--spp", type=int, default=96, metavar="N", help="samples a pixel (96)")
    parser.add_argument("--exposure", type=float, default=0.4, metavar="STOPS", help="(0.4)")
    parser.add_argument("--output", default=os.path.join(here, "bssrdf.png"), metavar="FILE",
                        help="(bssrdf.png beside this script)")
    parser.add_argument("--keep", metavar="FOLDER", help="keep the single images there")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = arguments.keep or scratch
        os.makedirs(folder, exist_ok=True)
        scene = os.path.join(folder, "demo.glb")
        subprocess.run([os.path.join(arguments.folder, "tyndall-demo-scene"), scene], check=True, stdout=subprocess.DEVNULL)
        add_camera(scene, "close")
        sheet = picture(Renderer(arguments.folder, scene, arguments.spp, arguments.exposure), folder)
    save(sheet, arguments.output)


if __name__ == "__main__":
    main()
