# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
"""What all parts rest on: owning C objects, arrays, records and progress at the edge of the C API."""
