// SPDX-License-Identifier: MIT
//
// Draws charts without a browser: node render_svg.mjs BUNDLES FIGURES NAME...
// reads FIGURES/NAME.vl.json and writes FIGURES/NAME.svg, with nothing but the bundles that the page inlines.
import { readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { runInThisContext } from 'node:vm';

if (Number(process.versions.node.split('.')[0]) < 18) {
    console.error('node 18 or newer is needed');
    process.exit(3);
}
const [bundles, figures, ...names] = process.argv.slice(2);
// Run as plain scripts: in a module's scope the bundles would look for packages that are not installed.
for (const bundle of ['vega.min.js', 'vega-lite.min.js'])
    runInThisContext(readFileSync(join(bundles, bundle), 'utf8'), bundle);

for (const name of names) {
    const spec = JSON.parse(readFileSync(join(figures, name + '.vl.json'), 'utf8'));
    const view = new vega.View(vega.parse(vegaLite.compile(spec).spec), { renderer: 'none' });
    view.logLevel(vega.Error);
    const svg = await view.toSVG();
    // Several pictures share one page: without a prefix a clip path would be the first picture's.
    const apart = svg.replace(/(id="|url\(#)(?=clip|gradient)/g, '$1' + name + '_');
    const file = join(figures, name + '.svg');
    writeFileSync(file + '.tmp', apart + '\n');
    renameSync(file + '.tmp', file);
}
