# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall-profile: --help, wrong command lines, files that cannot be written."""
import os
import unittest

from tools import ToolTest, run

MEDIUM = ("--sigma-a", "0.1", "--sigma-s", "1")

OPTIONS = """--sigma-a --sigma-s --g --ior --thickness --layer --medium --model --radii --fit --gaussians --transmitted
  --error --photons --seed --json --csv --plot --device -q --quiet --version --help""".split()

MODELS = ("standard-dipole", "better-dipole", "photon-beam-diffusion", "multipole", "normalized-diffusion", "gaussians",
          "single-scattering", "quantized-diffusion", "directional-dipole", "exact")

# Wrong values of options beside MEDIUM and --error; the option is named in the answer.
WRONG = """--thickness 0, --thickness nan, --ior 0.9, --ior 4.1, --g 1, --g nan, --photons 0, --photons 1.5,
  --photons 1e16, --photons many, --seed -1, --seed 1.5, --radii 1, --radii 1:2, --radii 0:1:5, --radii -1:1:5,
  --radii 2:1:5, --radii 1:1:5, --radii 1:2:1, --radii 1:2:2.5, --radii 1:2:1e9, --radii 1:inf:5, --radii nan:1:5,
  --radii 1e-40:1:5, --radii 1:1e40:5, --radii 1:2:3:4, --radii 1:2:x, --model all,multipole, --model dipole,
  --model multipole,, --model multipole,multipole, --model gaussians, --fit wide, --fit 0, --gaussians 1,
  --gaussians 1:0, --gaussians -1:1, --gaussians 1:nan, --gaussians 0.6:1,0.5:1, --gaussians 1:1:1, --gaussians 1:1,,
  --plot out.jpg""".replace("\n", " ").split(", ")


class ProfileUsage(ToolTest):
    def check_usage(self, *arguments, word=""):
        # Where no device is found the status is 4: wrong usage is found before one is looked for.
        result = run("tyndall-profile", *arguments, env={"OCL_ICD_VENDORS": "/nowhere", "OCL_ICD_FILENAMES": ""})
        self.check_fails(result, 2, word)

    def test_help_names_every_option_model_units_and_examples(self):
        text = self.check_succeeds(run("tyndall-profile", "--help", env={"OCL_ICD_VENDORS": "/nowhere"})).stdout
        for word in (*OPTIONS, *MODELS, "between -1 and 1", "exact takes mean cosines up to 0.999", "Examples:", "Units:",
                     "Exit status:"):
            self.assertIn(word, text)
        self.assertLessEqual(max(map(len, text.splitlines())), 120)
        version = self.check_succeeds(run("tyndall-profile", "--version", env={"OCL_ICD_VENDORS": "/nowhere"}))
        self.assertRegex(version.stdout, r"^tyndall-profile \d+\.\d+\.\d+\n$")

    def test_wrong_values(self):
        for words in WRONG:
            option, value = words.split()
            with self.subTest(option=option, value=value):
                self.check_usage(*MEDIUM, "--error", option, value, word=option)

    def test_an_unknown_model_is_answered_with_all_names(self):
        result = run("tyndall-profile", *MEDIUM, "--model", "tripole")
        self.check_fails(result, 2, "tripole", *MODELS)

    def test_media(self):
        self.check_usage(word="--sigma-a")
        self.check_usage("--sigma-a", "1", word="--sigma-s")
        self.check_usage("--sigma-a", "1", "--sigma-s", "nan", word="--sigma-s")
        self.check_usage("--sigma-a", "1,2", "--sigma-s", "1", word="--sigma-a")
        self.check_usage("--medium", "granite", word="marble")
        self.check_usage("--medium", "skin1", "--sigma-a", "1", word="--medium")

    def test_what_does_not_go_together(self):
        self.check_usage(*MEDIUM, "--transmitted", word="--thickness")
        self.check_usage("--layer", "0,1,0,1,2", "--layer", "0,1,0,1,inf", "--transmitted", word="--thickness")
        self.check_usage("--layer", "0,1,0,1,2", "--layer", "0,1,0,1,inf", "--error", word="--sigma-a 0")
        self.check_usage("--layer", "0,1,0,1,inf", "--layer", "0,1,0,1,2", word="inf")
        self.check_usage("--layer", "0,1,0,1", word="--layer")
        self.check_usage(*MEDIUM, "--thickness", "1", "--transmitted", "--model", "single-scattering", word="multipole")
        self.check_usage(*MEDIUM, "--fit", "dmfp", "--model", "multipole", word="normalized-diffusion")
        self.check_usage(*MEDIUM, "--gaussians", "1:1", "--model", "multipole", word="--model gaussians")
        self.check_usage(*MEDIUM, "--photons", "5", word="--error")
        self.check_usage(*MEDIUM, "--seed", "5", word="--error")
        self.check_usage("--sigma-a", "0", "--sigma-s", "1", "--error", word="--sigma-a 0")
        self.check_usage(*MEDIUM, "--layer", "1,1,0,1,1", word="--layer")
        self.check_usage(*MEDIUM, "multipole", word="multipole")

    def test_models_that_do_not_take_the_layer(self):
        for model in ("standard-dipole", "better-dipole", "photon-beam-diffusion", "normalized-diffusion"):
            result = run("tyndall-profile", *MEDIUM, "--thickness", 1, "--model", "multipole," + model)
            self.check_fails(result, 2, "--model " + model, "--thickness is 1", "must be inf")
        thin = ("--layer", "0,1,0,1,0.5", "--layer", "0,1,0,1,5")
        self.check_fails(run("tyndall-profile", *thin, "--model", "standard-dipole"), 2, "takes 1 layer")
        for models in ("all", "multipole"):
            result = run("tyndall-profile", *thin, "--model", models)
            self.check_fails(result, 2, "--model multipole", "--layer 1: thickness is 0.5 reduced mean free paths")
        dense = ("--sigma-a", 1e30, "--sigma-s", 1e30)
        self.check_fails(run("tyndall-profile", *dense, "--model", "all", "--json"), 2, "no model", "it must be at most 1e+30")
        result = run("tyndall-profile", "--sigma-a", 0, "--sigma-s", 1, "--fit", "dmfp")
        self.check_fails(result, 2, "normalized-diffusion", "sigma_a")

    def test_outputs(self):
        plot = self.path("out.png")
        self.check_usage(*MEDIUM, "--csv", plot, "--plot", plot, word="--plot")
        for path in (self.path("none/out.csv"), self.folder, "/dev/null/out.csv"):
            self.check_fails(run("tyndall-profile", *MEDIUM, "--csv", path), 3, path)
        self.assertEqual(os.listdir(self.folder), [])

    def test_no_device(self):
        nothing = {"OCL_ICD_VENDORS": self.path("none"), "OCL_ICD_FILENAMES": ""}
        self.check_fails(run("tyndall-profile", *MEDIUM, env=nothing), 4)
        self.check_fails(run("tyndall-profile", *MEDIUM, "--device", "abacus", "--json"), 4, "abacus")


if __name__ == "__main__":
    unittest.main()
