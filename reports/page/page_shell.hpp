// SPDX-License-Identifier: MIT
//
// The fixed text of the page: its style and the few lines of script that turn specifications into charts.
#pragma once

namespace edgewise::reports {

/// Nothing is loaded from anywhere; scripts and styles only as they stand in the page; no eval.
inline constexpr const char* page_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:";

inline constexpr const char* page_style = R"css(
:root { color-scheme: light; }
body { margin: 0; background: #fff; color: #1c1f23;
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1240px; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 1.75rem; margin: 0 0 .5rem; letter-spacing: -.01em; }
h2 { font-size: 1.25rem; margin: 2.75rem 0 .5rem; padding-bottom: .25rem; border-bottom: 1px solid #dfe3e8; }
h3 { font-size: 1rem; margin: 1.5rem 0 .4rem; }
h4 { font-size: .9375rem; margin: 1.25rem 0 .3rem; color: #3d444d; }
p { max-width: 75ch; margin: .4rem 0 .8rem; }
nav a { margin-right: 1rem; }
a { color: #1a5fa8; }
.verdict { display: inline-block; margin: .6rem 0; padding: .45rem .9rem; border-radius: 6px;
  font-weight: 600; max-width: none; background: #e7f4ea; color: #14532d; border: 1px solid #b8dfc2; }
.verdict.bad { background: #fdecea; color: #7f1d1d; border-color: #f3c1bb; }
.verdict.part { background: #fff6e0; color: #6b4a00; border-color: #ecd9a4; }
.note { color: #5a626c; font-size: .875rem; max-width: 95ch; }
.wide { overflow-x: auto; margin: .5rem 0; }
sup { line-height: 0; }
table { border-collapse: collapse; font-size: .8125rem; line-height: 1.35; }
caption { text-align: left; color: #5a626c; padding: 0 0 .35rem; white-space: nowrap; }
th, td { text-align: left; padding: .22rem .55rem; border-bottom: 1px solid #eceff2; vertical-align: top; }
th { font-weight: 600; background: #f6f8fa; border-bottom: 1px solid #cfd6dd; vertical-align: bottom; }
th.number, td.number { text-align: right; }
td.number { font-variant-numeric: tabular-nums; white-space: nowrap; }
td { max-width: 36rem; }
td:not(:last-child) { white-space: nowrap; max-width: none; }
td.missing { color: #8a5a00; font-style: italic; white-space: nowrap; }
tbody tr:hover { background: #f6f8fa; }
.facts td:first-child { white-space: nowrap; color: #5a626c; }
.facts td { overflow-wrap: anywhere; max-width: none; }
.reasons { color: #5a626c; font-size: .8125rem; margin: .2rem 0 1rem; padding-left: 1.8rem; }
details { margin: .6rem 0; }
summary { cursor: pointer; color: #1a5fa8; }
.chart { overflow-x: auto; margin: .6rem 0 .4rem; }
.chart svg { max-width: none; }
.vega-bindings { margin: .3rem 0; font-size: .875rem; }
@media print { details > *:not(summary) { display: none; } main { max-width: none; padding: 0; } }
)css";

/// The fallback inside each element stays until its chart is drawn, and comes back when that fails.
inline constexpr const char* page_script = R"js(
document.querySelectorAll('script[type="application/json"][data-chart]').forEach(source => {
    const element = document.getElementById('chart-' + source.dataset.chart);
    const fallback = element.innerHTML;
    const options = { mode: 'vega-lite', renderer: 'svg', ast: true, tooltip: { theme: 'light' },
                      actions: { export: true, source: false, compiled: false, editor: false } };
    vegaEmbed(element, JSON.parse(source.textContent), options).catch(failure => {
        element.innerHTML = fallback;
        element.insertAdjacentText('beforebegin', 'This chart could not be drawn: ' + failure.message);
        console.error(failure);
    });
});
)js";

}  // namespace edgewise::reports
