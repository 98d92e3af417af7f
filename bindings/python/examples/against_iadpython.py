# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Can I believe these numbers? Reflectance and transmittance of slabs, by three codes that share nothing.

The slab engine walks photons and says how far off it may be; adding_doubling solves the same equations without chance; and
iadpython (Scott Prahl; pip install iadpython) is somebody else's adding-doubling. The lower row shows what is between them;
dots of one colour rise and fall together, as all channels of a run are walked with the same random numbers.
"""

import sys

import matplotlib.pyplot as plt
import numpy as np

import tyndall as ty

try:
    import iadpython
except ImportError:
    print("skipped: there is no iadpython to compare with (pip install iadpython)")
    sys.exit(0)

ABSORBED = np.geomspace(0.9, 0.003, 13)  # 1 - albedo
THICKNESSES = {0.5: "#d9822b", 2.0: "#2c8a46", 8.0: "#2a5fc4"}  # in mean free paths, and the colours of their curves
RING = {"linestyle": "", "marker": "o", "color": "black", "markersize": 9, "markerfacecolor": "none"}
G, IOR = 0.8, 1.4

context = ty.Context()
medium = ty.Medium.from_albedo(1 - ABSORBED, mean_free_path=1.0, g=G, ior=IOR)  # a channel for each albedo
figure, grid = plt.subplots(2, 2, figsize=(12, 8), sharex=True, layout="constrained", gridspec_kw={"height_ratios": (3, 2)})
worst, deviations = 0.0, []
for number, (thickness, color) in enumerate(THICKNESSES.items()):
    layer = ty.Layer(medium, thickness)
    run, exact = context.slab(layer, photons=3e5), ty.adding_doubling(layer)
    samples = [iadpython.Sample(a=albedo, b=thickness, g=G, n=IOR, quad_pts=32).rt()[:2] for albedo in medium.albedo]
    estimates, solutions = (run.reflectance.total, run.transmittance.total), (exact.reflectance, exact.transmittance)
    for (above, below), estimate, solution, theirs in zip(grid.T, estimates, solutions, np.array(samples, float).T):
        above.plot(ABSORBED, solution, color=color, label=f"{thickness:g} mean free paths thick")
        above.plot(ABSORBED, theirs, **RING)
        above.errorbar(ABSORBED, estimate, 2 * estimate.stderr, fmt="o", color=color, markersize=4)
        off, error = 1e3 * (estimate - solution), 1e3 * estimate.stderr
        below.errorbar(ABSORBED * 1.08 ** (number - 1), off, 2 * error, fmt="o", color=color, markersize=4, linewidth=1.2)
        below.plot(ABSORBED, 1e3 * (theirs - solution), **RING)
        worst = max(worst, np.abs(theirs - solution).max())
        deviations += list(off / error)
print(f"iadpython - adding_doubling: at most {worst:.1e}")
print(f"slab engine - adding_doubling: {np.sqrt(np.mean(np.square(deviations))):.2f} standard errors, root mean square")
grid[0, 0].plot([], [], label="iadpython", **RING)
grid[0, 0].plot([], [], "o", color="0.4", markersize=4, label="slab engine ± 2 standard errors")
grid[0, 0].legend(frameon=False, title="lines: adding_doubling", loc="upper left")
grid[0, 0].set(xscale="log", xlim=(1.1, 0.0025), ylabel="reflectance R", title="Three codes")
grid[0, 1].set(ylabel="transmittance T", title=f"g = {G}, index of refraction {IOR}")
grid[1, 0].set(xlabel="1 - albedo", ylabel="R - R of adding_doubling (0.001)")
grid[1, 1].set(xlabel="1 - albedo", ylabel="T - T of adding_doubling (0.001)")
figure.savefig("against_iadpython.png", dpi=110)
print("wrote against_iadpython.png")
