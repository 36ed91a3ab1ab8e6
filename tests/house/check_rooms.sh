#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The picture of the rooms is the tree's: check_rooms.sh ROOT SCRATCH
# Also that the check can fail: on a page with another picture, and on rooms that include each other in a circle.
set -eu

root=$1
scratch=$2

sh "$root/docs/draw_rooms" --check || { echo "run docs/draw_rooms and commit docs/architecture.md" >&2 && exit 1; }

rm -rf "$scratch"
mkdir -p "$scratch/src/edgewise/high" "$scratch/src/edgewise/low" "$scratch/layouts" "$scratch/probes" "$scratch/reports"
echo '#include "edgewise/low/low.hpp"' >"$scratch/src/edgewise/high/high.hpp"
printf '<!-- rooms -->\n<!-- end of rooms -->\n' >"$scratch/page.md"
export ROOT="$scratch" PAGE="$scratch/page.md"
fail() { echo "draw_rooms: $1" >&2 && exit 1; }

! sh "$root/docs/draw_rooms" --check 2>/dev/null || fail "an empty picture passed"
sh "$root/docs/draw_rooms"
grep -q '^    high --> low$' "$scratch/page.md" || fail "an arrow is missing"
sh "$root/docs/draw_rooms" --check || fail "its own picture failed"
echo '#include "edgewise/high/high.hpp"' >"$scratch/src/edgewise/low/low.hpp"
! sh "$root/docs/draw_rooms" 2>/dev/null || fail "an arrow upwards passed"
