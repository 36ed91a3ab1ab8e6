// All cells of the store, with every figure: a table of the cells that match a search, and a card for one cell, which
// has an address (#cell=...).
'use strict';
const headline = ['time.all_ns', 'time.all_ratio', 'bytes.total_bytes_per_edge', 'lines.lines_per_query',
                  'error.worst_error_given'];
const identity = ['scene', 'shape', 'algorithm', 'table', 'status'];

// Each figure with a value for every cell; undefined where a cell has no such figure.
let unpackedCells = null;
function storeCells() {
    unpackedCells ??= unpackJson('cells').then(store => {
        for (const figure of store.figures) {
            if (!figure.at) continue;
            const values = [];
            figure.at.forEach((place, i) => { values[place] = figure.values[i]; });
            figure.values = values;
        }
        return store;
    });
    return unpackedCells;
}

const shownNumber = value => value === null || value === undefined ? '' : String(Number(value.toPrecision(4)));

function figureCell(store, figure, i) {
    const value = figure?.values[i];
    if (typeof value === 'number') return shownNumber(value);
    return typeof value === 'string' ? ['not measured', store.reasons[value]] : ['not measured', 'no such figure'];
}

function cellsGrid(store) {
    const figures = headline.map(name => store.figures.find(figure => figure.name === name));
    const rows = store.cells.cell.length;
    const column = get => Array.from({ length: rows }, (_, i) => get(i));
    return {
        caption: 'all cells and rows',
        columns: [...identity.map(name => [name, false]), ...headline.map(name => [name.split('.')[1], true])],
        cells: [...identity.map(name => column(i => store.cells[name][i])),
                ...figures.map(figure => column(i => figureCell(store, figure, i)))],
    };
}

function cellCard(store, i) {
    const card = element('section', undefined, 'card');
    const cells = store.cells;
    card.append(element('h3', `${cells.scene[i]}, ${cells.shape[i]}: ${cells.algorithm[i]} on ${cells.table[i]}`));
    card.append(element('p', `${cells.status[i]}${cells.reason[i] ? ': ' + cells.reason[i] : ''}; ` +
                             `${cells.vertices[i]} vertices, ${cells.edges[i]} edges, ${cells.queries[i]} queries; ` +
                             `cell ${cells.cell[i]}`, 'note'));
    const present = store.figures.filter(figure => figure.values[i] !== null && figure.values[i] !== undefined);
    card.append(gridElement({
        caption: 'figures of this cell',
        columns: [['figure', false], ['value', true], ['unit', false]],
        cells: [present.map(figure => figure.name),
                present.map(figure => typeof figure.values[i] === 'number' ? String(figure.values[i])
                                                                           : figureCell(store, figure, i)),
                present.map(figure => figure.unit)],
    }));
    return card;
}

async function showCell() {
    const wanted = new URLSearchParams(location.hash.slice(1)).get('cell')?.slice(0, 12);
    if (!wanted) return;
    const store = await storeCells();
    const place = document.getElementById('card'), i = store.cells.cell.indexOf(wanted);
    place.replaceChildren(i < 0 ? element('p', 'This store has no cell ' + wanted) : cellCard(store, i));
    place.scrollIntoView();
}

async function openCells(fold) {
    const store = await storeCells();
    const table = new LongTable(cellsGrid(store), (row, i) => {
        const link = element('a', row.firstChild.textContent);
        link.href = '#cell=' + store.cells.cell[i];
        row.firstChild.replaceChildren(link);
    });
    fold.querySelector('.waiting').replaceWith(searchBox(table, 'all cells'), table.count, table.box);
}

function startCells() {
    const fold = document.getElementById('all-cells');
    fold?.addEventListener('toggle', () => {
        if (fold.open && fold.querySelector('.waiting')) openCells(fold);
    });
    window.addEventListener('hashchange', showCell);
    showCell();
}
