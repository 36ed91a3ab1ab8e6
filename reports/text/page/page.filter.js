// What charts, tables, the map and the body show of the bar's choices. An element that does not name a chosen field stays
// as it is.
'use strict';
const filterFields = ['scene', 'shape', 'algorithm', 'precision'];
const filter = {};  // the values that each field may have; nothing where all are shown

// A scene may be named without the parameters that distinguish it from scenes of the same name, unless that is another's.
const isScene = value => [...field('scene').options].some(option => option.value === value);
const isOf = (value, wanted) => value === wanted || (wanted.startsWith(value + ' (') && !isScene(value));
const keepsRow = row => filterFields.every(field => !filter[field] || row[field] === undefined ||
    filter[field].some(wanted => isOf(row[field], wanted)));

// Tables and number of bodies choose scenes.
function chooseFilter() {
    for (const name of ['shape', 'algorithm', 'precision']) filter[name] = asked(name) ? [asked(name)] : null;
    const tables = asked('tables'), bodies = nearestBodies(), options = [...field('scene').options].slice(1);
    const kept = options.filter(({ value, dataset }) => [value, ''].includes(asked('scene')) &&
        (tables === 'both' || tables === dataset.tables) &&
        (bodies === '' || dataset.tables === 'shared' || Number(dataset.bodies) === bodies));
    filter.scene = kept.length === options.length ? null : kept.map(({ value }) => value);
}

// Columns of a table that hold each field, by their titles.
const fieldColumns = { scene: ['scene'], shape: ['shape'], algorithm: ['algorithm', 'algorithm or library'],
                       precision: ['table type', 'table', 'table type or precision', 'precision'] };
const precisionIn = text => text.match(/(?:^|_)(f64|f32|mixed)(?= |$)/)?.[1];

function placesOfFields(titles) {
    const places = {};
    for (const field of filterFields) {
        const place = titles.findIndex(title => fieldColumns[field].includes(title.toLowerCase()));
        if (place >= 0) places[field] = place;
    }
    return places;
}

function keepsCells(places, textAt) {
    const row = {};
    for (const [field, place] of Object.entries(places))
        row[field] = field === 'precision' ? precisionIn(textAt(place)) : textAt(place);
    return keepsRow(row);
}

// Rows that are in the document; where none is left a line says so. The rest of a long table is in the fold after it.
function filterTable(table) {
    if (table.closest('[data-chart]')) return;
    const places = placesOfFields([...table.querySelectorAll('thead th')].map(head => head.textContent));
    if (Object.keys(places).length === 0) return;
    const rows = [...table.querySelectorAll('tbody tr:not(.none)')];
    rows.forEach(row => { row.hidden = !keepsCells(places, place => row.cells[place].textContent); });
    table.querySelector('tr.none')?.remove();
    if (rows.some(row => !row.hidden)) return;
    const isPart = table.closest('.wide')?.parentElement.querySelector('.wide ~ details[data-fold]');
    const none = element('tr', undefined, 'none');
    const cell = element('td', isPart ? 'None of these rows is of what the bar shows; those below have the rest.' : 'Not measured of what the bar shows.');
    cell.colSpan = table.querySelectorAll('thead th').length;
    none.append(cell);
    table.tBodies[0].append(none);
}

// The chart's data and what it shows at first, as the bar has them; null where it has nothing of it. A row without a field
// that others have only keeps a place.
function filteredSpec(spec, rows) {
    const chosen = filterFields.filter(field => filter[field] && rows.some(row => row[field] !== undefined));
    const kept = rows.filter(keepsRow), shown = kept.filter(row => chosen.every(field => row[field] !== undefined));
    if (shown.length === 0) return null;
    const params = spec.params?.map(param => {
        const field = param.name.replace('shown_', '');
        if (!filterFields.includes(field)) return param;
        const options = param.bind.options.filter(option => shown.some(row => row[field] === option));
        return { name: param.name, value: options.includes(param.value) ? param.value : options.at(-1) };
    });
    return { ...spec, data: { ...spec.data, values: kept }, ...(params && { params }) };
}

// Which body or scene a chart of one shows.
function sayShown(place, spec) {
    const line = place.parentElement.nextElementSibling;
    if (!line?.classList.contains('shown')) return;
    const values = spec.params.filter(param => filterFields.includes(param.name.replace('shown_', ''))).map(param => param.value);
    line.textContent = `Shown: ${values.join(', ')}. The bar above shows others.`;
}

function applyFilter() {
    document.querySelectorAll('#break-even svg > g').forEach(place => place.classList.toggle('dim', !keepsRow(
        { shape: place.dataset.shape, ...(place.dataset.scene && { scene: place.dataset.scene }) })));
    document.querySelectorAll('#answer tr[data-scene]').forEach(row => { row.hidden = !keepsRow(row.dataset); });
    document.querySelectorAll('main section:not(#answer) table').forEach(table => {
        if (!table.closest('.long')) filterTable(table);
    });
    LongTable.all.forEach(table => table.search());
    document.querySelectorAll('[data-chart]').forEach(place => place.turn && drawChart(place));
    filterBody();
}
