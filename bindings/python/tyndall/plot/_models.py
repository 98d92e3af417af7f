# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The models of a picture."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Union

from .._bssrdf.models import Bssrdf
from .._core.arrays import shown
from .._slab.layers import Layers, stack
from .._slab.results import SlabResult
from ..context import Context, default_context
from ..errors import InvalidArgumentError

Curve = Union[Bssrdf, SlabResult]
"""What has a profile."""

Models = Union[str, Curve, "Iterable[str | Curve]", "Mapping[str, str | Curve]"]
"""Models, or their names, or results of walks, or any of these by the labels that they get."""


def named(models: Models) -> dict[str, str | Curve]:
    """Models, names of models, and results, by the labels that they get."""
    if isinstance(models, (str, Bssrdf, SlabResult)):
        models = [models]
    pairs = models.items() if isinstance(models, Mapping) else [(_label(one), one) for one in models]
    result: dict[str, str | Curve] = {}
    for label, one in pairs:
        if not isinstance(one, (str, Bssrdf, SlabResult)):
            raise InvalidArgumentError(
                f"models holds {shown(one)}; it must hold tyndall.Bssrdf, names of models, or tyndall.SlabResult"
            )
        result[label if label not in result else f"{label} ({len(result) + 1})"] = one
    if not result:
        raise InvalidArgumentError("models is empty; there must be one or more")
    return result


def made(models: Models, medium: Layers | None, context: Context | None, options: Mapping[str, Any]) -> dict[str, Curve]:
    """Models and results by their labels; models that are names are made of `medium`."""
    layers = None if medium is None else stack(medium)
    result: dict[str, Curve] = {}
    for label, one in named(models).items():
        if isinstance(one, str):
            if layers is None:
                raise InvalidArgumentError(f'models has the name "{one}", and there is no medium that it is to be made of')
            one = (context or default_context()).bssrdf(one, layers, **options)
        result[label] = one
    return result


def _label(model: Any) -> str:
    if isinstance(model, SlabResult):
        return "walks"
    return model.model if isinstance(model, Bssrdf) else str(model)
