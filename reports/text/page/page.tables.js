// Tables of any length: visible rows are in the document; two empty rows are as high as the rows before and after.
// A grid is columns of cells; a cell is its text, or its text and why there is no value.
'use strict';
const rowHeight = 24, rowsInSight = 40;

const textOf = cell => Array.isArray(cell) ? cell[0] : cell;
const whyOf = cell => Array.isArray(cell) ? cell[1] : '';

// What is no number among numbers comes last in both orders.
function compareCells(a, b, down) {
    const [x, y] = [parseFloat(textOf(a)), parseFloat(textOf(b))];
    if (Number.isNaN(x) !== Number.isNaN(y)) return Number.isNaN(x) ? 1 : -1;
    return (down ? -1 : 1) * (Number.isNaN(x) ? textOf(a).localeCompare(textOf(b)) : x - y);
}

function cellElement(cell, isNumber) {
    const made = element('td', textOf(cell), isNumber ? 'number' : '');
    if (whyOf(cell)) {
        made.classList.add('missing');
        made.title = whyOf(cell);
        made.append(element('span', ': ' + whyOf(cell), 'unseen'));
    }
    return made;
}

class LongTable {
    static all = [];

    constructor(grid, onRow) {
        this.grid = grid;
        this.onRow = onRow;
        this.words = [];
        this.places = placesOfFields(grid.columns.map(([title]) => title));
        this.body = element('tbody');
        this.box = element('div', undefined, 'long');
        this.box.tabIndex = 0;
        this.box.setAttribute('role', 'group');
        this.box.setAttribute('aria-label', grid.caption || 'table');
        const table = element('table');
        table.append(this.head(), this.body);
        this.box.append(table);
        this.box.addEventListener('scroll', () => this.draw());
        this.count = element('span', '', 'note');
        this.search();
        LongTable.all.push(this);
    }

    head() {
        const row = element('tr');
        this.grid.columns.forEach(([title, isNumber], column) => {
            const cell = element('th', undefined, isNumber ? 'number' : '');
            const button = element('button', title);
            button.type = 'button';
            cell.scope = 'col';
            button.addEventListener('click', () => this.sort(column, cell));
            cell.append(button);
            row.append(cell);
        });
        const head = element('thead');
        head.append(row);
        return head;
    }

    sort(column, cell) {
        const down = cell.getAttribute('aria-sort') === 'ascending';
        this.box.querySelectorAll('th').forEach(other => other.removeAttribute('aria-sort'));
        cell.setAttribute('aria-sort', down ? 'descending' : 'ascending');
        this.sorted = { cells: this.grid.cells[column], down };
        this.keepOrder();
        this.draw();
    }

    keepOrder() {
        if (!this.sorted) return;
        const { cells, down } = this.sorted;
        this.order.sort((a, b) => compareCells(cells[a], cells[b], down));
    }

    /// The rows with all these words that the bar keeps; without an argument, the words of the last search.
    search(words) {
        if (words !== undefined) this.words = words.toLowerCase().split(/\s+/).filter(Boolean);
        const rows = this.grid.cells[0]?.length ?? 0;
        const text = i => this.grid.cells.map(column => textOf(column[i])).join(' ').toLowerCase();
        this.order = Array.from({ length: rows }, (_, i) => i)
            .filter(i => keepsCells(this.places, place => textOf(this.grid.cells[place][i])))
            .filter(i => this.words.length === 0 || this.words.every(word => text(i).includes(word)));
        this.keepOrder();
        this.box.scrollTop = 0;
        this.draw();
    }

    draw() {
        const most = Math.max(0, this.order.length - rowsInSight);
        const first = Math.min(most, Math.max(0, Math.floor(this.box.scrollTop / rowHeight) - 8));
        const shown = this.order.slice(first, first + rowsInSight);
        const gap = rows => {
            const row = element('tr', undefined, 'gap');
            row.style.height = rows * rowHeight + 'px';
            return row;
        };
        this.body.replaceChildren(gap(first), ...shown.map(i => this.row(i)),
                                  gap(this.order.length - first - shown.length));
        this.count.textContent = this.order.length + ' rows';
    }

    row(i) {
        const row = element('tr');
        this.grid.cells.forEach((column, place) =>
            row.append(cellElement(column[i], this.grid.columns[place][1])));
        if (this.onRow) this.onRow(row, i);
        return row;
    }
}

function searchBox(table, label) {
    const field = element('input');
    field.type = 'search';
    field.placeholder = 'search rows';
    field.setAttribute('aria-label', 'search rows of ' + label);
    field.addEventListener('input', () => table.search(field.value));
    return field;
}

function gridElement(grid) {
    const figure = element('div', undefined, 'grid');
    if (grid.caption) figure.append(element('p', grid.caption, 'note'));
    const table = new LongTable(grid);
    if ((grid.cells[0]?.length ?? 0) > 12) figure.append(searchBox(table, grid.caption || 'this table'), table.count);
    figure.append(table.box);
    return figure;
}
