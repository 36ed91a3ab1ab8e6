#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Configures and builds a preset: build_preset.sh PRESET [TARGET...]
# Quiet while all is well, unless somebody watches: then the build shows its progress. All output goes to stderr.
set -eu
exec 1>&2

preset=${1:?usage: build_preset.sh PRESET [TARGET...]}
shift
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
folder=$root/build/$preset
log=$folder/configure.log
mkdir -p "$folder"

echo "build: $preset"
if ! cmake -S "$root" --preset "$preset" >"$log" 2>&1; then
    cat "$log"
    echo "build: cmake could not configure preset $preset (its output is above, and in $log)"
    exit 2
fi
# What is missing but not essential: the configuring step says so in one line each.
grep -E '^-- (charts|edgewise|house):' "$log" || true

[ $# -eq 0 ] || set -- --target "$@"
watched=
[ -t 2 ] || watched=--quiet
# shellcheck disable=SC2086  # nothing when watched is empty
if ! cmake --build "$folder" -j "$(nproc)" "$@" -- $watched; then
    echo "build: preset $preset does not build (the compiler's messages are above)"
    exit 2
fi
