// The question bar: other bodies, tables and errors, answered from what the page carries, and the command that measures
// exactly what was asked.
'use strict';
const field = name => document.getElementById('ask-' + name);

async function askAgain() {
    const shape = field('shape').value, limit = field('limit').value, tables = field('tables').value;
    const { lines, answers } = await unpackJson('answers'), answer = answers[shape + ' ' + limit];
    document.querySelector('h1').textContent = answer.title;
    const place = document.getElementById('answer'), open = place.querySelector('details')?.open;
    place.innerHTML = answer.html.map(line => lines[line]).join('\n');
    place.querySelector('details')?.toggleAttribute('open', open || shape !== '');
    place.dataset.tables = tables;
    startScrollBoxes(place);
    document.getElementById('break-even').innerHTML = (await unpackJson('maps'))[limit];
    filterMap();
    showCommand(answer.command, tables);
}

// Numbers of bodies of the scenes with a table each.
const measuredBodies = () => [...new Set([...document.querySelectorAll('#answer tr.own th')]
    .map(head => Number(head.textContent.match(/bodies (\d+)/)?.[1])).filter(Boolean))].sort((a, b) => a - b);

// A number of bodies far from those measured is said not to be.
function showCommand(command, tables) {
    const option = { own: ' --own-tables', shared: ' --shared-tables', both: '' }[tables];
    const bodies = Math.round(Number(field('bodies').value)), measured = measuredBodies();
    field('command').textContent = command + (bodies > 1 ? ' --bodies ' + bodies : '') + option;
    const far = tables !== 'shared' && measured.length > 0 && (bodies < Math.min(...measured) / 2 || bodies > 2 * Math.max(...measured));
    field('said').textContent = far ? `Not measured: ${bodies} bodies with a table each; measured were ${measured.join(' and ')}.` : '';
}

// The question is in the address, so that a view can be sent as a link.
const askFields = ['shape', 'tables', 'limit', 'bodies'];
function keepQuestion() {
    history.replaceState(null, '', '#' + new URLSearchParams(askFields.map(name => [name, field(name).value])));
}

function takeQuestion() {
    const asked = new URLSearchParams(location.hash.slice(1));
    if (!asked.has('tables')) return false;
    askFields.forEach(name => { if (asked.has(name)) field(name).value = asked.get(name); });
    return askFields.every(name => field(name).value !== '' || name === 'shape');
}

function startQuestion() {
    const form = document.getElementById('ask');
    if (!form) return;
    form.hidden = false;
    form.addEventListener('submit', event => event.preventDefault());
    form.addEventListener('change', () => { keepQuestion(); askAgain(); });
    if (takeQuestion()) return askAgain();
    unpackJson('answers').then(({ answers }) => {
        const answer = answers[field('shape').value + ' ' + field('limit').value];
        if (answer) showCommand(answer.command, field('tables').value);
    });
}
