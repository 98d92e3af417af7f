# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall-slab: --help, wrong command lines, files that cannot be written."""
import os
import resource
import unittest

from tools import ToolTest, run

LAYER = ("--sigma-a", "1", "--sigma-s", "9")

OPTIONS = """--sigma-a --sigma-s --g --ior --thickness --layer --medium --phase --ior-above --ior-below --incidence
  --beam --photons --target-error --time-limit --seed --max-order --radial --angular --radial-angular --depth
  --orders --path --sweep-albedo --exact --json --csv --plot --unit --device -q --quiet --version --help""".split()

# Wrong values of options beside LAYER; the option is named in the answer.
WRONG = """--thickness 0, --thickness -1, --thickness nan, --thickness thick, --ior 0.9, --ior 4.1, --ior nan,
  --g 1, --g -1, --g nan, --photons 0, --photons -1, --photons 1.5, --photons 1e16, --photons nan,
  --photons inf, --photons many, --target-error -1, --target-error nan, --time-limit -1, --time-limit inf,
  --seed -1, --seed 1.5, --seed 18446744073709551616, --max-order 0, --max-order -1, --max-order 1e10,
  --radial 5, --radial 5:0, --radial 0:5, --radial 5:1e12, --radial 5:2.5, --radial inf:5, --radial nan:5,
  --radial 5:5:5, --angular 0, --angular 1e12, --depth -1:5, --orders -1, --orders 1e9, --path 1:,
  --sweep-albedo 1.5, --sweep-albedo -0.1, --sweep-albedo 1, --sweep-albedo 0.5:0.1:3, --sweep-albedo 0:0.9:1,
  --sweep-albedo 0:0.9:1e9, --sweep-albedo nan, --phase mist, --phase hg:0.5, --phase two-lobe:0.5,
  --phase two-lobe:1,0,0.5, --phase two-lobe:0,0,2, --phase draine:0,-1, --phase mie:0,1.3,0,
  --phase mie:1e9,1.3,0, --phase mie:1,0,0, --phase mie:1,1.3, --incidence up, --incidence angle:90,
  --incidence angle:-1, --incidence angle:nan, --beam laser, --beam disc, --beam disc:0, --beam gaussian:inf,
  --ior-above 0, --ior-below 9, --unit 1, --plot out.jpg""".replace("\n", " ").split(", ")


