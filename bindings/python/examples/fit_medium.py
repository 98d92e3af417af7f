# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What is this stuff made of? Fits absorption and reduced scattering of a medium to a measured reflectance R(r).

The "measurement" is made here, so that the answer is known: the slab engine walks photons at given coefficients, and a detector
adds three percent of noise. A fit with "exact" finds the coefficients again, within the uncertainties that it states. Fits with
formulas of diffusion look nearly as good, and find another medium: what one fits with decides what one measures.
"""

import matplotlib.pyplot as plt
import numpy as np
from scipy.optimize import curve_fit

import tyndall as ty

TRUTH = np.array([0.05, 1.0])  # sigma_a and sigma_s' = sigma_s (1 - g), 1/mm
G, IOR, NOISE = 0.8, 1.4, 0.03
MODELS = {"exact": "black", "photon-beam-diffusion": "#2a5fc4", "standard-dipole": "#d9822b"}
# diff_step: profiles are in single precision, derivatives of them need longer steps than usual
OPTIONS = {"p0": (0.02, 2.0), "bounds": (1e-3, 10), "diff_step": 1e-3, "absolute_sigma": True}
CIRCLE = np.array([np.cos(np.linspace(0, 2 * np.pi, 100)), np.sin(np.linspace(0, 2 * np.pi, 100))])

context = ty.Context()
run = context.slab(ty.Medium(TRUTH[0], TRUTH[1] / (1 - G), g=G, ior=IOR), photons=1e6, radial=(8.0, 40))
r, edges = run.radial.centers[2:], run.radial.edges[2:]  # the detector stays 0.4 mm away from the beam
clean = run.radial.reflectance[2:, 0]
measured = clean * np.random.default_rng(1).normal(1, NOISE, len(r))
sigma = np.hypot(clean.stderr, NOISE * clean)
points = np.linspace(edges[:-1], edges[1:], 9)  # in each ring, over which a detector takes the mean
entering = 1 - run.reflectance.specular[0]  # the profile of a model is per power that gets in


def reflectance(name, sigma_a, reduced):
    # "exact" makes a table when a g and an index are first asked for; then it answers for all coefficients at once.
    medium = ty.Medium(sigma_a, reduced / (1 - G), g=G, ior=IOR)
    with context.bssrdf(name, medium, exact_events=300_000_000) as model:
        return entering * np.average(model.profile(points)[..., 0], axis=0, weights=points)


figure, (left, right) = plt.subplots(1, 2, figsize=(12, 5.2), layout="constrained", gridspec_kw={"width_ratios": (1.25, 1)})
left.errorbar(r, measured, 2 * sigma, fmt="o", color="0.55", markersize=3.5, label="measured, two standard deviations")
print(f"{'':24}{'sigma_a (1/mm)':>20}{'sigma_s_prime (1/mm)':>24}{'chi2 per point':>16}")
print(f"{'true':24}{TRUTH[0]:10.4f}{TRUTH[1]:22.4f}")
for name, color in MODELS.items():
    found, covariance = curve_fit(reflectance, name, measured, sigma=sigma, **OPTIONS)
    error, fitted = np.sqrt(np.diag(covariance)), reflectance(name, *found)
    print(f"{name:24}{found[0]:10.4f} ±{error[0]:7.4f}{found[1]:13.4f} ±{error[1]:7.4f}", end="")
    print(f"{np.mean(((measured - fitted) / sigma) ** 2):14.2f}")
    left.plot(r, fitted, color=color, label=name)
    for deviations in (1, 2):
        ellipse = found[:, None] + deviations * np.linalg.cholesky(covariance) @ CIRCLE
        right.fill(*ellipse, color=color, alpha=0.35, linewidth=0, label=name if deviations == 1 else None)
right.plot(*TRUTH, "*", color="#c8352b", markersize=13, label="truth", zorder=3)
left.set(yscale="log", xlabel="distance r (mm)", ylabel="R (1/mm²)", title="Three fits to one measurement ...")
right.set(xlabel="$\\sigma_a$ (1/mm)", ylabel="$\\sigma_s'$ (1/mm)", title="... and the media that they find")
left.legend(frameon=False)
right.legend(frameon=False, title="one and two standard deviations")
figure.savefig("fit_medium.png", dpi=120)
print("wrote fit_medium.png")
