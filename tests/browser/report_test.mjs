// SPDX-License-Identifier: MIT
//
// The report's page as a reader meets it, in a real browser: node report_test.mjs CHROMIUM INDEX.html STORE [AXE]
// STORE is the SQLite file that the page is of. AXE, the file axe.min.js of npm's axe-core, is optional: without it the
// accessibility checks below are all, and that is said. Prints a line for each check; exits 1 where one fails.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { bodyTurns, walkSteps } from './body_checks.mjs';
import { Browser } from './browser.mjs';

const [chromium, html, store, axe] = process.argv.slice(2);
const url = 'file://' + html;
let failures = 0;

function check(what, right, seen = '') {
    console.log(`${right ? 'ok  ' : 'FAIL'} ${what}${seen === '' ? '' : ': ' + seen}`);
    if (!right) ++failures;
}

const rowsOf = sql => execFileSync('sqlite3', ['-readonly', '-json', store, sql], { maxBuffer: 1 << 30, encoding: 'utf8' });
const query = sql => JSON.parse(rowsOf(sql) || '[]');

const charts = `[...document.querySelectorAll('[data-chart]')]`;

async function drawAll(page) {
    const names = await page.value(`${charts}.map(place => place.dataset.chart)`);
    for (let i = 0; i < names.length; ++i) {
        await page.value(`${charts}[${i}].scrollIntoView()`);
        await page.until(`${charts}[${i}].dataset.drawn !== undefined`);
    }
    return names;
}

async function looksRight(browser) {
    const page = await browser.open();
    await page.go(url);
    const bytes = statSync(html).size;
    check('the page has at most 1.6 MB', bytes <= 1.6e6, bytes + ' bytes');
    const dom = await page.value(`document.querySelectorAll('*').length`);
    check('and fewer than 8000 elements', dom < 8000, dom);
    const title = await page.value(`document.querySelector('h1').textContent`);
    check('it opens with the question', title.startsWith('Which layout'), title);
    check('the answer is in the first screen',
          await page.value(`document.querySelector('.decision tbody tr').getBoundingClientRect().bottom < 900`));
    check('all contenders are one click away', await page.value(`(() => { const fold = document.querySelector('#answer .contest');
        const before = fold.querySelector('.strip').checkVisibility(); fold.querySelector('summary').click();
        return !before && fold.querySelector('.strip').checkVisibility(); })()`));
    const names = await drawAll(page);
    check('every chart is drawn by the scripts', names.length >= 4, names.join(', '));
    const asked = page.requests.filter(request => !request.startsWith('blob:'));
    check('one request, of the page itself', asked.length === 1 && asked[0].startsWith('file:'), asked.length);
    check('no message on the console', page.complaints.length === 0, page.complaints.join(' | '));
    await labelsAreRight(page);
    await mapIsRight(page);
    await legendAndTooltip(page);
    await wordsAreExplained(page);
    await bodyTurns(page, check, query);
    await walkSteps(page, check, query);
    await foldsAndCells(page);
    await question(page);
    await filterBar(page);
    await chaptersAnswer(page);
    await jumps(page);
    check('nor after all of it', page.complaints.length === 0, page.complaints.join(' | '));
    await accessible(page);
}

/// A chart's marks have their values in their labels; these are the store's.
async function labelsAreRight(page) {
    const labels = await page.value(`[...document.querySelectorAll('[data-chart=time] [aria-roledescription=point]')]
        .map(mark => mark.getAttribute('aria-label'))`);
    check('the marks of the chart of times have labels', labels.length > 0, labels.length);
    const wanted = query(`select table_type, algorithm, shape, value from cell join figure using (build, hash)
        where probe = 'time' and name in ('separated_ns', 'overlapping_ns') and value is not null and axes = ''`);
    const known = new Set(wanted.map(row => `${row.table_type} ${row.algorithm} ${Number(row.value).toPrecision(3)}`));
    const part = (label, name) => label.match(new RegExp('(?:^|; )' + name + ': ([^;]*)'))?.[1];
    const wrong = labels.filter(label => {
        const ns = Number(part(label, 'ns per query, median')?.replace(/,/g, ''));
        return ![...known].some(text => text === `${part(label, 'table') ?? ''} ${part(label, 'algorithm')} ${ns.toPrecision(3)}`) &&
               !wanted.some(row => Math.abs(row.value / ns - 1) < 1e-3);
    });
    check('and what they say is in the store', wrong.length === 0, wrong.slice(0, 2).join(' | '));
}