class SlabUsage(ToolTest):
    def check_usage(self, *arguments, word=""):
        # Where no device is found the status is 4: wrong usage is found before one is looked for.
        result = run("tyndall-slab", *arguments, env={"OCL_ICD_VENDORS": "/nowhere", "OCL_ICD_FILENAMES": ""})
        self.check_fails(result, 2, word)

    def test_help_names_every_option_units_and_examples(self):
        text = self.check_succeeds(run("tyndall-slab", "--help", env={"OCL_ICD_VENDORS": "/nowhere"})).stdout
        for option in OPTIONS:
            self.assertIn(option, text)
        for word in ("between -1 and 1", "Examples:", "Units:", "Exit status:"):
            self.assertIn(word, text)
        self.assertLessEqual(max(map(len, text.splitlines())), 120)
        version = self.check_succeeds(run("tyndall-slab", "--version", env={"OCL_ICD_VENDORS": "/nowhere"}))
        self.assertRegex(version.stdout, r"^tyndall-slab \d+\.\d+\.\d+\n$")

    def test_wrong_values(self):
        for words in WRONG:
            option, value = words.split()
            with self.subTest(option=option, value=value):
                self.check_usage(*LAYER, option, value, word=option)

    def test_coefficients(self):
        for sigma_a, sigma_s in (("nan", "1"), ("-1", "1"), ("1", "inf"), ("1", "x"), ("1,,2", "1,1,1"), ("1e31", "1"),
                                 ("", "1"), ("1,2", "1"), ("1", "1,2"), (",".join(["1"] * 1025),) * 2):
            with self.subTest(sigma_a=sigma_a[:20], sigma_s=sigma_s[:20]):
                self.check_usage("--sigma-a", sigma_a, "--sigma-s", sigma_s, word="--sigma-")
        self.check_usage(word="--sigma-a")
        self.check_usage("--sigma-a", "1", word="--sigma-s")
        self.check_usage("--sigma-a", "0", "--sigma-s", "1", word="--thickness")
        self.check_usage("--sigma-a", "0", "--sigma-s", "0", word="--thickness")

    def test_layers(self):
        good = "1,1,0,1,1"
        for bad in ("1,1,0,1", "1,1,0,1,1,1", "1,1,2,1,1", "1,1,0,5,1", "1,1,0,1,0", "1,1,0,1,-inf", "-1,1,0,1,1",
                    "1,1,0,1,nan", "1/2,1,0,1,1", "1/2,1/2,0,1,1", ""):
            with self.subTest(layer=bad):
                self.check_usage("--layer", good, "--layer", bad, word="--layer")
        self.check_usage("--layer", "1,1,0,1,inf", "--layer", good, word="--layer 1")
        self.check_usage(*["--layer", good] * 65, word="--layer")
        for exact in ((), ("--exact",)):
            self.check_fails(run("tyndall-slab", "--layer", good, "--layer", "1,1,0,1,1e21", *exact), 2, "--layer 2: thickness")
            self.check_fails(run("tyndall-slab", *LAYER, "--thickness", "1e21", *exact), 2, "--thickness is 1e+21")
        for other in (("--sigma-a", "1"), ("--g", "0"), ("--thickness", "1"), ("--medium", "skin1"), ("--phase", "hg")):
            self.check_usage("--layer", good, *other, word=other[0])

    def test_what_does_not_go_together(self):
        self.check_usage("--medium", "skin1", "--sigma-a", "1", word="--medium")
        self.check_usage("--medium", "granite", word="marble")
        self.check_usage("--medium", "skin1", "--unit", "cm", word="--unit")
        self.check_usage("--medium", "skin1", "--sweep-albedo", "0.5", word="--sweep-albedo")
        self.check_usage(*LAYER, "--phase", "rayleigh", "--g", "0.1", word="--phase")
        self.check_usage(*LAYER, "--exact", "--max-order", "1", word="--exact")
        self.check_usage(*LAYER, "--radial-angular", word="--angular")
        self.check_usage(*LAYER, "--radial-angular", "--radial", "1:1e4", "--angular", "1e4", word="--radial-angular")
        self.check_usage(*LAYER, "--colour", "red", word="--colour")
        self.check_usage(*LAYER, "skin", word="skin")
        self.check_usage(*LAYER, "--photons", word="--photons")

    def test_outputs(self):
        plot = self.path("out.png")
        self.check_usage(*LAYER, "--csv", plot, "--plot", plot, word="--plot")
        os.symlink(plot, self.path("link"))
        self.check_usage(*LAYER, "--csv", self.path("link"), "--plot", plot, word="--plot")
        for path in (self.path("none/out.csv"), self.folder, "/dev/null/out.csv"):
            self.check_fails(run("tyndall-slab", *LAYER, "--csv", path), 3, path)
        self.assertEqual(os.listdir(self.folder), ["link"])

    def test_a_full_disk_leaves_nothing_and_an_older_file_alone(self):
        def small_files():  # stands for a full disk: a write beyond 4 KiB fails
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        older = self.write("out.csv", "the older file")
        arguments = ("tyndall-slab", *LAYER, "--photons", 1000, "--radial", "1:500", "-q")
        self.check_succeeds(run(*arguments))  # fills the kernel caches, so that the table is the only file written next
        result = run(*arguments, "--csv", older, preexec_fn=small_files, restore_signals=False)
        self.check_fails(result, 3, "out.csv")
        with open(older) as file:
            self.assertEqual(file.read(), "the older file")
        self.assertEqual(os.listdir(self.folder), ["out.csv"])

    def test_special_files_are_written_to_and_not_replaced(self):
        self.check_succeeds(run("tyndall-slab", *LAYER, "--photons", 1000, "--csv", "/dev/null", "-q"))
        self.assertFalse(os.path.isfile("/dev/null"))

    def test_no_device(self):
        nothing = {"OCL_ICD_VENDORS": self.path("none"), "OCL_ICD_FILENAMES": ""}
        self.check_fails(run("tyndall-slab", *LAYER, env=nothing), 4)
        self.check_fails(run("tyndall-slab", *LAYER, "--device", "abacus", "--json"), 4, "abacus")


if __name__ == "__main__":
    unittest.main()
