# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Files that cannot be read or written, and machines without a device: one clear line, the right exit status, and no
partial image under the name of a whole one."""
import json
import os
import resource
import unittest

from tools import SKIN_LIKE, ToolTest, cube, cube_document, glb, run


class BadFiles(ToolTest):
    def render(self, model, *arguments, **options):
        arguments = arguments or ("-o", self.path("out.exr"))
        return run("tyndall-render", model, *arguments, "--spp", 1, "--width", 16, "-q", **options)

    def check_bad_input(self, content, *words, name="bad.glb"):
        model = self.write(name, content)
        self.check_fails(self.render(model), 3, *words)
        self.check_fails(run("tyndall-info", model), 3, *words)
        self.assertFalse(os.path.exists(self.path("out.exr")))

    def test_missing_file(self):
        self.check_fails(self.render(self.path("none.glb")), 3, "none.glb")
        self.check_fails(run("tyndall-info", self.path("none.glb")), 3, "none.glb")

    def test_a_folder(self):
        self.check_fails(self.render(self.folder), 3)

    def test_empty_and_foreign_files(self):
        self.check_bad_input(b"")
        self.check_bad_input(b"\0" * 100)
        self.check_bad_input("solid cube\nendsolid\n", name="cube.gltf")
        self.check_bad_input("{}", name="empty.gltf")
        self.check_bad_input("[" * 5000, name="deep.gltf")

    def test_truncated_anywhere(self):
        whole = cube(extensions=SKIN_LIKE)
        for size in (4, 11, 12, 19, 20, 100, len(whole) // 2, len(whole) - 4):
            with self.subTest(size=size):
                self.check_bad_input(whole[:size])

    def test_wrong_contents(self):
        def changed(change):
            document, binary = cube_document()
            change(document)
            return glb(document, binary)

        self.check_bad_input(changed(lambda d: d["accessors"][0].update(count=1000)), "accessors")
        self.check_bad_input(changed(lambda d: d["bufferViews"][1].update(byteOffset=10 ** 9)))
        self.check_bad_input(changed(lambda d: d["meshes"][0]["primitives"][0].update(indices=17)))
        self.check_bad_input(changed(lambda d: d["nodes"][0].update(children=[0])))
        nothing = self.write("nothing.glb", changed(lambda d: (d["nodes"][0].pop("mesh"), d.pop("meshes"))))
        self.check_fails(self.render(nothing), 3, "no mesh")
        self.assertIn("0 meshes", self.check_succeeds(run("tyndall-info", nothing)).stdout)
        self.check_bad_input(changed(lambda d: d.update(extensionsRequired=["EXT_from_the_future"],
                                                         extensionsUsed=["EXT_from_the_future"])),
                             "EXT_from_the_future")

    def test_an_index_out_of_range(self):
        self.check_bad_input(cube(triangles=[(0, 2, 99)]))

    def test_coordinates_beyond_the_scenes_limit(self):
        self.check_bad_input(cube(half=2e10), "bad.glb", "meshes[0].primitives[0]")

    def test_nothing_but_degenerate_triangles(self):
        model = self.write("bad.glb", cube(triangles=[(0, 0, 0)]))
        result = self.render(model)
        self.check_fails(result, 3, "bad.glb", "no mesh")
        self.assertFalse(os.path.exists(self.path("out.exr")))
        self.assertIn("meshes[0].primitives[0]", self.check_succeeds(run("tyndall-info", model)).stderr)

    def test_an_environment_that_is_none(self):
        model = self.write("cube.glb", cube())
        out = ("-o", self.path("out.exr"))
        self.check_fails(self.render(model, *out, "--env", self.path("none.exr")), 3, "none.exr")
        self.check_fails(self.render(model, *out, "--env", self.write("sky.exr", b"not an image")), 3, "sky.exr")

    def test_outputs_that_cannot_be_written_are_found_before_rendering(self):
        model = self.write("cube.glb", cube(extensions=SKIN_LIKE))
        self.check_fails(self.render(model, "-o", self.path("none/out.exr")), 1, "none/out.exr")
        self.check_fails(self.render(model, "-o", self.path("cube.glb/out.exr")), 1, "out.exr")
        os.mkdir(self.path("folder.exr"))
        self.check_fails(self.render(model, "-o", self.path("folder.exr")), 1, "folder.exr")
        result = self.render(model, "-o", self.path("out.exr"), "--png", self.path("none/out.png"))
        self.check_fails(result, 1, "none/out.png")
        self.assertEqual(sorted(os.listdir(self.folder)), ["cube.glb", "folder.exr"])

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission(self):
        model = self.write("cube.glb", cube())
        os.mkdir(self.path("locked"), 0o500)
        self.check_fails(self.render(model, "-o", self.path("locked/out.exr")), 1, "locked/out.exr")

    def test_a_full_disk_leaves_nothing_and_an_older_image_alone(self):
        model = self.write("cube.glb", cube(extensions=SKIN_LIKE))
        older = self.write("out.exr", b"the older image")

        def small_files():  # stands for a full disk: a write beyond 4 KiB fails
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        # The first run fills the kernel caches, so that the image is the only file that the second one writes. Python
        # ignores SIGXFSZ, and so does what it starts with restore_signals off.
        arguments = ("tyndall-render", model, "--spp", 1, "--width", 64, "--height", 64, "-q")
        self.check_succeeds(run(*arguments, "-o", self.path("warm.exr")))
        os.remove(self.path("warm.exr"))
        result = run(*arguments, "-o", older, preexec_fn=small_files, restore_signals=False)
        self.check_fails(result, 1, "out.exr")
        with open(older, "rb") as file:
            self.assertEqual(file.read(), b"the older image")
        self.assertEqual(sorted(os.listdir(self.folder)), ["cube.glb", "out.exr"])

    def test_no_device(self):
        model = self.write("cube.glb", cube())
        nothing = {"OCL_ICD_VENDORS": self.path("none"), "OCL_ICD_FILENAMES": ""}
        self.check_fails(self.render(model, env=nothing), 4)
        self.check_fails(run("tyndall-info", model, env=nothing), 4)
        self.check_fails(run("tyndall-info", "--devices", env=nothing), 4)
        self.check_fails(self.render(model, "-o", self.path("out.exr"), "--device", "abacus"), 4, "abacus")
        self.check_fails(self.render(model, "-o", self.path("out.exr"), "--device", "99"), 4, "99")

    def test_a_failed_run_prints_no_json(self):
        result = run("tyndall-render", self.path("none.glb"), "-o", self.path("out.exr"), "--json")
        self.check_fails(result, 3)
        result = run("tyndall-info", self.path("none.glb"), "--json")
        self.check_fails(result, 3)

    def test_names_from_files_do_not_reach_the_terminal_raw(self):
        document, binary = cube_document(extensions=SKIN_LIKE)
        document["meshes"][0]["name"] = document["nodes"][0]["name"] = "evil\x1b[2J\ncube"
        document["materials"][0]["name"] = "\x07bell"
        model = self.write("evil.glb", glb(document, binary))
        result = self.check_succeeds(run("tyndall-info", model))
        self.assertNotRegex(result.stdout + result.stderr, r"[\x00-\x09\x0b-\x1f]")
        self.assertEqual(json.loads(run("tyndall-info", model, "--json").stdout)["meshes"], 1)


if __name__ == "__main__":
    unittest.main()