/// Each place of the map says what it has, and the times in its words are the store's.
async function mapIsRight(page) {
    const places = await page.value(`[...document.querySelectorAll('#break-even svg > g')].map(place => ({
        title: place.querySelector('title').textContent, text: [...place.querySelectorAll('text')].map(one => one.textContent) }))`);
    check('the map has places, and none is blank', places.length > 0 && places.every(place => place.text.join('').trim()), places.length);
    const times = query(`select table_type, value from cell join figure using (build, hash)
        where probe = 'time' and name = 'all_ns' and value is not null`);
    const won = places.map(place => place.title.match(/(?:alone|tie): .*? on (\S+) .*?; (\S+) ns/)).filter(Boolean);
    const wrong = won.filter(([, table, ns]) => !times.some(
        row => row.table_type === table && Math.abs(row.value / Number(ns) - 1) < 2e-2));
    check('and its times are the store\'s', won.length > 0 && wrong.length === 0, `${won.length} read, ${wrong.length} differ`);
    const missing = places.filter(place => place.title.startsWith('Not measured: '));
    check('a place that was not measured says so', missing.every(place => place.text.join() === 'not measured'), missing.length);
}

async function legendAndTooltip(page) {
    const faint = `document.querySelectorAll('[data-chart=time] [aria-roledescription=point][opacity="0.06"]').length`;
    check('nothing is dimmed at first', await page.value(faint) === 0);
    await page.value(`document.querySelector('[data-chart=time]').scrollIntoView()`);
    const click = async (selector, type) => {
        const at = await page.value(`(() => { const box = document.querySelector(${JSON.stringify(selector)})
            .getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()`);
        for (const name of type) await page.send('Input.dispatchMouseEvent', {
            type: name, x: at[0], y: at[1], button: name === 'mouseMoved' ? 'none' : 'left', clickCount: 1 });
    };
    await click('[data-chart=time] .role-legend-symbol path, [data-chart=time] .legend-symbol path',
                ['mouseMoved', 'mousePressed', 'mouseReleased']).catch(() => {});
    const dimmed = await page.until(`${faint} > 0`, 4).catch(() => false);
    check('a click on the legend dims the rest', dimmed === true);
    await click('[data-chart=time] [aria-roledescription=point]', ['mouseMoved']);
    const shown = await page.until(`document.querySelector('#vg-tooltip-element.visible')`, 4).catch(() => false);
    check('a point has a tooltip', shown === true);
}

/// Each linked term has its explanation, and each layout of the store the line that the store has of it.
async function wordsAreExplained(page) {
    const links = await page.value(`[...document.querySelectorAll('a.term')].map(link => link.getAttribute('href').slice(1))`);
    const dead = await page.value(`[...document.querySelectorAll('a.term')].filter(
        link => !document.querySelector(link.getAttribute('href') + ' dfn')).map(link => link.textContent)`);
    check('terms are linked where they are used, to what explains them', links.length > 15 && dead.length === 0,
          `${links.length} links to ${new Set(links).size} terms ${dead.join(' ')}`);
    const layouts = query(`select distinct cell.layout, meta.value from cell join meta on meta.key = 'layout ' || cell.layout
                           where axes = '' and status = 'verified' and run not like 'thrash%'`);
    const shown = await page.value(`Object.fromEntries([...document.querySelectorAll('dt[id^=layout-]')].map(
        term => [term.textContent, term.nextElementSibling.textContent]))`);
    const wrong = layouts.filter(row => shown[row.layout] !== 'stores ' + row.value.replace('; ', '; derives '));
    check('every layout is described as the store describes it', layouts.length > 2 && wrong.length === 0, layouts.length);
}

