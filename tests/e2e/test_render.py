# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall-render on small models: the files it writes and what it reports."""
import json
import os
import unittest

from tools import SKIN_LIKE, ToolTest, cube, exr_header, exr_size, png_size, read_exr, run

LIGHT = {"type": "point", "intensity": 0.01, "color": [1, 1, 1]}
PARTS = ("rays", "walks", "exits", "shading")
LEDGER = ("entered", "reflected", "escaped", "absorbed", "balance", "capped", "leaked", "lost")


class Render(ToolTest):
    def render(self, model, *arguments, **options):
        return self.check_succeeds(run("tyndall-render", model, "-o", self.path("out.exr"), *arguments, **options))

    def skin(self, **options):
        return self.write("skin.glb", cube(extensions=SKIN_LIKE, **options))

    def report(self, model, *arguments, **options):
        result = self.render(model, "--json", *arguments, **options)
        return json.loads(result.stdout)

    def test_writes_all_layers_and_says_where_they_come_from(self):
        model = self.skin(lights=[LIGHT])
        self.render(model, "--spp", 4, "--width", 48, "--height", 32, "--seed", 7, "--png", self.path("out.png"))
        header = exr_header(self.path("out.exr"))
        channels = header["channels"][1]
        for channel in ("R", "G", "B", "A", "subsurface.R", "specular.G", "diffuse.B", "emission.R", "albedo.R",
                        "normal.X", "depth.Z", "samples.Y", "variance.R"):
            self.assertIn(channel, channels)
        self.assertIn("chromaticities", header)
        self.assertEqual(exr_size(self.path("out.exr")), (48, 32))
        self.assertEqual(png_size(self.path("out.png")), (48, 32))
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.exr", "out.png", "skin.glb"])

    def test_json_is_one_object_and_the_ledger_balances(self):
        report = self.report(self.skin(lights=[LIGHT]), "--spp", 8, "--width", 32, "--height", 32, "--seed", 5)
        self.assertEqual(report["samples"], 8)
        self.assertEqual(report["seed"], 5)
        self.assertEqual((report["width"], report["height"]), (32, 32))
        self.assertFalse(report["interrupted"])
        self.assertFalse(report["default_light"])
        self.assertEqual(report["outputs"], {"exr": self.path("out.exr")})
        self.assertEqual(report["scene"]["triangles"], 12)
        self.assertEqual(report["scene"]["lights"], 1)
        self.assertGreater(report["seconds"], 0)
        parts = [report["seconds_" + part] for part in PARTS]
        self.assertGreater(min(parts), 0)
        self.assertLess(sum(parts), 1.001 * report["seconds"])
        self.assertGreater(report["error"], 0)
        self.assertTrue(report["device"]["name"])
        ledger = report["ledger"]
        self.assertGreater(ledger["walks"], 100)
        for c in range(3):
            spent = sum(ledger[part][c] for part in LEDGER[1:])
            self.assertAlmostEqual(spent / ledger["entered"][c], 1, places=5)

    def test_a_model_takes_the_place_of_walks_and_is_named(self):
        model = self.skin(lights=[LIGHT])
        walked = self.report(model, "--spp", 4, "--width", 32)
        self.assertEqual(walked["subsurface"], "walks")
        self.assertEqual(exr_header(self.path("out.exr"))["subsurface"][1], "walks")
        for name in ("normalized-diffusion", "photon-beam-diffusion"):
            report = self.report(model, "--spp", 4, "--width", 32, "--bssrdf", name)
            self.assertEqual(report["subsurface"], name)
            self.assertEqual(exr_header(self.path("out.exr"))["subsurface"][1], name)
            ledger = report["ledger"]
            self.assertGreater(ledger["escaped_walks"], 100)
            self.assertEqual(ledger["scatterings"], ledger["escaped_walks"])
            for c in range(3):
                spent = sum(ledger[part][c] for part in LEDGER[1:])
                self.assertAlmostEqual(spent / ledger["entered"][c], 1, places=5)

    def test_quiet_says_nothing(self):
        result = self.render(self.skin(lights=[LIGHT]), "--spp", 1, "--width", 16, "-q")
        self.assertEqual((result.stdout, result.stderr), ("", ""))

    def test_verbose_says_where_the_time_went(self):
        result = self.render(self.skin(lights=[LIGHT]), "--spp", 1, "--width", 16, "--verbose")
        self.assertRegex(result.stderr, r"s: rays \d+ %, walks \d+ %, exits \d+ %, shading \d+ %, host \d+ %\n")

    def test_progress_without_a_terminal_is_plain_lines_on_standard_error(self):
        result = self.render(self.skin(lights=[LIGHT]), "--spp", 10, "--width", 16)
        lines = [line for line in result.stderr.splitlines() if "%" in line]
        self.assertGreater(len(lines), 0)
        self.assertLessEqual(len(lines), 10)
        self.assertNotIn("\r", result.stderr)
        self.assertNotIn("\x1b", result.stderr)
        self.assertEqual(len(result.stdout.splitlines()), 1)
        for model in ((), ("--bssrdf", "normalized-diffusion")):
            one = self.render(self.skin(lights=[LIGHT]), "--spp", 1, "--width", 16, *model).stderr.splitlines()
            self.assertEqual(one[-1], "tyndall-render: 100 %, 1/1 samples")

    def test_the_same_seed_gives_the_same_bits_and_another_seed_does_not(self):
        model = self.skin(lights=[LIGHT])
        pixels = []
        for seed in (1, 1, 2):
            self.render(model, "--spp", 4, "--width", 24, "--seed", seed, "-q")
            pixels.append(read_exr(self.path("out.exr"))[1])
        self.assertTrue(pixels[0] == pixels[1])
        self.assertTrue(pixels[0] != pixels[2])

    def test_a_model_without_light_gets_a_soft_one_and_says_so(self):
        model = self.skin()
        result = self.render(model, "--spp", 2, "--width", 16, "--json")
        self.assertIn("default light", result.stderr)
        self.assertTrue(json.loads(result.stdout)["default_light"])
        self.assertFalse(self.report(model, "--spp", 2, "--width", 16, "--env", "constant:1,1,1")["default_light"])

    def test_no_lights_leaves_the_file_s_lights_out(self):
        model = self.skin(lights=[LIGHT])
        result = self.render(model, "--spp", 2, "--width", 16, "--no-lights", "--json")
        self.assertEqual(json.loads(result.stdout)["scene"]["lights"], 0)
        self.assertIn("black", result.stderr)

    def test_cameras_by_name_and_by_index(self):
        model = self.skin(lights=[LIGHT], cameras=("front", "far"))
        for wanted, name in ((None, "front"), ("far", "far"), ("1", "far"), ("0", "front")):
            arguments = ["--camera", wanted] if wanted else []
            self.assertEqual(self.report(model, "--spp", 1, "--width", 30, *arguments)["camera"], name)
        self.assertEqual(exr_size(self.path("out.exr")), (30, 20))  # by the camera's shape, 3:2

    def test_a_model_without_scattering_becomes_a_medium_when_asked(self):
        model = self.write("plain.glb", cube(lights=[LIGHT]))
        plain = self.report(model, "--spp", 1, "--width", 16)
        self.assertEqual(plain["ledger"]["walks"], 0)
        self.assertEqual((plain["seconds_walks"], plain["seconds_exits"]), (0, 0))
        for argument in ("marble", "body=marble", "ALL=marble"):
            report = self.report(model, "--spp", 2, "--width", 16, "--medium", argument)
            self.assertGreater(report["ledger"]["walks"], 0, argument)
        self.assertIn("marble", exr_header(self.path("out.exr"))["media"][1])

    def test_an_environment_from_a_file(self):
        model = self.skin()
        self.render(model, "--spp", 1, "--width", 16, "--height", 8, "--env", "constant:1,0.5,0.25", "-q")
        os.rename(self.path("out.exr"), self.path("sky.exr"))
        report = self.report(model, "--spp", 1, "--width", 16, "--env", self.path("sky.exr"), "--env-rotation", 90)
        self.assertTrue(report["scene"]["environment"])

    def test_limits(self):
        model = self.skin(lights=[LIGHT])
        loose = self.report(model, "--width", 16, "--target-error", 0.5)
        self.assertGreaterEqual(loose["samples"], 16)
        self.assertLessEqual(loose["error"], 0.5)
        short = self.report(model, "--width", 64, "--time-limit", 0.3)
        self.assertGreaterEqual(short["samples"], 1)
        self.assertLess(short["seconds"], 30)

    def test_numbers_do_not_follow_the_locale(self):
        model = self.skin()
        options = {"env": {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}}
        report = self.report(model, "--spp", 1, "--width", 16, "--env", "constant:0.5,0.5,0.5", **options)
        self.assertIsInstance(report["seconds"], float)

    def test_holes_are_reported_in_the_ledger(self):
        triangles = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (0, 4, 2), (2, 4, 6),
                     (1, 3, 5), (3, 7, 5)]  # no lid
        model = self.write("open.glb", cube(extensions=SKIN_LIKE, triangles=triangles, lights=[LIGHT]))
        result = self.render(model, "--spp", 8, "--width", 32, "--json")
        self.assertGreater(json.loads(result.stdout)["ledger"]["leaked_walks"], 0)
        self.assertIn("hole", result.stderr)


if __name__ == "__main__":
    unittest.main()
