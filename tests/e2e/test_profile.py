# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall-profile: closed forms, what exact transport says of the models, and every kind of output."""
import csv
import json
import math
import os
import signal
import unittest

from tools import ToolTest, png_size, run

MEDIUM = ("--sigma-a", 0.01, "--sigma-s", 0.99)
HALF_SPACE_MODELS = ["standard-dipole", "better-dipole", "photon-beam-diffusion", "multipole", "normalized-diffusion",
                     "single-scattering", "quantized-diffusion", "directional-dipole", "exact"]


def standard_dipole(sigma_a, sigma_s, g, ior, radius):
    """R(r) and albedo of Jensen et al. 2001, equations 4 and 15."""
    reduced = sigma_s * (1 - g)
    extinction = sigma_a + reduced
    albedo = reduced / extinction
    tr = math.sqrt(3 * sigma_a * extinction)
    fresnel = -1.440 / ior**2 + 0.710 / ior + 0.668 + 0.0636 * ior
    boundary = (1 + fresnel) / (1 - fresnel)
    real = 1 / extinction
    virtual = real * (1 + 4 / 3 * boundary)
    profile = 0
    for depth in (real, virtual):
        d = math.hypot(radius, depth)
        profile += depth * (1 + tr * d) * math.exp(-tr * d) / d**3
    root = math.sqrt(3 * (1 - albedo))
    total = albedo / 2 * (1 + math.exp(-4 / 3 * boundary * root)) * math.exp(-root)
    return albedo / (4 * math.pi) * profile, total


def mean_of_gaussian(variance, inner, outer):
    power = math.exp(-inner**2 / (2 * variance)) - math.exp(-outer**2 / (2 * variance))
    return power / (math.pi * (outer**2 - inner**2))


