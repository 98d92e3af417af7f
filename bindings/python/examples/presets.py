# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""A sheet of samples: the same knobbly thing of every measured medium, lit from the side and behind.

What does each preset look like, and how translucent is it at the size of a thumb? There are no diffuse colours here: all light
walks, leaks through the knobs, and comes to the front where the body is not thicker than light gets. Below each stand the
diffusion lengths in red, green and blue. Change SIZE: the same medium is wax as a bead and chalk as a statue.
"""

import matplotlib.pyplot as plt
import numpy as np

import tyndall as ty

SIZE = 20.0  # mm
PIXELS, SAMPLES = 104, 9  # more samples, less noise and more time
LIGHT = (0.84, -0.5, 0.21)  # the direction it travels in, of unit length

ball, triangles = ty.shapes.sphere(1.0, subdivisions=5)
knobs = np.prod(np.sin(4.2 * ball + [0.5, 1.1, 0.0]), axis=1)
positions = 0.46 * SIZE * ball * (1 + 0.3 * knobs[:, None])
camera = ty.Camera.look_at(SIZE * np.array([0.3, 0.9, 2.0]), (0, 0, 0), yfov=0.55)


def soft(pixels, sigma):
    """Blurred: walks of so few samples are noisy, mostly in colour, which the eye sees less sharply than brightness."""
    kernel = np.exp(-0.5 * (np.arange(-2 * sigma, 2 * sigma + 1) / sigma) ** 2)
    for axis in (0, 1):
        pixels = np.apply_along_axis(np.convolve, axis, pixels, kernel / kernel.sum(), "same")
    return np.maximum(pixels, 1e-6)


context = ty.Context()
figure, grid = plt.subplots(3, 4, figsize=(11, 9), layout="constrained", facecolor="#15161a")
for name, axes in zip(ty.Medium.presets(), grid.flat):
    medium = ty.Medium.preset(name)
    surface = ty.Material(transmission=1, ior=medium.ior, roughness=0.35)  # all that gets in walks
    scene = context.scene(metres_per_unit=1e-3)
    scene.add_mesh(positions, triangles, normals=np.zeros_like(positions), medium=medium, material=surface)
    scene.add_light(ty.Light(type="directional", direction=LIGHT, intensity=5.0))
    scene.set_environment(ty.Environment(radiance=0.06, hidden_from_camera=True))
    scene.commit()
    image = context.render(scene, width=PIXELS, height=PIXELS, spp=SAMPLES, camera=camera, layers=["beauty"])
    color, alpha = image.beauty[..., :3], image.beauty[..., 3:]
    light = color.mean(axis=-1, keepdims=True)
    color = soft(color, 5) / soft(light, 5) * soft(light, 1.5) / soft(alpha, 1.5)
    axes.imshow(np.dstack([np.clip(color, 0, 1) ** (1 / 2.2), alpha]), interpolation="bicubic")
    length = "   ".join(f"{one:.2g}" for one in medium.describe().diffusion_length_mm).replace("inf", "∞")
    axes.set_title(name, color="white", fontsize=14, y=0.98)
    axes.text(0.5, 0.0, f"{length} mm", color="0.65", ha="center", transform=axes.transAxes)
    axes.set_axis_off()
    walks = image.stats.ledger
    print(
        f"{name:11} {walks.walks} walks, {walks.scatterings / walks.walks:6.1f} scatterings each, {walks.leaked_walks} leaked"
    )
figure.savefig("presets.png", dpi=110)
print("wrote presets.png")
