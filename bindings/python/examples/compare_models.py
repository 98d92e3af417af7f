# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Which BSSRDF model can I trust, and where? Every model of the library for one medium, beside exact transport.

A BSSRDF model replaces walks by a formula, R(r): what comes out at a distance r from where light went in. The left picture
shows the curves, the right one how far each is off exact transport, in percent, with the error band of the exact curve itself.
Change the medium to yours before you choose a model for a renderer, or believe a measurement that was fitted with one.
"""

import matplotlib.pyplot as plt
import numpy as np

import tyndall as ty

MEDIUM = ty.Medium(0.05, 5.0, g=0.8, ior=1.4, name="a skin-like medium", metres_per_unit=1e-3)  # sigma_a, sigma_s: 1/mm
RADII = np.geomspace(0.02, 12, 120)  # mm
WIDTHS = np.geomspace(0.05, 5, 8)  # mm, standard deviations of the sum of Gaussians

context = ty.Context()
# By default the table of "exact" is made of 1.5e9 scattering events, which takes some seconds; it is kept on disk.
exact = context.bssrdf("exact", MEDIUM, exact_events=300_000_000)
truth, error = exact.profile(RADII)[:, 0], exact.profile_error(RADII)[:, 0]

# "gaussians" is whatever sum you bring. This one is fitted to the exact curve by multiplicative steps, which stay positive.
shapes = np.exp(-(RADII[:, None] ** 2) / (2 * WIDTHS**2)) / (2 * np.pi * WIDTHS**2) / truth[:, None]
weights = np.full(len(WIDTHS), 0.01)
for _ in range(2000):
    weights *= shapes.sum(axis=0) / (shapes.T @ (shapes @ weights))
sums = {"gaussian_weights": weights, "gaussian_variances": WIDTHS**2}
names = [name for name in ty.bssrdf_models() if name != "exact"]
models = {name: context.bssrdf(name, MEDIUM, **(sums if name == "gaussians" else {})) for name in names}

figure, (left, right) = plt.subplots(1, 2, figsize=(13, 5.6), layout="constrained")
ty.plot.profile({**models, "exact": exact}, radii=RADII, ax=left)
print(f"{'model':24}{'albedo':>8}{'against exact':>15}{'R(1 mm) against exact':>24}")
for line, (name, model) in zip(left.get_lines(), {**models, "exact": exact}.items()):
    if name == "exact":
        line.set(color="black", linewidth=2.8)
    line.set_linestyle(":" if name == "multipole" else "-")  # which is, of a half-space, the standard dipole
    off = 100 * (model.profile(RADII)[:, 0] / truth - 1)
    right.plot(RADII, off, color=line.get_color(), linewidth=line.get_linewidth(), linestyle=line.get_linestyle())
    at_1mm = 100 * (model.profile(1.0)[0] / exact.profile(1.0)[0] - 1)
    print(f"{name:24}{model.albedo[0]:8.4f}{100 * (model.albedo[0] / exact.albedo[0] - 1):+13.1f} %{at_1mm:+22.1f} %")
left.legend(frameon=False, loc="lower left")  # again, in the colours that they have now
left.set_title(f"What comes out of {MEDIUM.name}")
band = 200 * error / truth
right.fill_between(RADII, -band, band, color="black", alpha=0.22, linewidth=0, label="two standard errors of exact")
right.set(xscale="log", xlim=RADII[[0, -1]], ylim=(-100, 100), title="How far each model is off", xlabel="distance r (mm)")
right.set_ylabel("deviation from exact transport (%)")
right.grid(color="#e4e4e4")
right.legend(frameon=False, loc="upper right")
figure.savefig("compare_models.png", dpi=120)
print("wrote compare_models.png")