/// Every number that the page carries is the store's.
async function foldsAndCells(page) {
    await page.value(`document.querySelector('details[data-fold]').open = true`);
    await page.until(`document.querySelector('details[data-fold] .long tbody tr:not(.gap)')`);
    const inSight = await page.value(`document.querySelectorAll('details[data-fold] .long tbody tr').length`);
    check('a long table has what is in sight alone', inSight <= 60, inSight + ' rows');
    await page.value(`document.getElementById('all-cells').open = true`);
    await page.until(`document.querySelector('#all-cells .long tbody a')`);
    const carried = await page.value(`storeCells().then(store => ({ ...store, figures: store.figures.map(
        figure => ({ ...figure, values: Array.from(figure.values, value => value ?? null) })) }))`);
    const place = new Map(carried.cells.cell.map((hash, i) => [hash, i]));
    const columns = new Map(carried.figures.map(figure => [figure.name, figure]));
    let compared = 0, wrong = 0, missing = 0;
    const build = query(`select value from meta where key = 'build'`)[0]?.value;
    for (const row of query(`select hash, probe || '.' || name as name, value from figure join cell using (build, hash)
                             where build = '${build}' and run not like 'thrash%'`)) {
        const shown = columns.get(row.name)?.values[place.get(row.hash.slice(0, 12))];
        ++compared;
        if (row.value === null) missing += typeof shown !== 'string';
        else if (!(Math.abs(shown - row.value) <= 1e-6 * Math.abs(row.value))) ++wrong;
    }
    check('every figure of the page is the store\'s', compared > 1000 && wrong === 0, `${compared} compared, ${wrong} differ`);
    check('and what was not measured has its reason', missing === 0, missing);
    const hash = carried.cells.cell[0];
    await page.value(`location.hash = 'cell=${hash}'`);
    await page.until(`document.querySelector('#card h3')`);
    check('a cell has an address and a card', (await page.value(`document.getElementById('card').textContent`)).includes(hash));
}

/// Chooses in the bar, and waits until the page shows it.
async function ask(page, choices) {
    await page.value(`(async () => { for (const [name, value] of Object.entries(${JSON.stringify(choices)})) field(name).value = value;
        keepAddress(); await showView(); })()`);
    await page.until(`${charts}.every(place => !place.turn || place.dataset.drawn !== undefined)`);
}
const everything = { shape: '', tables: 'both', limit: '1e-6', bodies: '', scene: '', algorithm: '', precision: '' };

async function question(page) {
    const answer = `document.getElementById('answer').textContent.trim()`, statements = `[...document.querySelectorAll('.sentence')]
        .filter(one => !one.hidden).map(one => one.innerHTML).join(' | ')`;
    const [before, said] = [await page.value(answer), await page.value(statements)];
    await page.value(`history.replaceState(null, '', '#')`);
    await ask(page, { limit: '1e-4' });
    check('another error is another question', (await page.value(`document.querySelector('h1').textContent`)).includes('1e-4'));
    await ask(page, everything);
    check('the bar answers as the page without it', before === await page.value(answer));
    check('and its chapters state the same', said === await page.value(statements));
    check('a view that is the first has no address', await page.value('location.hash') === '');
    await ask(page, { shape: 'cube8' });
    check('one body has one row', await page.value(`document.querySelector('.decision tbody th').textContent`) === 'cube88 vertices');
    await ask(page, { tables: 'own' });
    const none = await page.value(`[document.querySelector('#answer .lead').textContent, field('command').textContent]`);
    check('what was not measured says so, with the command', none[0] === 'No cell of this store answers the question.' &&
        none[1] === 'edgewise advise --shape cube8 --own-tables --error 1e-6', none.join(' | '));
    check('so do the chapters', (await page.value(`document.querySelector('section:has(> #caches) > .sentence').textContent`)) ===
        'Not measured. This measures it: edgewise sweep --shape cube8 --scenes pressure --caches all');
    const asked = await page.value('location.hash');
    check('the question is in the address', asked === '#shape=cube8&tables=own', asked);
    await ask(page, { ...everything, bodies: '5000' });
    const far = await page.value(`[field('said').textContent, document.querySelector('.decision td.own').textContent]`);
    check('a number of bodies that was not measured is said not to be', far[0].startsWith('Not measured: 5000 bodies') &&
        far[0].includes('measured were') && far[1].includes('edgewise advise --shape cube8 --own-tables --bodies 5000'), far.join(' | '));
    await ask(page, { bodies: '90' });
    check('one near to it is answered by it', (await page.value(`field('said').textContent`)).includes('90 bodies with a table each: those of 60'));
    await ask(page, { ...everything, shape: 'sphere386' });
    const title = await page.value(`document.querySelector('section:has(> #bytes) > .sentence').textContent`);
    check('the statements are of the body', title.includes('sphere386'), title);
    await ask(page, everything);
}

