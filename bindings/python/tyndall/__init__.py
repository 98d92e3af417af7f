# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""Tyndall: subsurface scattering."""

from .context import Context, default_context
from .devices import Device, devices
from .layers import Layer
from .medium import Medium
from .phase import Phase

__all__ = ["Context", "Device", "Layer", "Medium", "Phase", "default_context", "devices"]
