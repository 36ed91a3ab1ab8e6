// The bar: other bodies, tables, errors and numbers of bodies. The page carries the answers; what was not measured has the
// command that measures it. The bar's state is in the address.
'use strict';
const askFields = ['shape', 'tables', 'limit', 'bodies', 'scene', 'algorithm', 'precision'];
const field = name => document.getElementById('ask-' + name);
const asked = name => field(name).value;

// The numbers of bodies that were measured with a table each; and the one that is nearest to the number asked for, within a
// factor of two: 0 if there is none, nothing if any number will do.
const measuredBodies = () => [...new Set([...field('scene').options].filter(one => one.dataset.tables === 'own')
    .map(one => Number(one.dataset.bodies)).filter(Boolean))].sort((a, b) => a - b);
function nearestBodies() {
    const wanted = Math.round(Number(asked('bodies'))), apart = number => Math.abs(Math.log(number / wanted));
    if (!(wanted > 1) || asked('tables') === 'shared') return '';
    const nearest = measuredBodies().sort((a, b) => apart(a) - apart(b))[0];
    return nearest !== undefined && apart(nearest) <= Math.log(2) ? nearest : 0;
}

async function showAnswer() {
    const bodies = nearestBodies(), wanted = Math.round(Number(asked('bodies')));
    const { lines, answers } = await unpackJson('answers');
    const answer = answers[[asked('shape'), asked('limit'), asked('tables'), bodies].join(' ')];
    const withBodies = text => bodies === '' ? text : text.replaceAll('--own-tables', '--own-tables --bodies ' + wanted);
    document.querySelector('h1').textContent = answer.title;
    const place = document.getElementById('answer'), open = place.querySelector('details')?.open;
    place.innerHTML = withBodies(answer.html.map(line => lines[line]).join('\n'));
    place.querySelector('details')?.toggleAttribute('open', open || asked('shape') !== '');
    place.dataset.tables = asked('tables');
    startScrollBoxes(place);
    const command = withBodies(answer.command);
    field('command').textContent = command + (bodies === '' || command.includes('--bodies') ? '' : ' --bodies ' + wanted);
    field('said').textContent = bodies === '' || bodies === wanted ? ''
        : bodies === 0 ? `Not measured: ${wanted} bodies with a table each; measured were ${measuredBodies().join(' and ') || 'none'}.`
        : `${wanted} bodies with a table each: those of ${bodies}, the nearest that was measured.`;
}

// The bold statements of the chapters: for all bodies and tables as the page came, else those of the chosen part.
const wholeStatements = new Map();
async function showStatements() {
    const part = asked('shape') + ' ' + asked('tables'), parts = await unpackJson('statements');
    for (const id of new Set(Object.values(parts).flatMap(Object.keys))) {
        const title = document.getElementById(id), section = title.closest('section');
        if (title.closest('details')) continue;
        let line = section.querySelector(':scope > .sentence');
        if (!line) title.after(line = element('p', '', 'sentence'));
        if (!wholeStatements.has(id)) wholeStatements.set(id, line.innerHTML);
        if (part === ' both') line.innerHTML = wholeStatements.get(id);
        else line.textContent = parts[part][id] ?? '';
        line.hidden = line.textContent === '';
    }
    const maps = await unpackJson('maps');
    document.getElementById('break-even').innerHTML = maps[[asked('shape'), asked('limit'), asked('tables')].join(' ')];
}

async function showView() {
    chooseFilter();
    await Promise.all([showAnswer(), showStatements()]);
    applyFilter();
}

// The address has what differs from the page as it came, and the chapter or cell that was jumped to.
const atFirst = {};
function keepAddress() {
    const hash = location.hash.slice(1), before = new URLSearchParams(hash), kept = new URLSearchParams();
    const at = hash.includes('=') ? before.get('at') : hash;
    if (before.has('cell')) kept.set('cell', before.get('cell'));
    if (at) kept.set('at', at);
    askFields.filter(name => asked(name) !== atFirst[name]).forEach(name => kept.set(name, asked(name)));
    const only = [...kept.keys()].join() === 'at' ? at : kept.toString();
    if (only !== hash) history.replaceState(null, '', '#' + only);
}

function takeAddress() {
    const given = new URLSearchParams(location.hash.slice(1));
    askFields.forEach(name => { field(name).value = atFirst[name]; });
    askFields.filter(name => given.has(name)).forEach(name => { field(name).value = given.get(name); });
    askFields.filter(name => field(name).selectedIndex === -1).forEach(name => { field(name).value = atFirst[name]; });
    return given.get('at');
}

async function followAddress() {
    const at = takeAddress();
    await showView();
    keepAddress();
    if (at) document.getElementById(at)?.scrollIntoView();
}

function startQuestion() {
    const form = document.getElementById('ask');
    askFields.forEach(name => { atFirst[name] = asked(name); });
    form.addEventListener('submit', event => event.preventDefault());
    form.addEventListener('change', () => { keepAddress(); showView(); });
    form.addEventListener('reset', () => setTimeout(() => { keepAddress(); showView(); }));
    const hasQuestion = () => askFields.some(name => new URLSearchParams(location.hash.slice(1)).has(name));
    window.addEventListener('hashchange', () => hasQuestion() ? followAddress() : keepAddress());
    // A link must not jump to a place under the bar.
    new ResizeObserver(() => {
        const sticks = getComputedStyle(form).position === 'sticky';
        document.documentElement.style.scrollPaddingTop = sticks ? form.offsetHeight + 8 + 'px' : '';
    }).observe(form);
    if (hasQuestion()) followAddress();
}
