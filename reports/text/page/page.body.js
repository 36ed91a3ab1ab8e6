// The body of a cell with the heat of its features, turned by hand: the paths that the page has, drawn again from another
// side. Seen along -z after a turn about y, then about x, as body_heat.cpp draws the first view.
'use strict';
const bodyView = { yaw: 0.6, pitch: 0.4, size: 420, margin: 12, levels: 6, data: null, shown: 0 };

function seenPoints(vertices) {
    const middle = [0, 1, 2].map(k => vertices.reduce((sum, v) => sum + v[k], 0) / vertices.length);
    const centred = vertices.map(v => v.map((x, k) => x - middle[k]));
    const scale = (bodyView.size / 2 - bodyView.margin) / Math.max(1e-300, ...centred.map(v => Math.hypot(...v)));
    const [cy, sy, cp, sp] = [Math.cos(bodyView.yaw), Math.sin(bodyView.yaw), Math.cos(bodyView.pitch), Math.sin(bodyView.pitch)];
    return centred.map(([x, y, z]) => [bodyView.size / 2 + scale * (cy * x + sy * z),
                                       bodyView.size / 2 - scale * (cp * y - sp * (cy * z - sy * x))]);
}

const facesUs = (ring, points) => ring.reduce((area, v, i) => {
    const [a, b] = [points[v], points[ring[(i + 1) % ring.length]]];
    return area + a[0] * b[1] - b[0] * a[1];
}, 0) < 0;

function heatLevel(reads, most) {
    if (!(reads > 0)) return 0;
    const part = 1 + Math.log(reads / most) / Math.log(100);
    return 1 + Math.floor(Math.min(Math.max(part, 0), 0.999) * (bodyView.levels - 1));
}

// For each level the features of one kind, those out of sight left out.
function levelPaths(kind, paths, reads) {
    const levels = Array(bodyView.levels).fill('');
    const most = reads ? Math.max(...reads) : 0;
    paths.forEach((path, i) => { levels[reads ? heatLevel(reads[i], most) : 0] += path; });
    return levels.map((path, level) => {
        const made = document.createElementNS('http://www.w3.org/2000/svg', 'path');
        made.setAttribute('class', kind + ' h' + (reads ? level : 'x'));
        made.setAttribute('d', path);
        return made;
    });
}

function drawBody() {
    const heat = bodyView.data.heats[bodyView.shown], body = bodyView.data.bodies[heat.shape];
    const points = seenPoints(body.vertices);
    const at = v => points[v].map(Math.round).join(' ');
    const key = (a, b) => Math.min(a, b) + ' ' + Math.max(a, b);
    const edges = new Set(), vertices = new Set();
    const faces = body.faces.map(ring => {
        if (!facesUs(ring, points)) return '';
        ring.forEach((v, i) => { vertices.add(v); edges.add(key(v, ring[(i + 1) % ring.length])); });
        return 'M' + ring.map(at).join('L') + 'z';
    });
    document.getElementById('body-picture').replaceChildren(
        ...levelPaths('face', faces, heat.faces),
        ...levelPaths('edge', body.edges.map(([a, b]) => edges.has(key(a, b)) ? `M${at(a)}L${at(b)}` : ''), heat.edges),
        ...levelPaths('vertex', body.vertices.map((_, v) => vertices.has(v) ? `M${at(v)}h0` : ''), heat.vertices));
}

function turnBody(yaw, pitch) {
    bodyView.yaw += yaw;
    bodyView.pitch = Math.min(Math.max(bodyView.pitch + pitch, -Math.PI / 2), Math.PI / 2);
    drawBody();
}

function showHeat(place) {
    bodyView.shown = Number(place);
    const heat = bodyView.data.heats[bodyView.shown];
    document.getElementById('body-said').textContent = heat.title + ': ' + heat.said;
    document.getElementById('body-picture').setAttribute('aria-label', heat.title + ': ' + heat.said);
    drawBody();
}

// One query's walk: the drawings of its steps as body_walk.cpp made them, those of earlier steps faint.
function showWalk() {
    const [query, table] = document.getElementById('walk-query').value.split(' '), step = document.getElementById('walk-step');
    const walk = bodyView.data.walks[query], last = step.value - 1;
    document.getElementById('walk-title').textContent = walk.title;
    document.getElementById('walk-said').textContent = walk.said[last];
    step.setAttribute('aria-valuetext', walk.said[last]);
    const figures = document.querySelectorAll('#walk figure');
    [...walk.bodies, walk.tables[0], walk.tables[table]].forEach((drawing, i) => {
        figures[i].querySelector('svg').setAttribute('viewBox', drawing.box);
        const paths = [drawing.ground, drawing.steps.slice(0, last).join(''), drawing.steps[last]];
        figures[i].querySelectorAll('path').forEach((path, k) => path.setAttribute('d', paths[k]));
        figures[i].querySelector('figcaption').textContent = drawing.said[last];
    });
}

function startWalk() {
    const query = document.getElementById('walk-query'), step = document.getElementById('walk-step');
    if (!query) return;
    bodyView.data.walks.forEach((walk, i) => {
        const group = document.createElement('optgroup');
        group.label = walk.title;
        const pairs = walk.tables.map((table, k) => new Option(`${walk.tables[0].name} and ${table.name}`, `${i} ${k}`));
        group.append(...(pairs.length > 1 ? pairs.slice(1).reverse() : pairs));
        query.append(group);
    });
    const choose = () => { step.max = step.value = bodyView.data.walks[query.value.split(' ')[0]].said.length; };
    choose();
    document.getElementById('walk-choice').hidden = false;
    query.addEventListener('input', () => { choose(); showWalk(); });
    step.addEventListener('input', showWalk);
}

// The bar's choices leave some heats; where they leave none, the chapter's statement says so.
async function filterBody() {
    const choice = document.getElementById('body-cell');
    if (!choice) return;
    const kept = (await unpackJson('bodies')).heats.map(keepsRow);
    [...choice.options].forEach((option, i) => { option.disabled = option.hidden = !kept[i]; });
    const place = kept[bodyView.shown] ? bodyView.shown : kept.indexOf(true);
    document.getElementById('body-shown').hidden = place < 0;
    const said = document.querySelector('section:has(> #body) > .sentence');
    if (place < 0 && said?.hidden) said.hidden = false, said.textContent = 'Not measured of what the bar shows.';
    if (place < 0 || place === bodyView.shown) return;
    choice.value = place;
    showHeat(place);
}

async function startBody() {
    const view = document.getElementById('body-view');
    if (!view) return;
    bodyView.data = await unpackJson('bodies');
    document.getElementById('body-choice').hidden = false;
    startWalk();
    document.getElementById('body-cell').addEventListener('change', event => showHeat(event.target.value));
    view.setAttribute('aria-label', 'The body: arrow keys turn it');
    view.addEventListener('keydown', event => {
        const turn = { ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, -0.15], ArrowDown: [0, 0.15] }[event.key];
        if (!turn) return;
        event.preventDefault();
        turnBody(...turn);
    });
    view.addEventListener('pointerdown', event => view.setPointerCapture(event.pointerId));
    view.addEventListener('pointermove', event => {
        if (view.hasPointerCapture(event.pointerId)) turnBody(event.movementX * 0.01, event.movementY * 0.01);
    });
    view.classList.add('alive');
}
