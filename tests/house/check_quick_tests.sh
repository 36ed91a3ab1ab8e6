#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Checks that what tests/run quick builds waits for the table types of few layouts alone: check_quick_tests.sh NINJA BUILD
# Waiting for all of them took 6m34 after an edit of an algorithm, instead of 2m35.
set -eu

# Objects of table types that the program TARGET, or what it depends on, is built from.
table_types_of() { # TARGET
    "$ninja" -C "$build" -t inputs "$1" | sed -nE 's,^(.*/)?CMakeFiles/(edgewise_[a-z_]*_table_types)[.]dir/.*,\2,p' | sort -u
}

ninja=$1
build=$2
few=$(table_types_of quick_tests)
[ "$few" = edgewise_few_tool_table_types ] || { echo "quick_tests wait for: $few" >&2 && exit 1; }
[ "$(table_types_of golden_answers | wc -l)" -gt 1 ] || { echo "the table types of golden_answers are not seen" >&2 && exit 1; }