class Profile(ToolTest):
    def report(self, *arguments):
        result = self.check_succeeds(run("tyndall-profile", *arguments, "--json", "-q"))
        self.assertEqual(result.stderr, "")
        return json.loads(result.stdout)

    # ---- values ----

    def test_the_standard_dipole_is_the_published_formula(self):
        for sigma_a, sigma_s, g, ior in ((0.01, 1, 0, 1), (0.3, 20, 0.9, 1.4), (2, 1, -0.5, 1.2)):
            report = self.report("--model", "standard-dipole", "--sigma-a", sigma_a, "--sigma-s", sigma_s, "--g", g,
                                 "--ior", ior, "--radii", "0.003:30:50")
            self.assertEqual(len(report["radii"]), 50)
            self.assertAlmostEqual(report["radii"][0], 0.003, places=12)
            self.assertEqual(report["radii"][-1], 30)
            dipole = report["models"]["standard-dipole"]
            self.assertEqual((len(dipole["profile"]), len(dipole["albedo"])), (1, 1))
            for radius, value in zip(report["radii"], dipole["profile"][0]):
                exact, albedo = standard_dipole(sigma_a, sigma_s, g, ior, radius)
                self.assertAlmostEqual(value, exact, delta=1e-5 * exact + 1e-37)
            self.assertAlmostEqual(dipole["albedo"][0], albedo, places=6)

    def test_profiles_add_up_to_their_albedo(self):
        report = self.report(*MEDIUM, "--ior", 1.3, "--radii", "1e-4:300:1000", "--gaussians", "0.3:0.1,0.2:4")
        radii = report["radii"]
        step = math.log(radii[1] / radii[0])
        self.assertEqual(list(report["models"]), HALF_SPACE_MODELS[:5] + ["gaussians"] + HALF_SPACE_MODELS[5:])
        for name, model in report["models"].items():
            with self.subTest(model=name):
                total = sum(2 * math.pi * r * r * value for r, value in zip(radii, model["profile"][0])) * step
                self.assertAlmostEqual(total, model["albedo"][0], delta=2e-3)

    def test_models_that_take_the_layer(self):
        self.assertEqual(list(self.report(*MEDIUM)["models"]), HALF_SPACE_MODELS)
        slab = self.report(*MEDIUM, "--thickness", 2, "--radii", "0.1:5:9")
        self.assertEqual(list(slab["models"]), ["multipole", "single-scattering"])
        self.assertEqual((slab["medium"]["thickness"], slab["transmitted"]), (2, False))
        through = self.report(*MEDIUM, "--thickness", 2, "--radii", "0.1:5:9", "--transmitted")
        self.assertEqual(list(through["models"]), ["multipole"])
        both = slab["models"]["multipole"]["albedo"][0] + through["models"]["multipole"]["albedo"][0]
        self.assertTrue(0.8 < both < 1, both)
        named = self.report(*MEDIUM, "--model", "multipole,better-dipole")
        self.assertEqual(list(named["models"]), ["multipole", "better-dipole"])
        said = self.check_succeeds(run("tyndall-profile", *MEDIUM, "--thickness", 2, "--radii", "0.1:5:9")).stderr.splitlines()
        self.assertEqual([line.split()[1] for line in said],
                         [model for model in HALF_SPACE_MODELS if model not in ("multipole", "single-scattering")])
        for line in said:
            self.assertRegex(line, r"^tyndall-profile: \S+ is left out: --thickness is 2; .* it must be inf$")
        forward = run("tyndall-profile", *MEDIUM, "--g", 0.9995, "--radii", "0.1:5:9")
        self.assertRegex(self.check_succeeds(forward).stderr, r"^tyndall-profile: exact is left out: .* at most 0.999\n$")
        white = self.report("--sigma-a", 0, "--sigma-s", 1, "--model", "better-dipole")
        self.assertAlmostEqual(white["models"]["better-dipole"]["albedo"][0], 1, places=6)

    def test_several_layers(self):
        # Of white layers each adds 1 / T - 1 to the stack's; T of one by the distances to its extrapolated boundaries.
        fresnel = -1.440 + 0.710 + 0.668 + 0.0636
        beyond = 2 / 3 * (1 + fresnel) / (1 - fresnel)
        one = [(1 + beyond) / (thickness + 2 * beyond) for thickness in (3, 5)]
        through = 1 / (1 / one[0] + 1 / one[1] - 1)
        layers = ("--layer", "0,1,0,1,3", "--layer", "0,4,0.5,1,2.5")
        back, transmitted = self.report(*layers), self.report(*layers, "--transmitted")
        for report, expected in ((back, 1 - through), (transmitted, through)):
            self.assertEqual(list(report["models"]), ["multipole"])
            self.assertAlmostEqual(report["models"]["multipole"]["albedo"][0], expected, delta=1e-4)
        self.assertEqual([layer["thickness"] for layer in back["medium"]["layers"]], [3, 2.5])
        self.assertEqual(back["medium"]["layers"][1]["g"], 0.5)
        self.assertNotIn("sigma_a", back["medium"])
        self.assertAlmostEqual(back["radii"][-1], 20)

    def test_layers_far_from_the_beam_are_nearly_exact(self):
        report = self.report("--layer", "0.3,30,0.8,1.4,0.3", "--layer", "0.03,10,0.8,1.4,inf", "--radii", "2:6:4",
                             "--error", "--photons", "3e5")
        error = report["models"]["multipole"]["error"]
        for relative, deviation in zip(error["relative"][0], error["standard_error"][0]):
            self.assertLess(abs(relative), 0.04 + 4 * deviation)  # 4 sigma: 1 in 4000 for all four

    def test_the_fits_of_normalized_diffusion_differ(self):
        albedos, values = [], []
        for fit in ("searchlight", "diffuse", "dmfp"):
            model = self.report(*MEDIUM, "--model", "normalized-diffusion", "--fit", fit, "--radii", "1:2:2")
            albedos.append(model["models"]["normalized-diffusion"]["albedo"][0])
            values.append(model["models"]["normalized-diffusion"]["profile"][0][0])
        self.assertEqual(albedos[0], albedos[2])
        self.assertGreater(albedos[1], albedos[0])
        self.assertEqual(len(set(values)), 3)

    def test_channels(self):
        report = self.report("--sigma-a", "0.1,1", "--sigma-s", "1,1", "--radii", "0.1:1:4")
        for sigma_a, channel in ((0.1, 0), (1, 1)):
            alone = self.report("--sigma-a", sigma_a, "--sigma-s", 1, "--radii", "0.1:1:4")
            for name, model in alone["models"].items():
                self.assertEqual(model["profile"][0], report["models"][name]["profile"][channel])
                self.assertEqual(model["albedo"][0], report["models"][name]["albedo"][channel])
        skin = self.report("--medium", "skin1", "--radii", "0.1:1:4")
        self.assertEqual((skin["medium"]["name"], skin["medium"]["channels"]), ("skin1", ["R", "G", "B"]))
        self.assertEqual(len(skin["models"]["multipole"]["profile"]), 3)

    def test_the_default_radii_follow_the_longest_reduced_mean_free_path(self):
        radii = self.report("--sigma-a", "1,0.1", "--sigma-s", "1,4", "--g", 0.9)["radii"]
        self.assertEqual(len(radii), 60)
        self.assertAlmostEqual(radii[0], 0.01 / 0.5, places=12)
        self.assertAlmostEqual(radii[-1], 20 / 0.5, places=9)

    # ---- against exact transport ----

    def test_single_scattering_is_exact_where_little_scatters(self):
        # What is scattered twice or more adds some half percent of the albedo here, which is 0.01.
        report = self.report("--sigma-a", 0.99, "--sigma-s", 0.01, "--ior", 1.4, "--model", "single-scattering",
                             "--radii", "0.05:1.5:8", "--error", "--photons", 4e6)
        error = report["models"]["single-scattering"]["error"]
        for relative, deviation in zip(error["relative"][0], error["standard_error"][0]):
            self.assertLess(deviation, 0.1)
            self.assertLess(abs(relative + 0.01), 4 * deviation + 0.015)
        albedo = error["albedo"]
        self.assertLess(abs(albedo["relative"][0] + 0.005), 4 * albedo["standard_error"][0] + 0.01)

    def test_dipoles_are_near_far_away_only(self):
        report = self.report(*MEDIUM, "--error", "--radii", "0.05:16:24")
        radii = report["radii"]
        better = report["models"]["better-dipole"]["error"]["relative"][0]
        # A point one mean free path deep, in the place of a beam: too dark where light gets in, too bright around it.
        for radius, relative in zip(radii, better):
            if radius > 10:
                self.assertLess(abs(relative), 0.1)
            if radius < 0.06:
                self.assertLess(relative, -0.8)
            if 1.5 < radius < 4:
                self.assertGreater(relative, 0.15)
        fitted = report["models"]["normalized-diffusion"]["error"]
        self.assertLess(max(abs(v) for r, v in zip(radii, fitted["relative"][0]) if r < 5), 0.2)
        self.assertLess(abs(fitted["albedo"]["relative"][0]), 4 * fitted["albedo"]["standard_error"][0] + 1e-5)
        alone = report["models"]["single-scattering"]["error"]["relative"][0]
        self.assertAlmostEqual(alone[-1], -1, places=4)
        # With its boundary a medium like milk suits the better dipole.
        milk = self.report("--sigma-a", 0.01, "--sigma-s", 4.95, "--g", 0.8, "--ior", 1.4, "--model", "better-dipole",
                           "--radii", "2:15:12", "--error", "--photons", 3e5)
        error = milk["models"]["better-dipole"]["error"]
        for relative, deviation in zip(error["relative"][0], error["standard_error"][0]):
            self.assertLess(abs(relative), 0.05 + 3 * deviation)

    def test_exact_is_what_tyndall_slab_finds(self):
        slab = (*MEDIUM, "--g", 0.3, "--ior", 1.4, "--thickness", 3)
        for which, quantity in (((), "reflectance"), (("--transmitted",), "transmittance")):
            report = self.report(*slab, *which, "--radii", "0.002:4:20", "--error", "--photons", 3e5)
            exact = report["exact"]
            edges = exact["radii"]  # from so near the centre that what is within is below a part in 100
            self.assertEqual((len(edges), edges), (21, sorted(edges)))
            got_in = 1 - (0.4 / 2.4) ** 2
            result = run("tyndall-slab", *slab, "--radial", "%r:1" % edges[-1], "--photons", 3e5, "--seed", 1, "--json")
            totals = json.loads(self.check_succeeds(result).stdout)
            whole = totals["radial"][quantity]["value"][0] * edges[-1]**2 * math.pi / got_in
            rings = [math.pi * (b * b - a * a) * (v or 0) for a, b, v in zip(edges, edges[1:], exact["profile"][0])]
            self.assertAlmostEqual(sum(rings), whole, delta=0.02 * whole)
            albedo = totals[quantity]["diffuse"]["value"] / got_in
            self.assertAlmostEqual(exact["albedo"]["value"][0], albedo, delta=0.02 * albedo)
            self.assertEqual((exact["photons"], exact["seed"]), (300000, 0))

    def test_models_are_averaged_over_the_rings(self):
        for count in (4, 40):
            report = self.report(*MEDIUM, "--gaussians", "0.5:0.7", "--model", "gaussians", "--error", "--radii",
                                 "0.02:5:%d" % count, "--photons", 1e5)
            error, exact = report["models"]["gaussians"]["error"], report["exact"]
            self.assertEqual(error["radii"], exact["radii"])
            for i, relative in enumerate(error["relative"][0]):
                if relative is not None:
                    mean = 0.5 * mean_of_gaussian(0.7, *error["radii"][i:i + 2])
                    self.assertAlmostEqual((1 + relative) * exact["profile"][0][i], mean, delta=1e-5 * mean)

    def test_what_is_not_known_is_null(self):
        report = self.report(*MEDIUM, "--radii", "0.1:300:12", "--error", "--photons", 1000)
        exact = report["exact"]["profile"][0]
        self.assertIsNone(exact[-1])
        self.assertIn(True, [value is not None for value in exact])
        for model in report["models"].values():
            for name in ("relative", "standard_error"):
                self.assertEqual([v is None for v in model["error"][name][0]], [v is None for v in exact])
        black = self.report("--sigma-a", 1, "--sigma-s", 0, "--radii", "0.1:1:3", "--error", "--photons", 1000)
        self.assertEqual(black["models"]["multipole"]["albedo"], [0])
        self.assertEqual(black["models"]["multipole"]["error"]["albedo"]["relative"], [None])
        one = self.report(*MEDIUM, "--radii", "0.1:1:3", "--error", "--photons", 1)
        self.assertEqual(one["exact"]["profile"], [[None] * 3])

    def test_the_same_seed_gives_the_same_json_but_for_the_time(self):
        arguments = (*MEDIUM, "--radii", "0.1:3:8", "--error", "--photons", 20000, "--seed")
        reports = [self.report(*arguments, seed) for seed in (7, 7, 8)]
        for report in reports:
            del report["exact"]["seconds"]
        self.assertEqual(reports[0], reports[1])
        self.assertNotEqual(reports[0]["exact"]["profile"], reports[2]["exact"]["profile"])

    def test_interrupted_it_writes_what_is_done(self):
        self.report(*MEDIUM, "--error", "--photons", 1000)  # compiles the kernels
        report = self.interrupt("tyndall-profile", *MEDIUM, "--error", "--photons", "1e15", "--json", "-q")
        self.assertGreater(report["exact"]["photons"], 0)

    def test_a_table_says_what_it_is_and_is_missing_when_interrupted(self):
        process = self.start("tyndall-profile", "--sigma-a", 0.1, "--sigma-s", 0.9, "--radii", "0.1:10:5", "--error", "--json",
                             env={"TYNDALL_CACHE_DIR": ""})  # so that a table is made
        self.assertIn(" %, table of exact", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        if "of exact" not in errors and process.returncode == 0:
            self.skipTest("this device had made it by then")
        self.assertEqual(process.returncode, 130, errors)
        self.assertEqual(errors.splitlines()[-1],
                         "tyndall-profile: interrupted: without the model exact and the comparison of --error")
        self.assertEqual(list(json.loads(output)["models"]), HALF_SPACE_MODELS[:-1])

    # ---- outputs ----

    def test_text(self):
        result = self.check_succeeds(run("tyndall-profile", *MEDIUM, "--radii", "0.1:10:5"))
        lines = result.stdout.splitlines()
        self.assertEqual(lines[2].split(), ["radius", *HALF_SPACE_MODELS])
        self.assertEqual([line.split()[0] for line in lines[3:]], ["0.1", "0.3162", "1", "3.162", "10", "albedo"])
        self.assertAlmostEqual(float(lines[5].split()[1]), standard_dipole(0.01, 0.99, 0, 1, 1)[0], delta=1e-5)
        result = self.check_succeeds(run("tyndall-profile", "--medium", "skin1", "--error", "--photons", 1e4))
        for word in ("R: R(r)", "G: R(r)", "B: R(r)", "1/mm^2", "exact", "photons a channel"):
            self.assertIn(word, result.stdout)
        self.assertNotIn("nan", result.stdout)
        self.assertIn("100 %", result.stderr)
        quiet = self.check_succeeds(run("tyndall-profile", *MEDIUM, "-q"))
        self.assertEqual((quiet.stdout, quiet.stderr), ("", ""))

    def test_csv_holds_what_json_does(self):
        table = self.path("out.csv")
        slab = ("--sigma-a", "0.1,0.2", "--sigma-s", "1,1", "--radii", "0.1:300:12", "--csv", table)
        report = self.report(*slab)
        self.assertEqual(report["outputs"], {"csv": table})
        rows = self.rows(table)
        self.assertEqual(list(rows[0]), ["model", "channel", "quantity", "radius", "value"])
        self.assertEqual(len(rows), len(HALF_SPACE_MODELS) * 2 * (12 + 1))
        report = self.report(*slab, "--error", "--photons", 1e4)
        rows = self.rows(table)
        self.assertEqual(list(rows[0])[5:], ["exact", "exact_standard_error", "error"])
        for name, model in report["models"].items():
            for channel in (0, 1):
                mine = [row for row in rows if (row["model"], row["channel"]) == (name, str(channel))]
                error, exact = model["error"], report["exact"]
                expected = zip(report["radii"], model["profile"][channel], exact["profile"][channel],
                               exact["standard_error"][channel], error["relative"][channel])
                for row, values in zip(mine, expected):
                    self.assertEqual(row["quantity"], "profile")
                    self.assertEqual(tuple(float(v) if v else None for v in list(row.values())[3:]), values)
                albedo = [float(v) if v else None for v in list(mine[-1].values())[3:]]
                self.assertEqual(mine[-1]["quantity"], "albedo")
                self.assertEqual(albedo, [None, model["albedo"][channel], exact["albedo"]["value"][channel],
                                          exact["albedo"]["standard_error"][channel],
                                          error["albedo"]["relative"][channel]])

    def rows(self, path):
        with open(path, newline="") as file:
            return list(csv.DictReader(file))

    def test_plots(self):
        plot = self.path("out.png")
        result = run("tyndall-profile", *MEDIUM, "--plot", plot, "-q")
        if "without Cairo" in result.stderr:
            self.check_fails(result, 2, "--plot", "libcairo2-dev")
            self.skipTest("built without Cairo")
        self.check_succeeds(result)
        one_panel = png_size(plot)
        self.assertTrue(800 < one_panel[0] < 2000 and 600 < one_panel[1] < 1500, one_panel)
        self.assertGreater(os.path.getsize(plot), 20000)
        self.check_succeeds(run("tyndall-profile", *MEDIUM, "--plot", plot, "-q", "--error", "--photons", 1e4))
        self.assertEqual(png_size(plot)[0], one_panel[0])
        self.assertGreater(png_size(plot)[1], one_panel[1] + 500)  # the deviation, below
        # What is hard to draw: a black medium, two radii, no error known, many channels.
        many = ",".join(map(str, range(1, 31)))
        for slab in (("--sigma-a", 1, "--sigma-s", 0, "--error"), (*MEDIUM, "--radii", "1:2:2", "--error"),
                     ("--sigma-a", many, "--sigma-s", many, "--error", "--radii", "1e-6:1e6:5"),
                     (*MEDIUM, "--radii", "1e4:2e4:9", "--error"), ("--medium", "skin1", "--thickness", 1)):
            for photons in (1, 1000) if "--error" in slab else (None,):
                with self.subTest(slab=slab, photons=photons):
                    os.remove(plot)
                    limit = ("--photons", photons) if photons else ()
                    self.check_succeeds(run("tyndall-profile", *slab, *limit, "--plot", plot, "-q"))
                    width, height = png_size(plot)
                    self.assertTrue(800 < width < 4000 and 600 < height < 2500, (width, height))
        self.assertEqual(os.listdir(self.folder), ["out.png"])


if __name__ == "__main__":
    unittest.main()
