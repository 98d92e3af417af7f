#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Writes bssrdf-models.md: what each BSSRDF model assumes, and its measured error against exact transport.

  docs/make_bssrdf_page.py BIN_DIR [--photons N] [--output FILE] [--g G,...] [--ior N,...]

BIN_DIR holds tyndall-profile, which measures all that is in the tables. Two to four minutes on two cores. A model without a
text here, or one that nothing is measured of, is an error: a new model comes with both.
"""
import argparse
import json
import math
import os
import re
import statistics
import subprocess
import sys

ALBEDOS = (0.3, 0.7, 0.9, 0.99, 0.999)  # reduced
RADII = (0.1, 1, 10)  # reduced mean free paths; of the rings below, whose borders are a factor of 10^(1/12) away
RINGS = "0.1:10:13"
SLAB = 5  # thickness in reduced mean free paths
STACK = ((0.9, 0.99), (0.99, 0.9), (0.99, 0.99))  # reduced albedos of the upper and the lower layer
SEED = 1000  # far from those of the walks that the exact model's tables are made of
COMMAND = "docs/make_bssrdf_page.py"

# What a model assumes: from the heads of lib/bssrdf/*.cpp and from tyndall_bssrdf.h. In the order of the page.
TEXTS = {
    "exact": """\
Nothing but a flat surface and a half-space of one medium: single scattering in closed form, all else counted from
walks of the slab engine in a white half-space, which answer for every albedo (a walk of n scatterings counts
albedo^n). Totals are those of adding and doubling. The walks are counted when a phase function and an index of
refraction are first asked for, some seconds each, and kept in the cache's folder. It also knows the distribution of
angles that light leaves along. Its tables are estimates and have standard errors (tyn_bssrdf_profile_error), which
are not part of those below.""",
    "standard-dipole": """\
Jensen, Marschner, Levoy, Hanrahan 2001, "A Practical Model for Subsurface Light Transport": diffusion from a point
source one reduced mean free path below the surface, and a negative image of it above, so that the fluence vanishes on
an extrapolated boundary. The source holds all light; single scattering is not apart. Anisotropy enters by similarity,
sigma_s' = sigma_s (1 - g), in this and all models of diffusion.""",
    "better-dipole": """\
d'Eon 2012, "A Better Dipole": the same two sources, but with Grosjean's diffusion coefficient, which is right near
the source and where much is absorbed, and the exitance computed from both fluence and flux. Light that was scattered
once only is not in it.""",
    "quantized-diffusion": """\
d'Eon & Irving 2011, "A Quantized-Diffusion Model for Rendering Translucent Materials": Grosjean's diffusion and the
better dipole's boundary, from a source that is all of the beam; the light of each interval of time is one Gaussian.
With more Gaussians than the paper's, since what is evaluated is a table of their sum. Light that was scattered once
only is not in it.""",
    "photon-beam-diffusion": """\
Habel, Christensen, Jarosz 2013, "Photon Beam Diffusion: A Hybrid Monte Carlo Method for Subsurface Scattering": a
better dipole at every depth of the refracted beam, each taken back near the beam by an empirical factor, and single
scattering exactly.""",
    "normalized-diffusion": """\
Christensen & Burley 2015, "Approximate Reflectance Profiles for Efficient Subsurface Scattering": two exponentials
that integrate to the surface's albedo, which is computed by adding and doubling; their width is a fit to Monte Carlo
profiles of isotropic, index-matched half-spaces. Measured is the fit for a searchlight (there are two others: --fit).
Elsewhere the albedo stays exact and the shape does not.""",
    "directional-dipole": """\
Frisvad, Hachisuka, Kjeldsen 2014, "Directional Dipole Model for Subsurface Scattering": the source is a ray in an
infinite medium, whose diffusion keeps the direction of the refracted light, and its image in a plane that is turned
towards the point where light leaves. Measured is its exitance for light that arrives perpendicularly at a flat
surface; what it is for, light that arrives at a slant, is not in these numbers. The source has the power of all light
that gets in, so there is too much of it where little is absorbed, and where little is scattered; their separate term
for light that is only scattered forward is not in it.""",
    "single-scattering": """\
The source term of Hanrahan & Krueger 1993, "Reflection from Layered Surfaces due to Subsurface Scattering": exact for
light that is scattered once, with the medium's own phase function; none for light that is scattered twice or more,
which is nearly all of it in the media that subsurface scattering is about. A part of other models, and a check.""",
    "multipole": """\
Donner & Jensen 2005, "Light Diffusion in Multi-Layered Translucent Materials": the standard dipole's source, mirrored
again and again in the extrapolated boundaries on both sides of a slab; slabs are put together to stacks by their
spatial frequencies. Layers are thicker than a reduced mean free path. A multipole of a half-space is the standard
dipole, so slabs and stacks are measured here, what comes back from them (R) and what goes through (T).""",
    "gaussians": """\
Sums of Gaussians as d'Eon, Luebke, Enderton 2007, "Efficient Rendering of Human Skin", fit to profiles for
texture-space and screen-space subsurface scattering. Weights and variances are the caller's and the medium does not
matter, so there is nothing to measure.""",
}