/// Charts, tables, the map and the body show what the bar says, and all of it again afterwards.
async function filterBar(page) {
    const marks = `[...document.querySelectorAll('[data-chart=time] [aria-roledescription=point]')].map(mark => mark.getAttribute('aria-label'))`;
    const before = (await page.value(marks)).length;
    await ask(page, { algorithm: 'gjk', shape: 'cube8' });
    const labels = await page.value(marks);
    check('the bar filters charts', labels.length > 0 && labels.length < before && labels.every(
        label => /algorithm: gjk(;|$)/.test(label) && /shape: cube8(;|$)/.test(label)), `${labels.length} of ${before}`);
    const rows = await page.value(`[...document.querySelectorAll('main section table')].filter(table => !table.closest('#answer')).flatMap(
        table => { const place = [...table.querySelectorAll('thead th')].findIndex(head => head.textContent === 'algorithm');
                   return place < 0 ? [] : [...table.querySelectorAll('tbody tr:not(.gap, .none)')].filter(row => !row.hidden)
                       .map(row => row.cells[place].textContent); })`);
    check('and tables', rows.length > 0 && rows.every(text => text === 'gjk'), rows.length);
    const bright = await page.value(`[...document.querySelectorAll('#break-even svg > g:not(.dim)')].map(place => place.dataset.shape)`);
    check('and the map', bright.length > 0 && bright.every(shape => shape === 'cube8'), bright.length);
    await ask(page, { ...everything, shape: 'cube8' });
    const heat = await page.value(`[document.getElementById('body-shown').hidden, document.querySelector('section:has(> #body) > .sentence').textContent]`);
    check('and the body, where the store has no heat of it', heat[0] && heat[1].startsWith('Not measured'), heat[1]);
    await ask(page, { ...everything, tables: 'own' });
    const scenes = await page.value(`[...document.querySelectorAll('#answer tr[data-scene]')].filter(row => row.checkVisibility() || !row.hidden)
        .filter(row => row.classList.contains('own')).map(row => row.dataset.scene)`);
    check('a table each leaves such scenes', scenes.length > 0 && scenes.every(scene => scene.includes('bodies')), scenes.join('; '));
    await page.value(`document.querySelector('#ask button').click()`);
    await page.until(`field('tables').value === 'both'`);
    await page.until(`document.querySelectorAll('[data-chart=time] [aria-roledescription=point]').length === ${before}`);
    check('and lets go of them', await page.value(`document.querySelectorAll('.dim').length`) === 0);
    check('no chart has choices that the bar has', await page.value(`[...document.querySelectorAll('.vega-bindings')]
        .every(one => !/Shape|Scene/.test(one.textContent))`));
}

