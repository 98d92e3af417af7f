#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# check_install.sh BUILD CMAKE GENERATOR CC MINIMAL.c: installs BUILD into a fresh prefix, moves the prefix, and builds and runs
# MINIMAL.c against it, once through find_package and once through pkg-config.
set -euo pipefail
build=$1 cmake=$2 generator=$3 cc=$4 minimal=$5
here=$(cd "$(dirname "$0")" && pwd)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
say() { printf '== %s\n' "$*"; }

say "install"
DESTDIR='' "$cmake" --install "$build" --prefix "$work/first" >"$work/log" || { cat "$work/log"; exit 1; }
mv "$work/first" "$work/prefix" # what was installed must not know where it was
if grep -rIlF -e "$work" -e "$build" "$work/prefix"; then
  echo "the installed files above hold an absolute path"
  exit 1
fi

libdir=$(dirname "$(find "$work/prefix" -name 'libtyndall.so' | head -n 1)")
[ -f "$libdir/libtyndall.so" ] || { echo "libtyndall.so was not installed"; exit 1; }

say "find_package"
io=$([ -e "$libdir/libtyndall-io.so" ] && echo ON || echo OFF)
"$cmake" -S "$here" -B "$work/consumer" -G "$generator" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_C_COMPILER="$cc" \
  -DMINIMAL="$minimal" -DWITH_IO="$io" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$cmake" --build "$work/consumer" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/consumer/minimal"

say "pkg-config"
export PKG_CONFIG_PATH="$libdir/pkgconfig"
# shellcheck disable=SC2046 # flags are meant to be split
"$cc" "$minimal" -o "$work/minimal" $(pkg-config --cflags --libs tyndall) -lm
LD_LIBRARY_PATH="$libdir" "$work/minimal"
if [ "$io" = ON ]; then
  pkg-config --libs tyndall-io
fi
