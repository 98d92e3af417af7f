# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""--help, --version, and what is said to a wrong command line."""
import unittest

from tools import ToolTest, cube, run

TOOLS = ("tyndall-render", "tyndall-info", "tyndall-demo-scene")

RENDER_OPTIONS = """-o --output --png --width --height --spp --target-error --time-limit --seed --camera --env
  --env-rotation --no-lights --medium --max-bounces --exit --bssrdf --exposure --tone --device --json -q --quiet -v --verbose
  --version --help""".split()
INFO_OPTIONS = "--medium --devices --media --device --json -q --quiet --version --help".split()


class Usage(ToolTest):
    def test_help_begins_with_the_purpose_and_examples_and_names_every_option(self):
        for tool, options in (("tyndall-render", RENDER_OPTIONS), ("tyndall-info", INFO_OPTIONS)):
            text = self.check_succeeds(run(tool, "--help")).stdout
            self.assertLess(text.index("Examples:"), text.index("--json  "))
            self.assertIn("Exit status:", text)
            for option in options:
                self.assertIn(option, text)
            self.assertLessEqual(max(map(len, text.splitlines())), 120)

    def test_help_and_version_need_nothing_else_and_no_device(self):
        for tool in TOOLS:
            for option in ("--help", "--version"):
                result = self.check_succeeds(run(tool, option, env={"OCL_ICD_VENDORS": "/nowhere"}))
                self.assertEqual(result.stderr, "")
            self.assertRegex(result.stdout, r"^%s \d+\.\d+\.\d+\n$" % tool)

    def check_usage(self, *arguments, word=""):
        self.check_fails(run("tyndall-render", *arguments), 2, word)

    def test_missing_or_unknown_arguments(self):
        self.check_usage(word="--help")
        self.check_usage("model.glb", word="output")
        self.check_usage("model.glb", "-o", "a.exr", "--colour", "red", word="--colour")
        self.check_usage("model.glb", "other.glb", "-o", "a.exr", word="other.glb")

    def test_values_out_of_range(self):
        for option, value in (("--width", "0"), ("--width", "-3"), ("--width", "32769"), ("--height", "1.5"),
                              ("--height", "many"), ("--spp", "0"), ("--spp", "-1"), ("--seed", "-1"),
                              ("--target-error", "nan"), ("--target-error", "-0.1"), ("--time-limit", "inf"),
                              ("--time-limit", "-2"), ("--max-bounces", "0"), ("--exit", "wide"),
                              ("--tone", "filmic"), ("--exposure", "inf"), ("--env-rotation", "nan")):
            with self.subTest(option=option, value=value):
                self.check_usage("model.glb", "-o", "a.exr", option, value, word=option)

    def test_environments(self):
        for text in ("constant:", "constant:1", "constant:1,2", "constant:1,2,3,4", "constant:1,,2", "constant:1,2,x",
                     "constant:-1,0,0", "constant:nan,0,0", "constant:1;2;3"):
            with self.subTest(env=text):
                self.check_usage("model.glb", "-o", "a.exr", "--env", text, word="constant:")

    def test_media(self):
        self.check_usage("model.glb", "-o", "a.exr", "--medium", "granite", word="marble")
        self.check_usage("model.glb", "-o", "a.exr", "--medium", "=marble", word="--medium")

    def test_models(self):
        self.check_usage("model.glb", "-o", "a.exr", "--bssrdf", "tripole", word="standard-dipole, better-dipole")
        self.check_usage("model.glb", "-o", "a.exr", "--bssrdf", "gaussians", word="--bssrdf gaussians")
        self.check_usage("model.glb", "-o", "a.exr", "--bssrdf", "better-dipole", "--exit", "dielectric", word="--exit")

    def test_the_names_of_the_images(self):
        self.check_usage("model.glb", "-o", "a.png", word=".exr")
        self.check_usage("model.glb", "-o", "a.exr", "--png", "a.jpg", word=".png")

    def test_a_camera_that_is_not_there(self):
        model = self.write("two.glb", cube(cameras=("front", "far")))
        result = run("tyndall-render", model, "-o", self.path("a.exr"), "--camera", "side")
        self.check_fails(result, 2, "front", "far")
        self.check_fails(run("tyndall-render", model, "-o", self.path("a.exr"), "--camera", "2"), 2)

    def test_info_wants_one_subject(self):
        self.check_fails(run("tyndall-info"), 2, "SCENE")
        self.check_fails(run("tyndall-info", "--devices", "--media"), 2)
        self.check_fails(run("tyndall-info", "model.glb", "--devices"), 2)

    def test_the_demo_scene_wants_a_name(self):
        self.check_fails(run("tyndall-demo-scene"), 2)
        self.check_fails(run("tyndall-demo-scene", "--large"), 2)


if __name__ == "__main__":
    unittest.main()
