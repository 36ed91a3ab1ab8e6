#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The report's page in a real browser: run.sh EDGEWISE CHROMIUM [AXE]
# Measures a small plan and a scene file into a store of its own, and looks at the page that this writes.
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
folder=$(mktemp -d "${TMPDIR:-/tmp}/edgewise_browser.XXXXXX")
trap 'rm -rf "$folder"' EXIT
"$1" sweep --plan "$here/plan.json" --stability 2 --store "$folder/edgewise.db"
"$1" sweep --plan "$here/plan.json" --scenes "$here/own_bodies.json" --caches all --stability 0 --store "$folder/edgewise.db"
node "$here/report_test.mjs" "$2" "$folder/index.html" "$folder/edgewise.db" "${3:-}"
