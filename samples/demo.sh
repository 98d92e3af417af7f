#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# samples/demo.sh: from a fresh checkout to a picture. Installs what is missing (Debian 12 and 13, Ubuntu 24.04; as root or
# with sudo), builds the tools, makes the demo scene and renders it into demo/. What is done is not done again.
# Arguments are handed to tyndall-render: samples/demo.sh --spp 256 --width 1920 --height 1080. Without any, it renders
# 64 samples a pixel, or what fits into a minute and a half with the building.
set -euo pipefail
cd "$(dirname "$0")/.."

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "demo.sh: $*"
  exit 1
}
[ "${1:-}" != --help ] || { sed -n '5,8s/^# //p' "$0"; exit 0; }

TYNDALL_SCRIPT=demo.sh bash samples/packages.sh
SECONDS=0 # bash counts from here

build=build/demo
log=$build/log.txt
mkdir -p "$build" demo
if [ ! -f $build/build.ninja ] || ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" $build/CMakeCache.txt; then
  say "Configuring in $build"
  cmake --fresh --preset demo -G Ninja >"$log" 2>&1 || {
    tail -n 20 "$log" >&2
    fail "configuring failed; all of it is in $log"
  }
fi
if [ ! -f $build/built ] || [ -n "$(find CMakeLists.txt cmake lib kernels samples -newer $build/built -type f -print -quit)" ]; then
  say "Building"
fi
cmake --build $build --target tyndall-render tyndall-demo-scene >"$log" 2>&1 || {
  tail -n 20 "$log" >&2
  fail "building failed; all of it is in $log"
}
touch $build/built

# A stamp holds the checksums of what went into the pictures; they are made again when it no longer fits.
programs=("$build"/bin/tyndall-render "$build"/bin/tyndall-demo-scene "$build"/lib/libtyndall.so "$build"/lib/libtyndall-io.so)
options=("$@")
stamp=$(cksum "${programs[@]}" | cksum; echo "$*")
if [ ! -f demo/demo.exr ] || [ ! -f demo/demo.png ] || [ "$(cat demo/stamp 2>/dev/null)" != "$stamp" ]; then
  rm -f demo/stamp
  say "Making the scene"
  "$build/bin/tyndall-demo-scene" demo/demo.glb || fail "the scene was not made"
  say "Rendering"
  left=$((80 - SECONDS))
  [ $# -gt 0 ] || options=(--spp 64 --time-limit $((left > 10 ? left : 10)))
  [[ " $* " == *" --tone"* ]] || options+=(--tone aces)
  status=0
  "$build/bin/tyndall-render" demo/demo.glb -o demo/demo.exr --png demo/demo.png "${options[@]}" || status=$?
  [ $status = 0 ] || exit $status # tyndall-render has said why
  printf '%s\n' "$stamp" >demo/stamp
else
  say "Nothing has changed since the last run"
fi
say "The image:   $PWD/demo/demo.exr (OpenEXR, all layers)"
say "To look at:  $PWD/demo/demo.png"
[ $# -gt 0 ] || say "Less noise:  samples/demo.sh --spp 400"