class Failed(Exception):
    pass


# ---- measuring ----

class Profile:
    """tyndall-profile with the options that all runs share."""

    def __init__(self, folder, photons):
        self.path = os.path.join(folder, "tyndall-profile")
        self.photons = photons

    def call(self, *arguments):
        try:
            return subprocess.run([self.path, *map(str, arguments)], capture_output=True, text=True, check=False)
        except OSError as error:
            raise Failed(f"{self.path}: {error.strerror}") from error

    def models(self):
        """All of its models: those that it says it knows when it is asked for none of them."""
        found = re.search(r"all, or of (.*)", self.call("--model", "?").stderr)
        if not found:
            raise Failed(f"{self.path} --model ?: a list of models was expected")
        return found.group(1).strip().split(", ")

    def version(self):
        return self.call("--version").stdout.strip()

    def measure(self, *medium):
        print(f"{COMMAND}: {' '.join(map(str, medium))}", file=sys.stderr)
        result = self.call(*medium, "--radii", RINGS, "--error", "--photons", self.photons, "--seed", SEED, "--json", "-q")
        if result.returncode:
            raise Failed(result.stderr.strip())
        return json.loads(result.stdout)


def listed(values, separator=","):
    return separator.join(f"{value:.12g}" for value in values)


def half_space(g, ior):
    """One reduced mean free path is 1, a channel for each of ALBEDOS."""
    return ("--sigma-a", listed(1 - a for a in ALBEDOS), "--sigma-s", listed(a / (1 - g) for a in ALBEDOS),
            "--g", f"{g:g}", "--ior", f"{ior:g}")


def slab(g, ior):
    return (*half_space(g, ior), "--thickness", SLAB)


def stack(g, ior):
    """Two reduced mean free paths of one medium on four of another, twice as dense."""
    layers = []
    for index, density in enumerate((1, 2)):
        sigma_a = listed((density * (1 - pair[index]) for pair in STACK), "/")
        sigma_s = listed((density * pair[index] / (1 - g) for pair in STACK), "/")
        layers += ["--layer", f"{sigma_a},{sigma_s},{g:g},{ior:g},2"]
    return layers


class Row:
    """A medium's names, and of its total and its R at RADII (value, standard error), or None where that is not known."""

    def __init__(self, names, estimates):
        self.names = names
        self.estimates = estimates


def rows_of(reports, names, part):
    """A row for each channel of each report; `part` gives what of a report is wanted: curves, total, and their names."""
    rows = []
    for medium, report in reports:
        curves, name, total, total_name = part(report)
        rings = [min(range(len(report["radii"])), key=lambda i, r=radius: abs(math.log(report["radii"][i] / r)))
                 for radius in RADII]
        for channel, channel_names in enumerate(names):
            pairs = [(total[total_name][channel], total["standard_error"][channel])]
            pairs += [(curves[name][channel][ring], curves["standard_error"][channel][ring]) for ring in rings]
            rows.append(Row((*channel_names, *medium), [None if None in pair else pair for pair in pairs]))
    return rows


def exact_rows(reports, names):
    return rows_of(reports, names, lambda report: (report["exact"], "profile", report["exact"]["albedo"], "value"))


def model_rows(reports, names, model):
    def part(report):
        error = report["models"][model]["error"]
        return error, "relative", error["albedo"], "relative"
    return rows_of(reports, names, part)


# ---- tables ----

