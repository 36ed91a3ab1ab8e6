// The bar over the chapters: charts, tables and the map then show only one scene, body, algorithm or precision.
// An element that does not name the chosen field stays as it is.
'use strict';
const filterFields = ['scene', 'shape', 'algorithm', 'precision'];
const filter = {};

// A scene may be named without the parameters that distinguish it from scenes of the same name.
const isOf = (value, wanted) => value === wanted || wanted.startsWith(value + ' (');
const keepsRow = row => filterFields.every(field => !filter[field] || row[field] === undefined || isOf(row[field], filter[field]));

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

// Rows that are in the document; where none is left a line says so.
function filterTable(table) {
    const places = placesOfFields([...table.querySelectorAll('thead th')].map(head => head.textContent));
    if (Object.keys(places).length === 0) return;
    const rows = [...table.querySelectorAll('tbody tr:not(.none)')];
    rows.forEach(row => { row.hidden = !keepsCells(places, place => row.cells[place].textContent); });
    table.querySelector('tr.none')?.remove();
    if (rows.some(row => !row.hidden)) return;
    const none = element('tr', undefined, 'none'), cell = element('td', 'None of these rows is of what is shown.');
    cell.colSpan = table.querySelectorAll('thead th').length;
    none.append(cell);
    table.tBodies[0].append(none);
}

// The chart's data and its own choices, as the bar has them; null where it has nothing of it. A row without a field that
// others have only keeps a place.
function filteredSpec(spec, rows) {
    const chosen = filterFields.filter(field => filter[field] && rows.some(row => row[field] !== undefined));
    const kept = rows.filter(keepsRow), shown = kept.filter(row => chosen.every(field => row[field] !== undefined));
    if (shown.length === 0) return null;
    const params = spec.params?.map(param => {
        const field = param.name.replace('shown_', '');
        if (!filterFields.includes(field) || !param.bind?.options) return param;
        const options = param.bind.options.filter(option => shown.some(row => row[field] === option));
        return { ...param, value: options.includes(param.value) ? param.value : options.at(-1), bind: { ...param.bind, options } };
    });
    return { ...spec, data: { ...spec.data, values: kept }, ...(params && { params }) };
}

function filterMap() {
    document.querySelectorAll('#break-even svg > g').forEach(place => place.classList.toggle('dim', !keepsRow(
        { shape: place.dataset.shape, ...(place.dataset.scene && { scene: place.dataset.scene }) })));
}

function applyFilter() {
    for (const field of filterFields) filter[field] = document.getElementById('filter-' + field).value;
    const said = filterFields.map(field => filter[field]).filter(Boolean).join(', ');
    document.getElementById('filter-said').textContent = said ? 'Charts and tables below show ' + said + ' alone.' : '';
    document.querySelectorAll('main section:not(#answer) table').forEach(table => {
        if (!table.closest('.long')) filterTable(table);
    });
    LongTable.all.forEach(table => table.search());
    document.querySelectorAll('[data-chart]').forEach(place => place.turn && drawChart(place));
    filterMap();
}

function startFilter() {
    const form = document.getElementById('filter');
    if (!form) return;
    form.hidden = false;
    form.addEventListener('submit', event => event.preventDefault());
    form.addEventListener('change', applyFilter);
    form.addEventListener('reset', () => setTimeout(applyFilter));
}
