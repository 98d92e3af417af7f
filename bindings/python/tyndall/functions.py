# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Calls of a context that may be made without one: they use the default one."""

from __future__ import annotations

from typing import Any

from ._bssrdf.models import Bssrdf
from ._slab.layers import Layers
from .context import Context, default_context


def bssrdf(model: str, layers: Layers, *, context: Context | None = None, **options: Any) -> Bssrdf:
    """Prepares a BSSRDF model of a medium: Context.bssrdf of `context`, by default of `default_context()`."""
    return (context or default_context()).bssrdf(model, layers, **options)
