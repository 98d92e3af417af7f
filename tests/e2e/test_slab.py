# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall-slab: published values, what the energy does, and every kind of output."""
import csv
import json
import math
import os
import time
import unittest

from tools import ToolTest, png_size, run

# A slab whose R and T are published: van de Hulst 1980, table 35; also in Wang, Jacques & Zheng 1995, table 1 (MCML).
PUBLISHED = ("--sigma-a", 1, "--sigma-s", 9, "--g", 0.75, "--thickness", 0.2)
PUBLISHED_R, PUBLISHED_T = 0.09739, 0.66096

THREE_LAYERS = ("--layer", "0.1,10,0.9,1.37,1", "--layer", "0.1,1,0,1.37,1", "--layer", "0.2,1,0.7,1.37,2")
RESOLVED = ("--radial", "2:10", "--angular", 6, "--radial-angular", "--depth", "4:8", "--orders", 5, "--path", "9:3")
HALF_PI = math.pi / 2


def sum_of(curve):
    return sum(curve["value"])


class Slab(ToolTest):
    def report(self, *arguments, photons=1e5):
        limit = ("--photons", photons) if photons else ()
        result = self.check_succeeds(run("tyndall-slab", *arguments, *limit, "--json", "-q"))
        self.assertEqual(result.stderr, "")
        return json.loads(result.stdout)

    def check_near(self, estimate, exact, errors=4.0, rounding=1e-6):
        self.assertLess(abs(estimate["value"] - exact), errors * estimate["stderr"] + rounding)

    def check_balance(self, channel, digits=6):
        parts = (channel["reflectance"]["specular"], channel["reflectance"]["diffuse"],
                 channel["transmittance"]["direct"], channel["transmittance"]["diffuse"],
                 channel["absorbed"], channel["cut"])
        self.assertAlmostEqual(sum(part["value"] for part in parts), 1, places=digits)
        for name, one, other in (("reflectance", "specular", "diffuse"), ("transmittance", "direct", "diffuse")):
            total = channel[name]["total"]["value"]
            self.assertAlmostEqual(channel[name][one]["value"] + channel[name][other]["value"], total, places=12)

    # ---- values ----

    def test_the_published_slab(self):
        report = self.report(*PUBLISHED, photons=1e6)
        self.check_near(report["reflectance"]["total"], PUBLISHED_R, rounding=5e-6)
        self.check_near(report["transmittance"]["total"], PUBLISHED_T, rounding=5e-6)
        self.check_near(report["transmittance"]["direct"], math.exp(-2))  # Beer-Lambert
        self.check_balance(report)
        self.assertEqual((report["photons"], report["seed"], report["interrupted"]), (1000000, 0, False))
        self.assertGreater(report["events"], 0)
        self.assertGreater(report["seconds"], 0)
        self.assertTrue(report["device"]["name"])

    def test_exact_is_near_the_published_values_and_the_estimate(self):
        for light in ((), ("--incidence", "diffuse", "--ior", 1.4), ("--incidence", "angle:60", "--ior-above", 1.2)):
            exact = self.report(*PUBLISHED, *light, "--exact")["exact"]
            self.assertLess(abs(exact["reflectance_deviation"]), 4)
            self.assertLess(abs(exact["transmittance_deviation"]), 4)
            if not light:
                self.assertAlmostEqual(exact["reflectance"], PUBLISHED_R, delta=6e-6)
                self.assertAlmostEqual(exact["transmittance"], PUBLISHED_T, delta=6e-6)
                self.assertLess(exact["accuracy"], 1e-5)

    def test_phase_functions_against_the_exact_solution(self):
        medium = ("--sigma-a", 0.5, "--sigma-s", 2, "--thickness", 1, "--exact")
        reflectances = set()
        for phase in ("isotropic", "rayleigh", "two-lobe:0.8,-0.3,0.7", "draine:0.4,1", "mie:2,1.33,0"):
            with self.subTest(phase=phase):
                exact = self.report(*medium, "--phase", phase)["exact"]
                self.assertLess(abs(exact["reflectance_deviation"]), 4)
                self.assertLess(abs(exact["transmittance_deviation"]), 4)
                reflectances.add(round(exact["reflectance"], 4))
        self.assertEqual(len(reflectances), 5)

    def test_single_scattering_is_the_closed_form(self):
        # Index-matched half-space, normal incidence, isotropic: each of the light's first events sends W / 2 up, of
        # which int_0^1 mu / (1 + mu) dmu = 1 - ln 2 arrives.
        report = self.report("--sigma-a", 0.25, "--sigma-s", 0.75, "--max-order", 1, "--orders", 3)
        self.check_near(report["reflectance"]["total"], 0.75 / 2 * (1 - math.log(2)))
        self.assertGreater(report["cut"]["value"], 0)
        self.check_balance(report)
        orders = report["orders"]["reflectance"]
        self.assertEqual((orders["value"][0], orders["value"][2:]), (0, [0, 0]))
        self.assertAlmostEqual(orders["value"][1], report["reflectance"]["total"]["value"], places=6)

    def test_a_sweep_agrees_with_runs_of_its_own(self):
        slab = ("--sigma-a", 0.1, "--sigma-s", 0.9, "--thickness", 2)
        report = self.report(*slab, "--sweep-albedo", "0.2:0.8:3")
        self.assertEqual([row["albedo"] for row in report["sweep"]], [0.2, 0.5, 0.8])
        for row in report["sweep"]:
            albedo = row["albedo"]
            exact = self.report("--sigma-a", 1 - albedo, "--sigma-s", albedo, "--thickness", 2, "--exact",
                                photons=1000)["exact"]
            self.check_near(row["reflectance"], exact["reflectance"])
            self.check_near(row["transmittance"], exact["transmittance"])
            self.check_near(row["absorbed"], 1 - exact["reflectance"] - exact["transmittance"])
        # The photons are those of the highest albedo.
        self.assertAlmostEqual(report["reflectance"]["total"]["value"], report["sweep"][2]["reflectance"]["value"], 6)

    def test_channels(self):
        report = self.report("--sigma-a", "1,2,4", "--sigma-s", "9,9,9", "--g", 0.75, "--thickness", 0.2, photons=2e5)
        self.assertEqual([channel["name"] for channel in report["channels"]], ["0", "1", "2"])
        self.check_near(report["channels"][0]["reflectance"]["total"], PUBLISHED_R)
        for channel in report["channels"]:
            self.check_balance(channel)
        absorbed = [channel["absorbed"]["value"] for channel in report["channels"]]
        self.assertEqual(absorbed, sorted(absorbed))
        self.assertIn("photons", report)
        self.assertNotIn("photons", report["channels"][0])
        self.assertNotIn("reflectance", report)

    def test_a_measured_medium_has_three_channels_and_an_index(self):
        report = self.report("--medium", "skin1", "--exact")
        self.assertEqual([channel["name"] for channel in report["channels"]], ["R", "G", "B"])
        for channel in report["channels"]:
            self.assertAlmostEqual(channel["reflectance"]["specular"]["value"], (0.3 / 2.3) ** 2, places=6)
            self.assertLess(abs(channel["exact"]["reflectance_deviation"]), 4)

    def test_layers_and_everything_resolved_sum_to_the_totals(self):
        report = self.report(*THREE_LAYERS, *RESOLVED)
        self.check_balance(report)
        absorbed = report["absorbed"]["value"]
        self.assertAlmostEqual(sum(layer["absorbed"]["value"] for layer in report["layers"]), absorbed, places=6)
        self.assertEqual(len(report["layers"]), 3)
        depth = report["depth"]
        self.assertEqual(depth["edges"], [0.5 * i for i in range(9)])
        # Estimated in another way than the total.
        self.assertAlmostEqual(0.5 * sum_of(depth["absorbed"]), absorbed, delta=2 * report["absorbed"]["stderr"])
        coefficients = [0.1] * 4 + [0.2] * 4
        for value, fluence, sigma_a in zip(depth["absorbed"]["value"], depth["fluence"]["value"], coefficients):
            self.assertAlmostEqual(value, sigma_a * fluence, delta=0.05 * value)
        angular, diffuse = report["angular"], report["reflectance"]["diffuse"]["value"]
        self.assertEqual(angular["edges"][0::6], [0, 90])
        solid = [2 * math.pi * (math.cos(HALF_PI * i / 6) - math.cos(HALF_PI * (i + 1) / 6)) for i in range(6)]
        self.assertAlmostEqual(sum(a * b for a, b in zip(solid, angular["reflectance"]["value"])), diffuse, places=5)
        radial = report["radial"]
        rings = [math.pi * (b * b - a * a) for a, b in zip(radial["edges"], radial["edges"][1:])]
        both = report["radial_angular"]["reflectance"]["value"]
        self.assertEqual((len(both), len(both[0])), (10, 6))
        for ring, row, value in zip(rings, both, radial["reflectance"]["value"]):
            self.assertAlmostEqual(sum(a * b for a, b in zip(solid, row)) * ring, value * ring, places=5)
        self.assertEqual(len(report["orders"]["transmittance"]["value"]), 6)
        self.assertEqual((report["path"]["edges"], len(report["path"]["reflectance"]["stderr"])), ([0, 3, 6, 9], 3))

    def test_the_beam_changes_where_light_leaves_but_not_how_much(self):
        pencil = self.report(*PUBLISHED, "--radial", "2:4")["radial"]["reflectance"]["value"]
        for beam in ("disc:1", "gaussian:1"):
            report = self.report(*PUBLISHED, "--radial", "2:4", "--beam", beam)
            self.check_near(report["reflectance"]["total"], PUBLISHED_R)
            self.assertLess(report["radial"]["reflectance"]["value"][0], pencil[0] / 2)

    # ---- when it ends ----

    def test_limits(self):
        report = self.report(*PUBLISHED, "--target-error", 2e-3, photons=None)
        self.assertLessEqual(report["reflectance"]["total"]["stderr"], 2e-3)
        self.assertLessEqual(report["transmittance"]["total"]["stderr"], 2e-3)
        again = self.report(*PUBLISHED, "--target-error", 2e-3, photons=None)
        self.assertEqual(report["photons"], again["photons"])
        start = time.monotonic()
        self.report(*PUBLISHED, "--time-limit", 0.5, photons=None)
        self.assertLess(time.monotonic() - start, 30)

    def test_the_same_seed_gives_the_same_json_but_for_the_time(self):
        reports = [self.report(*THREE_LAYERS, *RESOLVED, "--seed", seed, photons=20000) for seed in (7, 7, 8)]
        for report in reports:
            del report["seconds"]
        self.assertEqual(reports[0], reports[1])
        self.assertNotEqual(reports[0]["reflectance"], reports[2]["reflectance"])
        self.assertEqual(reports[0]["seed"], 7)

    def test_interrupted_it_writes_what_is_done(self):
        self.report(*PUBLISHED, photons=1000)  # compiles the kernels
        report = self.interrupt("tyndall-slab", *PUBLISHED, "--photons", "1e15", "--json", "-q", "--angular", "9", "--csv",
                                self.path("out.csv"))
        self.assertGreater(report["photons"], 0)
        self.check_near(report["reflectance"]["total"], PUBLISHED_R, errors=5, rounding=5e-6)
        self.assertEqual(os.listdir(self.folder), ["out.csv"])

    # ---- outputs ----

    def test_text(self):
        result = self.check_succeeds(run("tyndall-slab", *THREE_LAYERS, "--photons", 1e4, "--angular", 9, "--exact"))
        for word in ("diffuse reflectance", "+-", "absorbed in layer 3", "adding-doubling", "events/s", "--csv"):
            self.assertIn(word, result.stdout)
        self.assertNotIn("cut", result.stdout)
        self.assertIn("100 %", result.stderr)
        many = self.check_succeeds(run("tyndall-slab", "--sigma-a", "1,2,3,4,5", "--sigma-s", "1,1,1,1,1",
                                       "--photons", 1000, "-q"))
        self.assertEqual((many.stdout, many.stderr), ("", ""))

    def test_csv_holds_what_json_does(self):
        table = self.path("out.csv")
        report = self.report(*THREE_LAYERS, *RESOLVED, "--csv", table)
        with open(table, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["quantity", "channel", "row", "column", "lower", "upper", "column_lower",
                                         "column_upper", "unit", "value", "stderr"])

        def column(quantity, key="value"):
            return [float(row[key]) for row in rows if row["quantity"] == quantity]

        self.assertEqual(column("reflectance"), [report["reflectance"]["total"]["value"]])
        self.assertEqual(column("cut"), [0])
        self.assertEqual(column("layer_absorbed", "upper"), [1, 2, 4])
        for name, group in (("radial", "radial"), ("angular", "angular"), ("path", "path")):
            self.assertEqual(column(name + "_reflectance"), report[group]["reflectance"]["value"])
            self.assertEqual(column(name + "_transmittance", "stderr"), report[group]["transmittance"]["stderr"])
            self.assertEqual(column(name + "_reflectance", "lower"), report[group]["edges"][:-1])
        self.assertEqual(column("depth_fluence"), report["depth"]["fluence"]["value"])
        grid = report["radial_angular"]["transmittance"]["value"]
        self.assertEqual(column("radial_angular_transmittance"), [value for row in grid for value in row])
        units = {row["quantity"]: row["unit"] for row in rows}
        self.assertEqual((units["radial_reflectance"], units["order_reflectance"]), ("1/mm^2", "1"))
        self.assertEqual(len({len(row) for row in rows}), 1)

    def test_plots(self):
        plot = self.path("out.png")
        result = run("tyndall-slab", *THREE_LAYERS, *RESOLVED, "--photons", 1e4, "--plot", plot, "-q")
        if "without Cairo" in result.stderr:
            self.check_fails(result, 2, "--plot", "libcairo2-dev")
            self.skipTest("built without Cairo")
        self.check_succeeds(result)
        width, height = png_size(plot)
        self.assertTrue(2000 < width < 4000 and 1000 < height < 3000, (width, height))
        self.assertGreater(os.path.getsize(plot), 20000)
        # What is hard to draw: nothing resolved, a black half-space, no noise at all, many channels, one bin.
        many = ",".join(map(str, range(1, 31)))
        for slab in (PUBLISHED, ("--sigma-a", 1, "--sigma-s", 0, "--radial", "1:3", "--angular", 2, "--path", "1:2"),
                     ("--sigma-a", many, "--sigma-s", many, "--thickness", 1), ("--medium", "skin1", "--depth", "9:1"),
                     ("--sigma-a", many, "--sigma-s", many, "--thickness", 1, "--radial", "1e-6:9", "--orders", 0),
                     (*PUBLISHED, "--sweep-albedo", "0.5"), (*PUBLISHED, "--radial", "1e6:5", "--depth", "1e-3:4")):
            with self.subTest(slab=slab):
                os.remove(plot)
                self.check_succeeds(run("tyndall-slab", *slab, "--photons", 1000, "--plot", plot, "-q"))
                width, height = png_size(plot)
                self.assertTrue(800 < width < 2000 and 600 < height < 2500, (width, height))
        self.check_succeeds(run("tyndall-slab", *THREE_LAYERS, *RESOLVED, "--photons", 1, "--plot", plot, "-q"))
        self.assertEqual(os.listdir(self.folder), ["out.png"])

    def test_one_photon_has_no_error(self):
        report = self.report(*PUBLISHED, "--exact", photons=1)
        self.check_balance(report)
        text = self.check_succeeds(run("tyndall-slab", *PUBLISHED, "--exact", "--photons", 1)).stdout
        self.assertNotIn("nan", text)
        self.assertNotIn("inf", text)


if __name__ == "__main__":
    unittest.main()
