# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""A million walks from one point of a white ball, three times: how far they go, where they leave, and along what.

The media differ a hundredfold in how much they scatter, and yet the mean path is the same, 4 V / S, and light leaves by the
cosine law by which it came in (Blanco, Fournier 2003; in a ball one point stands for all). Code that misses these is wrong.
"""

import matplotlib.pyplot as plt
import numpy as np

import tyndall as ty

RADIUS, WALKS = 10.0, 1_000_000  # mm
MEAN_FREE_PATHS = {100: "#d9822b", 10: "#2c8a46", 1: "#2a5fc4"}  # mm, and the colours of their curves
LENGTHS, ANGLES, COSINES = np.geomspace(0.1, 500, 80), np.linspace(0, np.pi, 61), np.linspace(0, 1, 41)

context = ty.Context()
positions, triangles = ty.shapes.sphere(RADIUS, subdivisions=5)
top = int(positions[triangles, 1].mean(axis=1).argmax())
entry = positions[triangles[top]].mean(axis=0)
entries = ty.walk_entries(np.broadcast_to(entry, (WALKS, 3)), kind="cosine", triangle=top)


def histogram(axes, values, edges, sizes, color, label=None):
    counts = np.histogram(values, edges)[0]
    axes.stairs(counts / WALKS / sizes, edges, baseline=None, color=color, linewidth=1.8, label=label)
    error = 2 * np.sqrt(counts) / WALKS / sizes  # two standard errors
    axes.errorbar((edges[1:] + edges[:-1]) / 2, counts / WALKS / sizes, error, fmt="none", color=color, linewidth=1)


figure, ((paths, length), (place, angle)) = plt.subplots(2, 2, figsize=(12, 10), layout="constrained")
for mean_free_path, color in MEAN_FREE_PATHS.items():
    scene = context.scene(metres_per_unit=1e-3)
    scene.add_mesh(positions, triangles, medium=ty.Medium(0.0, 1 / mean_free_path, metres_per_unit=1e-3))
    scene.commit()
    exits = context.walk(scene, entries)
    walked, ledger, mesh = exits["path_length"], exits.ledger, scene.mesh_info(0)
    error, expected = walked.std() / WALKS**0.5, 4 * mesh.volume / mesh.area
    print(f"mean free path {mean_free_path} mm: mean path {walked.mean():.3f} ± {error:.3f} mm, 4 V / S = {expected:.3f} mm")
    print(f"  entered {ledger.entered[0]:.0f}, escaped {ledger.escaped[0]:.0f}, lost {ledger.lost[0]:.0f}", end="")
    print(f", {ledger.scatterings / WALKS:.2f} scatterings each")
    directions = exits["position"] / np.linalg.norm(exits["position"], axis=1, keepdims=True)
    away = np.arccos(np.clip(directions @ entry / np.linalg.norm(entry), -1, 1))
    histogram(length, walked, LENGTHS, np.diff(LENGTHS), color, f"mean free path {mean_free_path} mm")
    histogram(place, away, ANGLES, 2 * np.pi * -np.diff(np.cos(ANGLES)), color)
    histogram(angle, np.sum(exits["direction"] * exits["geometric_normal"], axis=1), COSINES, np.diff(COSINES), color)
    if mean_free_path == 10:
        ty.plot.walk(scene, entries[:16], mesh=ty.shapes.sphere(RADIUS, 3), view="xy", ax=paths).set_title("Sixteen of them")
length.axvline(expected, color="black", linestyle="--", label="4 V / S, the mean of each")
place.axhline(1 / (4 * np.pi), color="black", linestyle="--", label="1 / 4π, without scattering")
angle.plot(COSINES, 2 * COSINES, color="black", linestyle="--", label="2 µ, the cosine law")
length.set(xscale="log", yscale="log", title="How far", xlabel="length of the path (mm)", ylabel="part of the walks per mm")
place.set(yscale="log", title="Where", xlabel="angle from the entry, from the centre (rad)", ylabel="part of the walks per sr")
angle.set(title="Along what", xlabel="cosine µ to the normal", ylabel="part of the walks per µ")
for axes in (length, place, angle):
    axes.legend(frameon=False)
figure.savefig("walk_histogram.png", dpi=110)
print("wrote walk_histogram.png")