/// Each question has a bold answer or says why there is none; a chapter without contents is folded.
async function chaptersAnswer(page) {
    const silent = await page.value(`[...document.querySelectorAll('main section:not(#answer) h2')].filter(title => title.textContent.endsWith('?'))
        .filter(title => !title.closest('details.empty') && !title.parentElement.querySelector('.sentence')).map(title => title.id)`);
    check('every question of a chapter is answered', silent.length === 0, silent.join(', '));
    check('a chapter without contents is folded, with the reason', await page.value(`(() => { const folds = [...document.querySelectorAll('details.empty')];
        return folds.length > 0 && folds.every(fold => !fold.open && fold.querySelector('p').textContent.length > 20); })()`));
}

/// A jump leaves the title below the bar; the address keeps both the jump and the question.
async function jumps(page) {
    await ask(page, { shape: 'sphere386' });
    for (const name of ['body', 'caches', 'words']) {
        await page.value(`document.querySelector('nav a[href="#${name}"]').click()`);
        await page.until(`location.hash.includes('at=${name}')`);
        const [title, bar] = await page.value(`[document.getElementById('${name}').getBoundingClientRect().top,
            document.getElementById('ask').getBoundingClientRect().bottom]`);
        check(`a jump to ${name} leaves its title in sight`, title >= bar - 1 && title < 600, `${title} below ${bar}`);
    }
    const address = await page.value('location.href');
    const other = await page.browser.open();
    await other.go(address);
    await other.until(`document.querySelectorAll('.decision tbody tr').length === 1`);
    await other.until(`Math.abs(document.getElementById('words').getBoundingClientRect().top) < 700`);
    check('an address that was sent shows the same', await other.value(`field('shape').value`) === 'sphere386', address.split('#')[1]);
    await ask(page, everything);
}

/// Nothing that is in sight moves while the page is read from top to bottom.
async function staysInPlace(browser) {
    const page = await browser.open();
    await page.go(url);
    await page.value(`(window.shift = [], new PerformanceObserver(list => list.getEntries().forEach(entry => window.shift.push([entry.value,
        entry.sources?.map(source => source.node?.id || source.node?.className || source.node?.nodeName).join(' ')])))
        .observe({ type: 'layout-shift', buffered: true }), 0)`);
    const before = await page.value('document.documentElement.scrollHeight');
    for (let y = 0; y < before; y += 400) {
        await page.value(`new Promise(done => { window.scrollTo(0, ${y}); setTimeout(done, 60); })`);
        await page.until(`${charts}.every(place => place.dataset.drawn !== undefined || place.getBoundingClientRect().top > innerHeight + 300)`);
    }
    const shifts = await page.value('window.shift'), sum = shifts.reduce((all, [value]) => all + value, 0);
    check('nothing moves while the page is read', sum < 0.05, `${sum.toFixed(3)} ${shifts.map(one => one.join(' ')).join('; ')}`);
    const after = await page.value('document.documentElement.scrollHeight');
    check('and it stays as long', Math.abs(after - before) < 0.02 * before, `${before} px, then ${after}`);
}

/// Names for what can be focused, one heading per level step, pictures with labels; axe's rules where it is there.
async function accessible(page) {
    const nameless = await page.value(`[...document.querySelectorAll('a, button, select, input, summary, [tabindex="0"], svg[role=img]')]
        .filter(one => one.getClientRects().length > 0)
        .filter(one => !(one.textContent.trim() || one.getAttribute('aria-label') || one.labels?.length))
        .map(one => one.outerHTML.slice(0, 80))`);
    check('all that takes the focus has a name', nameless.length === 0, nameless.join(' | '));
    const tabs = await page.value(`[...document.querySelectorAll('a[href], button, select, input, summary, [tabindex="0"]')]
        .filter(one => one.checkVisibility() && !one.closest('.long, #card, .ties')).map(one => one.matches('a.term') ? one.hash : '')`);
    const terms = tabs.filter(hash => hash !== '');
    // All charts are drawn by now, and each has brought its menu and choices. How many layouts tie depends on the machine.
    check('fewer than 75 stops of the tabulator beside ties and links to words', tabs.length - terms.length < 75, tabs.length - terms.length);
    check('and of these one for each word', terms.length > 10 && new Set(terms).size === terms.length, terms.length);
    if (!axe || !existsSync(axe)) return console.log('skip axe-core is not there: its rules were not checked');
    await page.value(readFileSync(axe, 'utf8') + ';0');
    const found = await page.value(`axe.run(document, { resultTypes: ['violations'] })
        .then(result => result.violations.map(one => one.id + ' (' + one.nodes.length + '): ' + one.nodes[0].html.slice(0, 90)))`);
    check('axe finds nothing', found.length === 0, found.join(' | '));
}

