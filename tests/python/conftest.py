# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share."""

from collections.abc import Iterator

import pytest

import tyndall as ty


@pytest.fixture(scope="session")
def context() -> Iterator[ty.Context]:
    """One context for all tests of a file that do not need their own: kernels are built once."""
    with ty.Context() as one:
        yield one
