# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyndall-info: models, devices, media; and the demo scene, looked at through it."""
import json
import os
import time
import unittest

from tools import CUBE_TRIANGLES, SKIN_LIKE, ToolTest, cube, run


class Info(ToolTest):
    def report(self, *arguments):
        return json.loads(self.check_succeeds(run("tyndall-info", *arguments, "--json")).stdout)

    def test_a_closed_cube(self):
        model = self.write("cube.glb", cube(half=0.01, extensions=SKIN_LIKE, cameras=("front",)))
        report = self.report(model)
        mesh, = report["mesh_list"]
        self.assertEqual((mesh["triangles"], mesh["closed"], mesh["components"]), (12, True, 1))
        self.assertAlmostEqual(mesh["area"], 6 * 0.02 ** 2, places=9)
        self.assertAlmostEqual(mesh["volume"], 0.02 ** 3, places=11)
        medium, = report["medium_list"]
        self.assertAlmostEqual(medium["mean_free_path_mm"][0], 1 / 0.776529, places=4)  # -1 / ln 0.46
        fraction = medium["meshes"][0]["mean_free_path"][0]
        self.assertAlmostEqual(fraction, medium["mean_free_path_mm"][0] / (20 * 3 ** 0.5), places=6)
        self.assertEqual(report["camera_list"][0]["name"], "front")
        text = self.check_succeeds(run("tyndall-info", model)).stdout
        for word in ("cube", "closed", "24", "8", "body", "front"):  # cm2, cm3
            self.assertIn(word, text)

    def test_an_open_mesh_says_what_is_wrong(self):
        model = self.write("open.glb", cube(triangles=CUBE_TRIANGLES[:10]))
        mesh, = self.report(model)["mesh_list"]
        self.assertEqual((mesh["closed"], mesh["boundary_edges"]), (False, 4))
        self.assertIn("open, 4 boundary edges", run("tyndall-info", model).stdout)

    def test_turned_triangles_are_counted(self):
        turned = [t if i else t[::-1] for i, t in enumerate(CUBE_TRIANGLES)]
        model = self.write("turned.glb", cube(triangles=turned))
        mesh, = self.report(model, "--medium", "skin1")["mesh_list"]
        self.assertEqual((mesh["closed"], mesh["turned_triangles"]), (True, 1))
        mesh, = self.report(model)["mesh_list"]  # without a medium the winding is the file's
        self.assertEqual((mesh["closed"], mesh["turned_triangles"]), (True, 0))

    def test_a_medium_can_be_tried(self):
        model = self.write("cube.glb", cube())
        self.assertEqual(self.report(model)["media"], 0)
        medium, = self.report(model, "--medium", "skin1")["medium_list"]
        for value, expected in zip(medium["sigma_a_per_mm"], (0.032, 0.17, 0.48)):
            self.assertAlmostEqual(value / expected, 1, places=5)

    def test_devices(self):
        devices = self.report("--devices")["devices"]
        self.assertEqual([device["index"] for device in devices], list(range(len(devices))))
        self.assertGreater(len(devices), 0)
        text = self.check_succeeds(run("tyndall-info", "--devices")).stdout
        self.assertIn(devices[0]["name"], text)

    def test_media(self):
        media = {medium["name"]: medium for medium in self.report("--media")["media"]}
        self.assertEqual(len(media), 12)
        for value, expected in zip(media["marble"]["sigma_s_per_mm"], (2.19, 2.62, 3.00)):
            self.assertAlmostEqual(value, expected, places=5)
        self.assertIn("spectralon", self.check_succeeds(run("tyndall-info", "--media")).stdout)


class DemoScene(ToolTest):
    def test_it_is_closed_and_holds_the_measured_media(self):
        scene = self.path("demo.glb")
        start = time.monotonic()
        self.check_succeeds(run("tyndall-demo-scene", scene))
        self.assertLess(time.monotonic() - start, 20)  # 2 s where nothing else runs
        result = self.check_succeeds(run("tyndall-info", scene, "--json"))
        report = json.loads(result.stdout)
        self.assertLess(report["triangles"], 300000)
        filled = [mesh for mesh in report["mesh_list"] if mesh["medium"] is not None]
        self.assertGreaterEqual(len(filled), 4)
        for mesh in filled:
            self.assertTrue(mesh["closed"], mesh["name"])
            self.assertEqual((mesh["components"], mesh["turned_triangles"]), (1, 0), mesh["name"])
        media = {medium["name"]: medium for medium in report["medium_list"]}
        presets = json.loads(run("tyndall-info", "--media", "--json").stdout)["media"]
        presets = {medium["name"]: medium for medium in presets}
        for name, preset in (("skin", "skin1"), ("marble", "marble"), ("milk", "wholemilk")):
            for key in ("sigma_s_per_mm", "sigma_a_per_mm"):
                for value, expected in zip(media[name][key], presets[preset][key]):
                    self.assertAlmostEqual(value / expected, 1, delta=5e-3)
            self.assertAlmostEqual(media[name]["ior"], presets[preset]["ior"], places=5)
        # What a draft extension is worth saying about it is said; nothing else is doubtful.
        self.assertEqual([w for w in report["warnings"] if "draft" not in w], [])

    def test_it_is_the_same_every_time(self):
        contents = []
        for name in ("a.glb", "b.glb"):
            self.check_succeeds(run("tyndall-demo-scene", self.path(name)))
            with open(self.path(name), "rb") as file:
                contents.append(file.read())
        self.assertEqual(contents[0], contents[1])

    def test_it_cannot_be_written(self):
        self.check_fails(run("tyndall-demo-scene", self.path("none/demo.glb")), 1, "none/demo.glb")
        self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