def table(head, rows):
    """Markdown that is a table as text, too; the first columns are left as they are, numbers end flush."""
    widths = [max(len(row[i]) for row in (head, *rows)) for i in range(len(head))]

    def line(row):
        return "| " + " | ".join(cell.rjust(width) for cell, width in zip(row, widths)) + " |"

    rule = "|" + "|".join("-" * (width + 1) + ":" for width in widths) + "|"
    return "\n".join([line(head), rule, *map(line, rows)])


def percent(pair):
    """A deviation and its standard error, with two digits of the latter."""
    if pair is None:
        return "-"
    value, error = (100 * number for number in pair)
    digits = min(max(1 - math.floor(math.log10(error)), 0), 2) if error > 0 else 2
    text = f"{value:+.{digits}f}"
    return f"{text} ± {error:.{digits}f}" if float(f"{error:.{digits}f}") else text


def amount(pair):
    if pair is None:
        return "-"
    value, error = pair
    return f"{value:.4g} ± {100 * error / value:.2g} %"


def radius_names(letter):
    return [f"{letter}({radius})" for radius in RADII]


def media_table(columns, total, letter, rows, cell):
    head = [*columns, total, *radius_names(letter)]
    return table(head, [[*(f"{name:g}" for name in row.names), *map(cell, row.estimates)] for row in rows])


def typical_and_worst(rows, column):
    """The median and the largest of the absolute deviations, in percent."""
    sizes = [abs(100 * row.estimates[column][0]) for row in rows if row.estimates[column] is not None]
    return [rounded(statistics.median(sizes)), rounded(max(sizes))] if sizes else ["-", "-"]


def rounded(number):
    return f"{number:.2g}" if number < 10 else f"{number:.0f}"


def summary_table(entries):
    """`entries`: name -> rows."""
    head = ["model", "albedo", "worst"]
    for name in radius_names("R"):
        head += [name, "worst"]
    lines = []
    for name, rows in entries.items():
        line = [name]
        for column in range(1 + len(RADII)):
            line += typical_and_worst(rows, column)
        lines.append(line)
    return table(head, lines)


def in_standard_errors(rows):
    """Of every deviation in `rows`: over its standard error."""
    return [pair[0] / pair[1] for row in rows for pair in row.estimates if pair is not None and pair[1] > 0]


# ---- the page ----

