# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Pictures of results with matplotlib, which is imported when the first is drawn: pip install 'tyndall[plot]'.

Each function draws into the Axes it is given, or makes a figure of its own, and returns the Axes: titles, limits and files are
matplotlib's business (`ax.figure.savefig("profile.png")`)."""

from ._albedo import albedo
from ._image import image
from ._profile import profile
from ._walk import walk
from ._walk_paths import walk_paths

__all__ = ["albedo", "image", "profile", "walk", "walk_paths"]
