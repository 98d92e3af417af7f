#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# packages.sh [plots|python|tests]: installs the Debian or Ubuntu packages that building and running Tyndall needs; with
# `plots` also the optional one that the tools draw plots with, with `python` what `pip install .` takes, with `tests` both
# and those of the test suite. Names what it installs; does nothing when everything is there. As root or with sudo.
set -euo pipefail

build=(g++ cmake ninja-build pkgconf)
libraries=(ocl-icd-opencl-dev opencl-c-headers libembree-dev libeigen3-dev libtinygltf-dev libopenexr-dev libpng-dev
  libcli11-dev nlohmann-json3-dev libmeshoptimizer-dev)
device=(pocl-opencl-icd) # OpenCL on the processor; a GPU brings its own driver
plots=(libcairo2-dev)
python=(python3 python3-venv)
tests=(libgtest-dev librandom123-dev)
optional=()
if [ "${1:-}" = tests ]; then
  build+=("${tests[@]}" "${plots[@]}" "${python[@]}")
  optional=(oclgrind libbenchmark-dev) # not in every distribution; what needs them is left out and says so
elif [ "${1:-}" = plots ]; then
  build+=("${plots[@]}")
elif [ "${1:-}" = python ]; then
  build+=("${python[@]}")
fi

fail() {
  printf '%s: %s\n' "${TYNDALL_SCRIPT:-packages.sh}" "$*" >&2
  exit 1
}

command -v dpkg-query >/dev/null && command -v apt-get >/dev/null ||
  fail "this is not Debian or Ubuntu: install the equivalents of ${build[*]} ${libraries[*]} ${device[*]} yourself"

installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }
known() { [[ "$(LC_ALL=C apt-cache policy "$1" 2>/dev/null)" =~ Candidate:\ [^\(] ]]; }

missing=()
for package in "${build[@]}" "${libraries[@]}" "${device[@]}"; do
  installed "$package" || missing+=("$package")
done
wanted=()
for package in "${optional[@]}"; do
  installed "$package" || wanted+=("$package")
done
# Optional packages that are not to be had are no reason to ask for root: known() decides, on lists that are there.
lists() { compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null; }
if [ ${#wanted[@]} -gt 0 ] && lists; then
  still=()
  for package in "${wanted[@]}"; do
    if known "$package"; then still+=("$package"); fi
  done
  wanted=("${still[@]}")
fi
[ ${#missing[@]} -gt 0 ] || [ ${#wanted[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" != 0 ]; then
  # without a terminal sudo cannot ask for a password
  if command -v sudo >/dev/null && { sudo -n true 2>/dev/null || { [ -t 0 ] && sudo -v; }; }; then
    as_root=(sudo)
  elif [ ${#missing[@]} -eq 0 ]; then
    exit 0
  else
    fail "not root and no sudo; missing packages: ${missing[*]}"
  fi
fi
as_root+=(env DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a)

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() { "${as_root[@]}" apt-get -q -y -o DPkg::Lock::Timeout=300 -o Acquire::Retries=1 "$@" >"$log" 2>&1 </dev/null; }
first_error() { grep -m 1 -E '^(E|W):' "$log" || true; }

update() {
  printf 'Fetching the package lists\n' >&2
  apt update || true # one unreachable third-party list is no reason to stop; a package that is not found is
}

# The lists are fetched when there are none, or when they do not know a package.
updated=no
unknown=no
for package in "${missing[@]}"; do
  known "$package" || unknown=yes
done
if [ $unknown = yes ] || ! lists; then
  update
  updated=yes
fi
for package in "${missing[@]}"; do
  known "$package" ||
    fail "no package $package to be had: is the network up, and (on Ubuntu) the component universe enabled? $(first_error)"
done
for package in "${wanted[@]}"; do
  if known "$package"; then
    missing+=("$package")
  else
    printf 'Not packaged here, left out: %s\n' "$package" >&2
  fi
done
[ ${#missing[@]} -gt 0 ] || exit 0

printf 'Installing %s\n' "${missing[*]}" >&2
if ! apt install --no-install-recommends "${missing[@]}"; then
  # lists that are too old name files that are gone
  if [ $updated = yes ] || { update && ! apt install --no-install-recommends "${missing[@]}"; }; then
    fail "apt-get could not install the packages; is the network up? $(first_error)"
  fi
fi
