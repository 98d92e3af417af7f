# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C: the first finishes the pass and writes what is done, the second kills."""
import os
import signal
import time
import unittest

from tools import SKIN_LIKE, ToolTest, cube, exr_size, png_size, run

LIGHT = {"type": "point", "intensity": 0.01}


class Interrupt(ToolTest):
    def setUp(self):
        super().setUp()
        model = self.write("skin.glb", cube(extensions=SKIN_LIKE, lights=[LIGHT]))
        # Kernels are compiled first, so that the time below is spent rendering.
        run("tyndall-render", model, "-o", self.path("warm.exr"), "--spp", 1, "--width", 8, "-q")
        os.remove(self.path("warm.exr"))
        self.endless = ["tyndall-render", model, "-o", self.path("out.exr"), "--spp", "1000000"]

    def test_the_image_so_far_is_written(self):
        report = self.interrupt(*self.endless, "--width", 48, "--height", 32, "--json", "--png", self.path("out.png"))
        self.assertGreater(report["samples"], 0)
        self.assertLess(report["samples"], 1000000)
        self.assertEqual(exr_size(self.path("out.exr")), (48, 32))
        self.assertEqual(png_size(self.path("out.png")), (48, 32))
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.exr", "out.png", "skin.glb"])

    def test_the_second_kills(self):
        # So large that the first pass, which is always finished, takes seconds.
        process = self.start(*self.endless, "--width", 2400, "--height", 2400)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        if process.returncode == 130:
            self.skipTest("this device finished the pass in between")
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertFalse(os.path.exists(self.path("out.exr")))


if __name__ == "__main__":
    unittest.main()
