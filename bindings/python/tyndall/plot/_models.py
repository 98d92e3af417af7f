# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""The models of a picture."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Union

from .._bssrdf.models import Bssrdf
from .._slab.layers import Layers
from ..context import Context, default_context
from ..errors import InvalidArgumentError

Models = Union[str, Bssrdf, "Iterable[str | Bssrdf]", "Mapping[str, str | Bssrdf]"]
"""Models, or their names, or either by the labels that they get."""


def named(models: Models) -> dict[str, str | Bssrdf]:
    """Models and names of models, by the labels that they get."""
    if isinstance(models, (str, Bssrdf)):
        models = [models]
    pairs = models.items() if isinstance(models, Mapping) else [(_label(one), one) for one in models]
    result: dict[str, str | Bssrdf] = {}
    for label, one in pairs:
        if not isinstance(one, (str, Bssrdf)):
            raise InvalidArgumentError(f"models holds {one!r}; it must hold tyndall.Bssrdf or names of models")
        result[label if label not in result else f"{label} ({len(result) + 1})"] = one
    if not result:
        raise InvalidArgumentError("models is empty; there must be one or more")
    return result


def made(models: Models, medium: Layers | None, context: Context | None, options: Mapping[str, Any]) -> dict[str, Bssrdf]:
    """Models by their labels; those that are names are made of `medium`."""
    result = {}
    for label, one in named(models).items():
        if isinstance(one, str):
            if medium is None:
                raise InvalidArgumentError(f'models has the name "{one}", and there is no medium that it is to be made of')
            one = (context or default_context()).bssrdf(one, medium, **options)
        result[label] = one
    return result


def _label(model: Any) -> str:
    return model.model if isinstance(model, Bssrdf) else str(model)
