#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Configures and builds a preset: build_preset.sh PRESET [TARGET...]
# Environment: EDGEWISE_LAYOUTS builds the named layouts only ("": all layouts); EDGEWISE_EVERY_LAYOUT=OFF: the program has
# the table types of plan quick and for boxes, tests have the others; EDGEWISE_FULL_TESTS=ON adds the tests that only
# tests/run full has; EDGEWISE_PEERS=ON adds adapters of other libraries; EDGEWISE_PEER_FOLDERS: folders of libraries without
# a package.
# Variables that are not set keep their last value. On a terminal the build shows each step; otherwise it prints a line
# per minute. All output goes to stderr.
set -eu
exec 1>&2

preset=${1:?usage: build_preset.sh PRESET [TARGET...]}
shift
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
folder=$root/build/$preset
log=$folder/configure.log
mkdir -p "$folder"

echo "build: $preset"
targets=$*
set --
for name in EDGEWISE_LAYOUTS EDGEWISE_EVERY_LAYOUT EDGEWISE_FULL_TESTS EDGEWISE_PEERS EDGEWISE_PEER_FOLDERS; do
    eval "[ -z \"\${$name+set}\" ] || set -- \"\$@\" \"-D$name=\$$name\""
done
if ! cmake -S "$root" --preset "$preset" "$@" >"$log" 2>&1; then
    cat "$log"
    echo "build: cmake could not configure preset $preset (its output is above, and in $log)"
    exit 2
fi
# The configuring step has printed one line for each missing tool that is not essential.
grep -E '^-- (charts|edgewise|house):' "$log" || true

# Reads "[17/242] Building ..." of ninja, and prints how many steps are done and, from a tenth of them on, how long the others will
# take: the first steps are the longest.
print_progress() { # LOG STARTED
    sed -n 's/^\[\([0-9]*\)\/\([0-9]*\)\].*/\1 \2/p' "$1" | tail -n 1 | {
        read -r done all && [ "$done" -gt 0 ] || exit 0
        seconds=$(($(date +%s) - $2))
        left=
        [ $((done * 10)) -lt "$all" ] || left=", about $((seconds * (all - done) / done / 60 + 1)) min left"
        echo "build: $done of $all steps in $((seconds / 60)) min$left"
    }
}

# shellcheck disable=SC2086 # names of targets
set -- ${targets:+--target $targets}
log=$folder/build.log
code=0
if [ -t 2 ]; then
    cmake --build "$folder" -j "$(nproc)" "$@" || code=$?
else
    started=$(date +%s)
    cmake --build "$folder" -j "$(nproc)" "$@" >"$log" 2>&1 &
    builder=$!
    trap 'kill $builder 2>/dev/null' INT TERM
    while kill -0 $builder 2>/dev/null; do
        waited=0
        while [ $waited -lt 60 ] && kill -0 $builder 2>/dev/null; do
            sleep 1
            waited=$((waited + 1))
        done
        [ $waited -lt 60 ] || print_progress "$log" "$started"
    done
    wait $builder || code=$?
    [ $code -eq 0 ] || grep -v '^\[[0-9]*/[0-9]*\] [BLG]' "$log"
fi
if [ $code -ne 0 ]; then
    echo "build: preset $preset does not build (the compiler's messages are above)"
    exit 2
fi
