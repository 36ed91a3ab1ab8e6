// The page without this script is complete in its statements; with it charts become interactive when they scroll into view,
// long tables are made when they are opened, and the question can be changed. Packed data is unpacked
// once, when it is first needed.
'use strict';
const packed = new Map();

function unpack(id) {
    if (!packed.has(id)) {
        packed.set(id, (async () => {
            const bytes = Uint8Array.from(atob(document.getElementById('packed-' + id).textContent), c => c.charCodeAt(0));
            const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip')).getReader();
            const decoder = new TextDecoder();
            let text = '';
            for (;;) {
                const { done, value } = await reader.read();
                if (done) return text + decoder.decode();
                text += decoder.decode(value, { stream: true });
            }
        })());
    }
    return packed.get(id);
}
const unpackJson = id => unpack(id).then(JSON.parse);

function element(name, text, style) {
    const made = document.createElement(name);
    if (text !== undefined) made.textContent = text;
    if (style) made.className = style;
    return made;
}

// Scripts of blobs, one after the other: each looks for the one before.
let bundles = null;
function loadBundles() {
    bundles ??= ['vega', 'vega-lite', 'vega-embed'].reduce((before, name) => before.then(async () => {
        const url = URL.createObjectURL(new Blob([await unpack('bundle-' + name)], { type: 'text/javascript' }));
        await new Promise((done, failed) => {
            const script = element('script');
            script.src = url;
            script.onload = done;
            script.onerror = () => failed(new Error(name + ' did not load'));
            document.head.append(script);
        });
        URL.revokeObjectURL(url);
    }), Promise.resolve());
    return bundles;
}

function rowsOf(values) {
    const fields = Object.entries(values.columns);
    return Array.from({ length: values.rows }, (_, i) => {
        const row = {};
        for (const [field, column] of fields) if (column[i] !== null) row[field] = column[i];
        return row;
    });
}

// Again whenever the bar changes: only the last time counts.
async function drawChart(place) {
    const still = place.innerHTML, turn = place.turn = (place.turn ?? 0) + 1;
    delete place.dataset.drawn;
    try {
        const [charts] = await Promise.all([unpackJson('charts'), loadBundles()]);
        if (turn !== place.turn) return;
        const whole = charts[place.dataset.chart];
        if (whole.data?.values?.columns) whole.data.values = rowsOf(whole.data.values);
        const spec = Array.isArray(whole.data?.values) ? filteredSpec(whole, whole.data.values) : whole;
        place.view?.finalize();
        if (place.turn > 1) place.style.minHeight = '';
        if (!spec) {
            place.replaceChildren(element('p', 'Not measured of what the bar shows.', 'note'));
            place.dataset.drawn = '';
            return;
        }
        const options = { mode: 'vega-lite', renderer: 'svg', ast: true, tooltip: { theme: 'custom', disableDefaultStyle: true },
                          actions: { export: true, source: false, compiled: false, editor: false },
                          logLevel: vega.Error };  // that a layer has no point is no warning
        place.view = (await vegaEmbed(place, spec, options)).view;
        place.querySelectorAll('summary').forEach(menu => menu.setAttribute('aria-label', 'Save this chart'));
        place.querySelector('svg')?.setAttribute('aria-label', place.dataset.label);
        sayShown(place, spec);
        place.dataset.drawn = '';
    } catch (failure) {
        place.innerHTML = still;
        place.insertAdjacentText('beforebegin', 'This chart could not be drawn: ' + failure.message);
        console.error(failure);
    }
}

function startCharts() {
    if (!document.getElementById('packed-bundle-vega')) return;
    const near = new IntersectionObserver(entries => entries.filter(entry => entry.isIntersecting).forEach(entry => {
        near.unobserve(entry.target);
        drawChart(entry.target);
    }), { rootMargin: '400px' });
    document.querySelectorAll('[data-chart]').forEach(place => near.observe(place));
}

function startFolds() {
    document.querySelectorAll('details[data-fold]').forEach(fold => fold.addEventListener('toggle', async () => {
        if (!fold.open || fold.dataset.made !== undefined) return;
        fold.dataset.made = '';
        const content = (await unpackJson('folds'))[fold.dataset.fold];
        const body = element('div');
        body.innerHTML = content.html;
        const grids = await unpackJson('grids');
        content.grids.forEach(place => body.append(gridElement(grids[place])));
        fold.querySelector('.waiting').replaceWith(body);
    }));
}

// A box that has nothing to scroll is no stop of the tabulator, until the window is narrower.
let scrollBoxes = null;
function startScrollBoxes(within = document) {
    scrollBoxes ??= new ResizeObserver(entries => entries.forEach(({ target }) => {
        target.tabIndex = target.scrollWidth > target.clientWidth ? 0 : -1;
    }));
    within.querySelectorAll('.wide, .chart').forEach(box => scrollBoxes.observe(box));
}

function startPage() {
    document.documentElement.classList.add('alive');
    startCharts();
    startFolds();
    startScrollBoxes();
    startBody();
    startQuestion();
    startCells();
}

document.addEventListener('DOMContentLoaded', () => {
    if ('DecompressionStream' in window && 'IntersectionObserver' in window) startPage();
    else document.getElementById('ask').hidden = true;
});
