#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Tyndall authors
# SPDX-License-Identifier: Apache-2.0
#
# tests/run.sh [CTEST ARGUMENT...]: installs what is missing, builds with warnings as errors, and runs the test suite. With
# arguments they go to ctest (tests/run.sh -L quick); without, the whole suite runs, and then the labels unit and
# bad-input once more under AddressSanitizer and UndefinedBehaviorSanitizer.
set -euo pipefail
cd "$(dirname "$0")/.."

say() { printf '== %s\n' "$*"; }
TYNDALL_SCRIPT=run.sh bash samples/packages.sh tests

# The independent programs of tests/peers and what tests/python needs, in a virtual environment that is made anew when the
# lists change. Without them their tests are disabled, which is no failure: PyPI may be out of reach.
peers() {
  local wanted
  wanted=$(sort -u tests/peers/requirements.txt tests/python/requirements.txt | grep -v '^#')
  [ "$wanted" != "$(cat build/peers/requirements.txt 2>/dev/null)" ] || return 0
  say "install tests/peers/requirements.txt and tests/python/requirements.txt"
  rm -rf build/peers
  mkdir -p build
  if python3 -m venv build/peers &&
    build/peers/bin/python -m pip install --quiet --disable-pip-version-check --retries 1 --timeout 20 -r <(echo "$wanted"); then
    echo "$wanted" >build/peers/requirements.txt
  else
    echo "Not installed (see build/peers.log): the tests that need packages of PyPI are left out. Is the network up?"
  fi >build/peers.log 2>&1
  tail -n 1 build/peers.log
}
peers

jobs=$(nproc)
# build PRESET [TARGET...]: the log is shown when it fails
build() {
  local preset=$1 log=build/$1.log fresh=
  shift
  mkdir -p build
  say "build $preset"
  # a tree made by another generator, or for a checkout that stood elsewhere, starts again
  if [ ! -f "build/$preset/build.ninja" ] ||
    ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "build/$preset/CMakeCache.txt"; then
    fresh=--fresh
  fi
  { cmake $fresh --preset "$preset" -G Ninja && cmake --build "build/$preset" -j "$jobs" ${1:+--target "$@"}; } >"$log" 2>&1 ||
    { grep -E 'error|Error|FAILED' "$log" | head -n 5 || true; tail -n 60 "$log"; return 1; }
  grep -E '^-- .*(left out|disabled)' "$log" || true
}
# suite PRESET CTEST_ARGUMENT...: a suite without a test is a failure
suite() {
  local preset=$1
  shift
  say "ctest $preset $*"
  ctest --test-dir "build/$preset" --output-on-failure --no-tests=error -j "$jobs" "$@"
}

build ci
if [ $# -gt 0 ]; then
  suite ci "$@"
  exit
fi

# Both suites run even if the first fails; the summaries stand together at the end. With sanitizers a test has three tries,
# since LeakSanitizer's tracer dies now and then beside a driver's threads at exit; and what compares bits that the device made
# has nothing for them to see.
rm -f build/*-tests.log
result=0
suite ci 2>&1 | tee build/ci-tests.log || result=1
{ build asan test-unit test-bad_input minimal && suite asan -L '^(unit|bad-input)$' -E 'DistanceGridWalk|Thoroughly' --repeat until-pass:3 2>&1 | tee build/asan-tests.log; } ||
  result=1

# summary PRESET: ctest's verdict, without the times of the labels
summary() {
  if [ -f "build/$1-tests.log" ]; then
    sed -n '/% tests passed/,$p' "build/$1-tests.log" | grep -vE '^$|^Label Time|sec\*proc' || true
  else
    echo "not built"
  fi
}
say "unit and bad-input with sanitizers"
summary asan
say "the whole suite"
summary ci
exit $result
