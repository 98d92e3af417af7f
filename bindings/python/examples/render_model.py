# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Renders a glTF model (render_model.py model.glb) or a candle that is made here, and takes the picture apart into its layers.

Nothing but the flame lights the candle: what glows is wax, by light that walked through it. The OpenEXR file holds all layers,
so that glow and gloss can be graded apart: beauty = subsurface + specular + diffuse + emission.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import tyndall as ty

WIDTH, HEIGHT, SAMPLES = 220, 220, 72
CANDLE = [(0, 0), (18, 0), (19, 1), (19, 44), (18.5, 46), (17.3, 46.4), (15, 44.6), (9, 43), (0, 42.5)]  # radius, height in mm
FLAME = [(0, 51), (2.4, 53), (3.4, 56.5), (2.8, 61), (1.4, 66), (0, 71)]
WICK, TABLE = [(0, 43), (0.8, 43), (0.8, 52), (0, 52)], [(0, -5), (68, -5), (68, 0), (0, 0)]


def turned(outline, sides=64):
    """The mesh of what a lathe makes: an outline of radius and height, turned about the y axis."""
    radius, height = np.array(outline, float).T[..., None]
    angle = 2 * np.pi * np.arange(sides) / sides
    rings = np.stack(np.broadcast_arrays(radius * np.sin(angle), height, radius * np.cos(angle)), axis=-1)
    here = np.arange((len(outline) - 1) * sides).reshape(-1, sides)
    beside = np.roll(here, -1, axis=1)
    triangles = np.stack([here, beside, beside + sides, here, beside + sides, here + sides], axis=-1)
    return rings.reshape(-1, 3), triangles.reshape(-1, 3)


def candle(context):
    # One mean free path (2 mm) for all colours: three different ones would look alike here, with far more noise.
    wax = ty.Medium.from_color((0.95, 0.80, 0.55), 2.0, ior=1.45, metres_per_unit=1e-3)
    scene = context.scene(metres_per_unit=1e-3)
    scene.add_mesh(*turned(CANDLE), medium=wax, material=ty.Material(transmission=1, ior=1.45, roughness=0.4))
    scene.add_mesh(*turned(FLAME), material=ty.Material(base_color=0, emission=(75.0, 44.0, 17.0)))
    scene.add_mesh(*turned(WICK), material=ty.Material(base_color=0.02))
    scene.add_mesh(*turned(TABLE), material=ty.Material(base_color=(0.03, 0.02, 0.015), roughness=0.25))
    scene.set_environment(ty.Environment(radiance=(0.02, 0.03, 0.05)))
    scene.add_camera(ty.Camera.look_at((0, 100, 240), (0, 29, 0), yfov=0.4))
    scene.commit()
    return scene


context = ty.Context()
scene = context.load(sys.argv[1], environment=0.3) if sys.argv[1:] else candle(context)
image = context.render(scene, width=WIDTH, height=HEIGHT, spp=SAMPLES)
ty.write_exr("render_model.exr", image)
figure = plt.figure(figsize=(14, 6.3), layout="constrained")
grid = figure.add_gridspec(2, 5)
ty.plot.image(image, tone="aces", ax=figure.add_subplot(grid[:, :2])).set_title("beauty")
for place, layer in enumerate(("subsurface", "specular", "diffuse", "emission", "normal", "depth")):
    ty.plot.image(image, layer, tone="aces", ax=figure.add_subplot(grid[place // 3, 2 + place % 3])).set_title(layer)
figure.savefig("render_model.png", dpi=110)
print(f"{image.stats.seconds:.1f} s; walks leaked {image.stats.ledger.leaked_walks}, lost {image.stats.ledger.lost_walks}")
print("wrote render_model.exr and render_model.png")
