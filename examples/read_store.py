#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reads one figure of a store with Python's own sqlite3, and plots it as bars of text.

read_store.py STORE [FIGURE]: for example `read_store.py mine.db bytes.total_bytes_per_edge`. A line for each verified
cell: scene, shape, algorithm, table type, value and unit. `edgewise list figures` names the figures.
"""
import sqlite3
import sys

QUERY = """
select cell.scene, cell.shape, cell.algorithm, cell.table_type, figure.value, figure.unit
from cell join figure using (build, hash)
where cell.build = (select value from meta where key = 'build') and cell.run = 'sweep' and cell.status = 'verified'
  and figure.probe = ? and figure.name = ? and figure.value is not null
order by cell.scene, cell.shape, figure.value, cell.algorithm, cell.table_type
"""


def main(arguments):
    if len(arguments) not in (1, 2):
        print(__doc__, file=sys.stderr)
        return 2
    probe, _, name = (arguments[1:] or ["lines.lines_per_query"])[0].partition(".")
    store = sqlite3.connect(f"file:{arguments[0]}?mode=ro", uri=True)
    rows = store.execute(QUERY, (probe, name)).fetchall()
    most = max((row[4] for row in rows), default=0)
    for *words, value, unit in rows:
        bar = "#" * round(40 * value / most) if most > 0 else ""
        print(*words, f"{value:.6g}", unit, bar)
    if not rows:
        print(f"{arguments[0]}: no verified cell has a figure {probe}.{name}", file=sys.stderr)
    return 0 if rows else 1


sys.exit(main(sys.argv[1:]))
