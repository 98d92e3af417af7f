# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""tyn_adding_doubling against iadpython, S. Prahl's adding-doubling: one layer, with and without glass slides, total
reflectance and transmittance for normal and for diffuse incidence. Its own errors, at the number of quadrature points that
suits it best, set the limits: 16 points where the index matches (more make it worse), 32 where it does not. They are larger
for a peaked phase function and, as it integrates Fresnel's formulas with the same points, by 1e-4 for diffuse light on a
dielectric. Exit status 77 where iadpython is missing."""
import ctypes
import itertools
import math
import os
import sys
import unittest

try:
    import iadpython
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)

Double, Size, U32 = ctypes.c_double, ctypes.c_size_t, ctypes.c_uint32
Pointer = ctypes.POINTER(Double)


def struct(name, fields):
    """A struct of the C API: its size, then (type, names) groups."""
    members = [("size", Size)] + [(field, kind) for kind, names in fields for field in names.split()]
    return type(name, (ctypes.Structure,), {"_fields_": members})


Layer = struct("TynSlabLayer", [(Pointer, "sigma_a sigma_s"), (Double, "g"), (ctypes.c_void_p, "phase"),
                                (Double, "ior thickness")])
Slab = struct("TynSlab", [(U32, "channel_count layer_count"), (ctypes.POINTER(Layer), "layers"),
                          (Double, "ior_above ior_below")])
Options = struct("TynAddingDoublingOptions", [(U32, "channel incidence"), (Double, "angle tolerance"),
                                              (U32, "max_nodes"), (Pointer, "cosines"), (Size, "cosine_count")])
Result = struct("TynAddingDoublingResult", [
    (Double, "reflectance transmittance absorbed specular_reflectance direct_transmittance accuracy"), (U32, "nodes")])

tyndall = ctypes.CDLL(os.path.join(os.environ["TYNDALL_LIB_DIR"], "libtyndall.so"))


def make_layer(sigma_a, sigma_s, g, n, thickness):
    return Layer(ctypes.sizeof(Layer), (Double * 1)(sigma_a), (Double * 1)(sigma_s), g, None, n, thickness)


def solve(albedo, optical_thickness, g, n, slide, diffuse):
    """A sample in air, between two clear slides if their index is not 1."""
    layers = [make_layer(1 - albedo, albedo, g, n, optical_thickness)]
    if slide != 1:
        layers = [make_layer(0, 0, 0, slide, 1.0)] + layers + [make_layer(0, 0, 0, slide, 1.0)]
    slab = Slab(ctypes.sizeof(Slab), 1, len(layers), (Layer * len(layers))(*layers), 1.0, 1.0)
    options = Options(ctypes.sizeof(Options), 0, diffuse, 0.0, 1e-7, 192, None, 0)
    result = Result(ctypes.sizeof(Result))
    message = ctypes.create_string_buffer(256)
    status = tyndall.tyn_adding_doubling(ctypes.byref(slab), ctypes.byref(options), ctypes.byref(result), None, None,
                                         message, Size(len(message)))
    assert status == 0, message.value
    return result.reflectance, result.transmittance


class AgainstIadpython(unittest.TestCase):
    def check(self, points, tolerance, *, albedos, thicknesses, gs, n, slide=1.0):
        fresnel = 1e-4 if n != 1 else 0
        for a, b, g in itertools.product(albedos, thicknesses, gs):
            sample = iadpython.Sample(a=a, b=b, g=g, n=n, n_above=slide, n_below=slide, quad_pts=points)
            normal_r, normal_t, diffuse_r, diffuse_t = map(float, sample.rt())
            for diffuse, expected in ((0, (normal_r, normal_t)), (1, (diffuse_r, diffuse_t))):
                found = solve(a, b, g, n, slide, diffuse)
                for what, ours, theirs in zip("RT", found, expected):
                    with self.subTest(a=a, b=b, g=g, n=n, diffuse=diffuse, what=what):
                        self.assertAlmostEqual(ours, theirs, delta=tolerance + fresnel * diffuse)

    def test_matched_index(self):
        self.check(16, 1e-5, n=1.0, albedos=(0.1, 0.5, 0.9, 0.99), gs=(-0.5, 0.0, 0.5),
                   thicknesses=(0.1, 1.0, 10.0, math.inf))

    def test_matched_index_forward(self):
        self.check(16, 1e-4, n=1.0, albedos=(0.5, 0.9, 0.99), gs=(0.8, 0.9), thicknesses=(0.5, 2.0, 20.0, math.inf))

    def test_dielectric(self):
        for n in (1.33, 1.4, 1.5):
            self.check(32, 1e-4, n=n, albedos=(0.1, 0.5, 0.9, 0.99), gs=(-0.5, 0.0, 0.5),
                       thicknesses=(0.1, 1.0, 10.0, math.inf))

    def test_dielectric_forward(self):
        self.check(32, 2e-4, n=1.4, albedos=(0.5, 0.9, 0.99), gs=(0.8, 0.9), thicknesses=(0.5, 2.0, 20.0, math.inf))

    def test_between_glass_slides(self):
        self.check(32, 1e-4, n=1.4, slide=1.5, albedos=(0.5, 0.9, 0.99), gs=(0.0, 0.5), thicknesses=(0.1, 1.0, 10.0))


if __name__ == "__main__":
    unittest.main()
