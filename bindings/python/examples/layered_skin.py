# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Why skin has its colour, and how deep light gets: epidermis, dermis and fat in the slab engine, at 26 wavelengths at once.

Melanin takes most of the blue, blood takes the green, and red light that gets past both comes back from deep below. Curves have
the colours of the skins. They are exact, by adding and doubling; the dots on them are walks, with error bars.
Sources: melanin and bloodless skin, S. L. Jacques, "Skin optics", Oregon Medical Laser Center News, Jan 1998; blood, S. Prahl's
table, omlc.org/spectra/hemoglobin; scattering, S. L. Jacques, Phys. Med. Biol. 58 (2013) R37, table 2.
Simplified: fat absorbs like bloodless skin, and all layers have one index of refraction.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

import tyndall as ty

MELANOSOMES = {"dark skin": 0.30, "tanned skin": 0.12, "light skin": 0.03}  # volume fraction in the epidermis
BLOOD, OXYGENATION = 0.002, 0.67  # volume fraction in the dermis, and the part of its haemoglobin that carries oxygen
EPIDERMIS, DERMIS = 0.06, 1.5  # thickness, mm; what follows is fat
NM = np.arange(450, 701, 10)  # wavelengths, and extinction of haemoglobin at them with and without oxygen, 1/(cm mol/l)
OXY = "62816 44480 33209 26629 23684 20933 20035 24202 39957 53236 43016 32613 44496 50104 14401 3200 1506 942 610 442 368 320 "
DEOXY = "103292 23389 16156 14550 16684 20862 25774 31590 39036 46592 53412 53788 45072 37020 28324 14677 9444 6510 5149 4345 "
OXY, DEOXY = (np.array(text.split(), float) for text in (OXY + "294 278 276 290", DEOXY + "3750 3227 2795 2408 2052 1794"))

bloodless = 0.0244 + 8.53 * np.exp(-(NM - 154) / 66.2)  # absorption, 1/mm; below, blood has 150 g/l at 64500 g/mol
blood = np.log(10) * (OXYGENATION * OXY + (1 - OXYGENATION) * DEOXY) * 150 / 64500 / 10
skin, fat = 46 * (NM / 500) ** -1.421, 18.4 * (NM / 500) ** -0.672  # sigma_s = sigma_s' / (1 - g), 1/mm
dermis = ty.Layer(ty.Medium(BLOOD * blood + (1 - BLOOD) * bloodless, skin, g=0.9, ior=1.4), DERMIS)

context = ty.Context()
figure, (left, middle, right) = plt.subplots(1, 3, figsize=(16, 5), layout="constrained")
for name, part in MELANOSOMES.items():
    melanin = ty.Medium(part * 6.6e10 * NM**-3.33 + (1 - part) * bloodless, skin, g=0.9, ior=1.4)
    layers = [ty.Layer(melanin, EPIDERMIS), dermis, ty.Layer(ty.Medium(bloodless, fat, g=0.9, ior=1.4))]
    run, exact = context.slab(layers, photons=1.5e4, depth=(3.0, 600)), ty.adding_doubling(layers, tolerance=1e-4)
    # without what the surface reflects like a mirror
    walks, solved = run.reflectance.diffuse, exact.reflectance - exact.specular_reflectance
    color = np.array(walks[[16, 10, 1]]) ** (1 / 2.2)  # its red, green and blue are those at 610, 550 and 460 nm
    left.plot(NM, solved, color=color, linewidth=9, label=name)
    left.errorbar(NM, walks, 2 * walks.stderr, fmt=".", color="black", markersize=3, linewidth=1)
    for at in (10, 20):
        print(f"{name:12} at {NM[at]} nm: {walks[at]:.4f} ± {walks.stderr[at]:.4f}, by adding and doubling {solved[at]:.4f}")
heat = middle.pcolormesh(NM, run.depth.centers, run.depth.absorbed, norm=LogNorm(), cmap="inferno", shading="nearest")
figure.colorbar(heat, ax=middle, label="part of the light that is absorbed, per depth (1/mm)")
colors = ("#f2cf7a", "#c8453b", "#8a5a3c", "#e3ebf5")
names = ("fat", "dermis", "epidermis", "comes back")
right.stackplot(NM, *run.layer_absorbed[::-1], run.reflectance.total, colors=colors)
for depth, text in zip((2.2, 0.3, 0.02), names):
    middle.text(460, depth, text, color="white" if depth > 0.1 else "black")
for height, text in zip((0.06, 0.22, 0.42, 0.78), names):
    right.text(645, height, text, ha="center")
left.set(ylim=(0, None), ylabel="diffuse reflectance", title="Exact, and by walks ± 2 standard errors")
middle.set(yscale="log", ylim=(3, 0.005), ylabel="depth (mm)", title=f"Where {name} absorbs")
right.set(xlim=NM[[0, -1]], ylim=(0, 1), ylabel="part of the light", title=f"Where light goes in {name}")
left.legend(frameon=False)
figure.supxlabel("wavelength (nm)")
figure.savefig("layered_skin.png", dpi=110)
print("wrote layered_skin.png")
