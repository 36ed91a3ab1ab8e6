#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Checks the picture of the rooms against the tree: check_rooms.sh ROOT SCRATCH
# Also checks that the check can fail: with another picture, with rooms that include each other in a circle, with 500 lines
# more, and with more lines than agreed.
set -eu

root=$1
scratch=$2

sh "$root/docs/draw_rooms" --check || { echo "run docs/draw_rooms and commit docs/architecture.md" >&2 && exit 1; }

rm -rf "$scratch"
mkdir -p "$scratch/src/edgewise/high" "$scratch/src/edgewise/low" "$scratch/layouts" "$scratch/probes" "$scratch/reports"
echo '#include "edgewise/low/low.hpp"' >"$scratch/src/edgewise/high/high.hpp"
printf '<!-- rooms -->\n<!-- end of rooms -->\n<!-- lines -->\n<!-- end of lines -->\n' >"$scratch/page.md"
export ROOT="$scratch" PAGE="$scratch/page.md"
fail() { echo "draw_rooms: $1" >&2 && exit 1; }

! sh "$root/docs/draw_rooms" --check 2>/dev/null || fail "an empty picture passed"
sh "$root/docs/draw_rooms"
grep -q '^    high --> low$' "$scratch/page.md" || fail "an arrow is missing"
sh "$root/docs/draw_rooms" --check || fail "its own picture failed"
grep -q '^| total | 1 | 1 |$' "$scratch/page.md" || fail "a line is not counted"
! MOST_LINES=0 sh "$root/docs/draw_rooms" --check 2>/dev/null || fail "more lines than agreed passed"
yes '// A line.' | head -n 500 >"$scratch/probes/long.hpp"
! sh "$root/docs/draw_rooms" --check 2>/dev/null || fail "500 lines more passed"
rm "$scratch/probes/long.hpp"
echo '#include "edgewise/high/high.hpp"' >"$scratch/src/edgewise/low/low.hpp"
! sh "$root/docs/draw_rooms" 2>/dev/null || fail "an arrow upwards passed"
