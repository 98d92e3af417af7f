# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The C API as it is: a module a header with its constants, records and signatures, and the library itself in `lib` and
`io`. The rest of the package is built on it; programs that need one call in its raw form find it here."""

from .library import io, lib, path
from .tyndall import *  # noqa: F403
from .tyndall_base import *  # noqa: F403
from .tyndall_bssrdf import *  # noqa: F403
from .tyndall_cl import *  # noqa: F403
from .tyndall_exact import *  # noqa: F403
from .tyndall_io import *  # noqa: F403
from .tyndall_phase import *  # noqa: F403
from .tyndall_slab import *  # noqa: F403
from .tyndall_types import *  # noqa: F403

__all__ = ["io", "lib", "path"]
