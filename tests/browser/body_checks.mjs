// SPDX-License-Identifier: MIT
//
// The chapter on the body in a real browser: its picture turns, and a query's walk goes step by step.
// check(what, right, seen) takes a result; query(sql) gives rows of the store.

/// The body is drawn by the page and turned by keys and by hand; another cell's heat is another picture.
export async function bodyTurns(page, check, query) {
    await page.until(`!document.getElementById('body-choice').hidden`);
    const paths = `[...document.querySelectorAll('#body-picture path')].map(path => path.getAttribute('class') + path.getAttribute('d')).join('|')`;
    const still = await page.value(paths);
    await page.value(`drawBody()`);
    const again = await page.value(paths);
    const numbers = text => text.match(/-?\d+/g).map(Number);
    const apart = numbers(still).map((number, i) => Math.abs(number - numbers(again)[i]));
    check('the script draws the body as the page has it', again.length === still.length && Math.max(...apart) <= 1, apart.length + ' numbers');
    await page.value(`document.getElementById('body-view').focus()`);
    await page.send('Input.dispatchKeyEvent', { type: 'keyDown', key: 'ArrowRight', code: 'ArrowRight', windowsVirtualKeyCode: 39 });
    const turned = await page.value(paths);
    check('a key turns it', turned !== again);
    await page.value(`document.getElementById('body-view').scrollIntoView()`);
    const box = await page.value(`(() => { const box = document.getElementById('body-view').getBoundingClientRect(); return [box.x + 150, box.y + 150]; })()`);
    for (const [type, dx] of [['mousePressed', 0], ['mouseMoved', 40], ['mouseReleased', 40]])
        await page.send('Input.dispatchMouseEvent', { type, x: box[0] + dx, y: box[1], button: 'left', buttons: 1, clickCount: 1 });
    const dragged = await page.value(paths);
    check('and so does a drag', dragged !== turned);
    const said = await page.value(`document.getElementById('body-said').textContent`);
    await page.value(`(() => { const one = document.getElementById('body-cell'); one.selectedIndex = one.options.length - 1;
        one.dispatchEvent(new Event('change', { bubbles: true })); })()`);
    check('another cell has another heat', await page.value(`document.getElementById('body-said').textContent`) !== said &&
        await page.value(paths) !== dragged);
    const heats = await page.value(`bodyView.data.heats.map(heat => heat.title)`);
    const kept = query(`select count(*) as heats from meta where key like 'heat %'`)[0].heats;
    check('the store has as many heats', heats.length === Math.min(kept, 24) && kept > 1, kept);
}

/// The slider shows one query step by step: words, squares and features are those of the store's walk.
export async function walkSteps(page, check, query) {
    const kept = query(`select table_type, algorithm, value from meta join cell on key = 'heat ' || hash where shape = 'sphere386'`)
        .map(row => ({ ...row, walk: JSON.parse(row.value).walk })).filter(row => row.walk);
    check('the store has walks of both algorithms', ['vclip', 'gjk'].every(name => kept.some(row => row.algorithm === name)), kept.length);
    const shown = () => page.value(`({ said: document.getElementById('walk-said').textContent,
        captions: [...document.querySelectorAll('#walk figcaption')].map(one => one.textContent),
        now: [...document.querySelectorAll('#walk .now')].map(one => one.getAttribute('d')),
        past: [...document.querySelectorAll('#walk .past')].map(one => one.getAttribute('d')) })`);
    const squares = path => (path.match(/M/g) ?? []).length;
    const expected = (row, place) => {
        const known = new Set(row.walk.steps.slice(0, place).flatMap(step => step.lines));
        const lines = row.walk.steps[place].lines, all = new Set([...known, ...lines]).size;
        return `${row.table_type}: ${lines.length} ${lines.length === 1 ? 'line' : 'lines'}, ${all - known.size} of them new; ` +
               `${all} of ${row.walk.tables.reduce((sum, one) => sum + one)} so far`;
    };
    for (const name of ['V-Clip', 'GJK']) {
        await page.value(`(() => { const one = document.getElementById('walk-query');
            one.value = [...one.options].find(option => option.parentElement.label.startsWith('${name}')).value;
            one.dispatchEvent(new Event('input', { bubbles: true })); })()`);
        const title = await page.value(`document.getElementById('walk-title').textContent`);
        const names = (await page.value(`document.getElementById('walk-query').selectedOptions[0].text`)).split(' and ');
        const count = Number(await page.value(`document.getElementById('walk-step').max`));
        const rows = names.map(table => kept.filter(row => row.table_type === table && title.endsWith('query ' + row.walk.query) &&
            (row.algorithm === 'gjk') === (name === 'GJK') && row.walk.steps.length === count));
        check(title + ': two tables of the store', rows.every(found => found.length > 0) && names[0] !== names[1], names.join(', '));
        await page.value(`document.getElementById('walk-step').focus()`);
        let wrong = 0;
        for (let place = count - 1; place >= 0; --place) {
            const { said, captions, now, past } = await shown();
            const step = rows[0][0].walk.steps[place];
            wrong += !said.startsWith(`Step ${place + 1} of ${count}: `);
            rows.forEach((found, side) => {
                wrong += !found.some(row => captions[2 + side] === expected(row, place) && squares(now[2 + side]) === row.walk.steps[place].lines.length &&
                    squares(past[2 + side]) === row.walk.steps.slice(0, place).reduce((sum, one) => sum + one.lines.length, 0));
            });
            [step.a, step.b].forEach((corners, side) => {  // corners of a simplex may share a vertex
                const vertices = step.state === 'gjk_iteration' ? [...new Set(corners)].sort((v, w) => v - w) : corners;
                wrong += captions[side].replace(/^Body [AB]:? ?[a-z ]*/, '') !== vertices.join(', ');
                wrong += (now[side].match(/[ML]/g) ?? []).length !== vertices.length;
            });
            await page.send('Input.dispatchKeyEvent', { type: 'keyDown', key: 'ArrowLeft', code: 'ArrowLeft', windowsVirtualKeyCode: 37 });
        }
        check('and each of its steps, by the arrow keys, is the store\'s', wrong === 0 && await page.value(`document.getElementById('walk-step').value`) === '1', count + ' steps');
    }
    const lines = `document.querySelectorAll('#walk figcaption')[3].textContent`;
    const before = await page.value(lines);
    await page.value(`(() => { const one = document.getElementById('walk-query'); one.selectedIndex += 1;
        one.dispatchEvent(new Event('input', { bubbles: true })); })()`);
    check('another table has other lines', await page.value(lines) !== before);
}