class Page:
    """All measurements, and the texts around them."""

    def __init__(self, profile, arguments):
        self.profile = profile
        self.arguments = arguments
        self.models = profile.models()
        media = [(g, ior) for g in arguments.g for ior in arguments.ior]
        multipole = ("--model", "multipole")
        self.half_spaces = [(medium, profile.measure("--model", "all", *half_space(*medium))) for medium in media]
        self.check_models()
        self.finite = {}  # rows of the multipole by heading
        for name, layers, channels in (("slab", slab, ALBEDOS), ("two layers", stack, STACK)):
            names = [channel if isinstance(channel, tuple) else (channel,) for channel in channels]
            for letter, option in (("R", ()), ("T", ("--transmitted",))):
                reports = [(medium, profile.measure(*multipole, *layers(*medium), *option)) for medium in media]
                self.finite[name, letter] = model_rows(reports, names, "multipole")

    def check_models(self):
        """None is forgotten, here or there."""
        measured = {"gaussians", *self.half_spaces[0][1]["models"]}
        for model in self.models:
            if model not in TEXTS:
                raise Failed(f"{model} is a model without a text: add it to TEXTS")
            if model not in measured:
                raise Failed(f"{model} is a model that takes no half-space: it has to be measured in another way")
        for model in TEXTS:
            if model not in self.models:
                raise Failed(f"{model} has a text, but is no model")

    def rows(self, model):
        return model_rows(self.half_spaces, [(albedo,) for albedo in ALBEDOS], model)

    def text(self):
        parts = [self.head(), self.summary(), self.exact_values()]
        for model in TEXTS:
            parts += [f"## {model}", TEXTS[model]]
            if model == "multipole":
                parts += self.multipole_tables()
            elif model != "gaussians":
                parts.append(media_table(["alpha'", "g", "ior"], "albedo", "R", self.rows(model), percent))
            if model == "exact":
                parts.append(self.check_of_exact())
        return "\n\n".join(parts) + "\n"

    def head(self):
        photons = f"{self.half_spaces[0][1]['exact']['photons']:,}"
        return f"""# Models of the BSSRDF, and how far they are off

Made by `{COMMAND} {self.arguments.shown}` with {self.profile.version()}: {photons} photons
followed in every medium.

Models give R(r), the light that leaves at a distance r from where light gets in perpendicularly, and the albedo, its integral.
Here they are compared with exact transport in the very same medium (tyndall-slab's photons, boundary and phase function
included) over the reduced albedo alpha' = sigma_s' / (sigma_a + sigma_s'), sigma_s' = sigma_s (1 - g), the mean cosine g of the
Henyey-Greenstein phase function and the index of refraction. Lengths are in reduced mean free paths, 1 / (sigma_a + sigma_s').
R is a mean over a ring from 0.83 to 1.21 times the radius. Deviations are model / exact - 1, in percent, and behind them stands
the standard error that they have from the exact value's; where that is not known to 30 % there is none (-). Surfaces are flat:
what models do on other shapes is not in these numbers."""

    def summary(self):
        entries = {model: self.rows(model) for model in TEXTS if model not in ("multipole", "gaussians")}
        for (name, letter), rows in self.finite.items():
            entries[f"multipole, {name}, {letter}"] = rows
        return f"""## Summary

Absolute deviations in percent, median and worst, of the albedo and of R at 0.1, 1 and 10 reduced mean free paths, over
{self.range()}.
The worst is that of one medium, and where little light is left, as at 10 where much is absorbed, part of it is noise: the
tables below have the standard errors. T is what goes through.

{summary_table(entries)}"""

    def range(self):
        return (f"alpha' = {listed(ALBEDOS, ', ')}, g = {listed(self.arguments.g, ', ')} and "
                f"ior = {listed(self.arguments.ior, ', ')}")

    def exact_values(self):
        rows = exact_rows(self.half_spaces, [(albedo,) for albedo in ALBEDOS])
        return f"""## Exact transport

What all half-spaces are compared with, R in 1/length^2, with relative standard errors.

{media_table(["alpha'", "g", "ior"], "albedo", "R", rows, amount)}"""

    def check_of_exact(self):
        errors = in_standard_errors(self.rows("exact"))
        beyond = sum(abs(error) > 2 for error in errors)
        return (f"Of these {len(errors)} deviations {beyond} are beyond 2 standard errors (of independent ones 1 in 22 by "
                f"chance; those of one\ng and ior are related), the largest is {max(map(abs, errors)):.1f}.")

    def multipole_tables(self):
        titles = {
            ("slab", "R"): f"A slab {SLAB} reduced mean free paths thick, what comes back:",
            ("slab", "T"): "What goes through it:",
            ("two layers", "R"): "Two layers: 2 reduced mean free paths of one medium on 4 of another one, twice as dense.\n"
                                 "Lengths are in reduced mean free paths of the upper one; what comes back:",
            ("two layers", "T"): "What goes through them:"}
        parts = []
        for key, rows in self.finite.items():
            columns = ["alpha'", "g", "ior"] if key[0] == "slab" else ["alpha' above", "below", "g", "ior"]
            total = "albedo" if key[1] == "R" else "total"
            parts += [titles[key], media_table(columns, total, key[1], rows, percent)]
        return parts


def numbers(text):
    return [float(word) for word in text.split(",")]


def parse_arguments():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="BIN_DIR", help="where tyndall-profile is")
    parser.add_argument("--photons", default="4e6", metavar="N", help="in each medium (4e6)")
    parser.add_argument("--output", default=os.path.join(here, "bssrdf-models.md"), metavar="FILE",
                        help="(bssrdf-models.md beside this script)")
    parser.add_argument("--g", type=numbers, default=[0, 0.8], metavar="G,...", help="mean cosines (0,0.8)")
    parser.add_argument("--ior", type=numbers, default=[1, 1.4], metavar="N,...", help="indices of refraction (1,1.4)")
    arguments = parser.parse_args()
    arguments.shown = f"BIN_DIR --photons {arguments.photons}"
    return arguments


def main():
    arguments = parse_arguments()
    try:
        text = Page(Profile(arguments.folder, arguments.photons), arguments).text()
        with open(arguments.output, "w", encoding="utf-8") as out:
            out.write(text)
    except (Failed, OSError) as error:
        print(f"{COMMAND}: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
