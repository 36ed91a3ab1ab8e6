// The question bar: other bodies, tables and errors, answered from what the page carries, and the command that measures
// exactly what was asked.
'use strict';
const field = name => document.getElementById('ask-' + name);

async function askAgain() {
    const shape = field('shape').value, limit = field('limit').value, tables = field('tables').value;
    const answer = (await unpackJson('answers'))[shape + ' ' + limit];
    document.querySelector('h1').textContent = answer.title;
    const place = document.getElementById('answer');
    place.innerHTML = answer.html;
    place.dataset.tables = tables;
    document.getElementById('break-even').innerHTML = (await unpackJson('maps'))[limit];
    filterMap();
    showCommand(answer.command, tables);
}

function showCommand(command, tables) {
    const option = { own: ' --own-tables', shared: ' --shared-tables', both: '' }[tables];
    const bodies = Math.round(Number(field('bodies').value));
    field('command').textContent = command + (bodies > 1 ? ' --bodies ' + bodies : '') + option;
}

function startQuestion() {
    const form = document.getElementById('ask');
    if (!form) return;
    form.hidden = false;
    form.addEventListener('submit', event => event.preventDefault());
    form.addEventListener('change', askAgain);
    unpackJson('answers').then(answers => {
        const answer = answers[field('shape').value + ' ' + field('limit').value];
        if (answer) showCommand(answer.command, field('tables').value);
    });
}