async function narrowAndDark(browser) {
    const page = await browser.open({ width: 400, height: 800, dark: true });
    await page.go(url);
    await drawAll(page);
    const wide = await page.value(`[...document.querySelectorAll('main *')].filter(one => !one.parentElement.closest(
        '.wide, .chart, .long') && one.getBoundingClientRect().right > 401).map(one => one.tagName + '.' + one.className)`);
    check('400 px wide nothing is wider than the page', wide.length === 0 &&
        await page.value('document.documentElement.scrollWidth <= 400'), wide.slice(0, 4).join(' '));
    const colour = await page.value(`getComputedStyle(document.documentElement).backgroundColor`);
    check('dark where the reader has it dark', colour === 'rgb(21, 24, 28)', colour);
    const text = await page.value(`getComputedStyle(document.querySelector('[data-chart=bytes] svg text')).fill`);
    check('charts too', text !== 'rgb(0, 0, 0)', text);
}

async function wideWithAllOpen(browser) {
    const page = await browser.open({ width: 1400 });
    await page.go(url);
    await drawAll(page);
    await page.value("document.querySelectorAll('details').forEach(one => { one.open = true; })");
    await page.value("document.querySelectorAll('h1, caption, li, td, .lead').forEach(one => { one.append('x'.repeat(3000)); })");
    const width = await page.value('document.documentElement.scrollWidth');
    check('1400 px wide with all details open and long names nothing is wider than the page', width <= 1400, width);
}

async function withoutScripts(browser) {
    const page = await browser.open({ scripts: false });
    await page.go(url);
    const { root } = await page.send('DOM.getDocument', { depth: 1 });
    const all = async selector =>
        (await page.send('DOM.querySelectorAll', { nodeId: root.nodeId, selector })).nodeIds.length;
    check('without scripts the answer is there', await all('.lead') > 0 && await all('.decision tbody tr') > 0);
    const [charts, stills] = [await all('[data-chart]'), await all('[data-chart] svg, [data-chart] table')];
    check('and a picture or a table in place of each chart', charts > 0 && stills >= charts, `${stills} of ${charts}`);
    check('and the body with its heat', await all('#body-picture path') > 0 && await all('#body-choice[hidden]') === 1);
    check('and the last step of a walk', await all('#walk .now') === 4 && await all('#walk-choice[hidden]') === 1);
    check('and the map of who wins where', await all('#break-even svg > g') > 0);
    const { nodeId } = await page.send('DOM.querySelector', { nodeId: root.nodeId, selector: '#ask' });
    const bar = await page.send('DOM.getBoxModel', { nodeId }).catch(() => null);
    check('and nothing that would need them', nodeId > 0 && bar === null);
}

async function printed(browser) {
    const page = await browser.open({ width: 760 });
    await page.go(url);
    await drawAll(page);
    await page.send('Emulation.setEmulatedMedia', { media: 'print' });
    const pdf = await page.pdf();
    const pages = (pdf.toString('latin1').match(/\/Type\s*\/Page\b/g) ?? []).length;
    check('printed on at most 4 pages', pages > 0 && pages <= 4, `${pages} pages, ${pdf.length} bytes`);
}

const browser = await Browser.start(chromium);
try {
    for (const test of [looksRight, staysInPlace, narrowAndDark, wideWithAllOpen, withoutScripts, printed]) await test(browser);
} finally {
    await browser.stop();
}
console.log(failures === 0 ? 'all checks passed' : failures + ' checks failed');
process.exit(failures === 0 ? 0 : 1);
