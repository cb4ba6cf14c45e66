// The page as a whole: facts, tables, and the frame that is shown.
let current = 0, playing = null;
const chosen = { place: null, label: '', track: null, left: false };

function show() {
	if (!cameras.length) return;
	const camera = cameras[current], goal = goalAt(camera.i);
	drawPlan(camera.i);
	const drawing = drawCamera(camera);
	for (const move of cursors) move(camera.t);
	const going = !goal || goal[1] === 'none' ? 'no goal' : 'goal ' + goal[1] + (goal[2] === null ? '' : ' ' + goal[2]);
	const doing = camera.stop ? 'stop: ' + camera.stop.replaceAll('_', ' ') : `${number(camera.speed, 2)} m/s, free ${number(camera.free, 1)} m`;
	const text = `Frame ${camera.i}, ${clock(camera.t)} · openings in view ${camera.seen} · ${going} · ${doing}`;
	el('now').textContent = text;
	el('slider').value = current;
	el('slider').setAttribute('aria-valuetext', text);
	return drawing;
}
function goTo(index) {
	const wanted = Math.min(cameras.length - 1, Math.max(0, index));
	if (wanted === current) return;
	current = wanted;
	show();
}

function pause() {
	clearInterval(playing);
	playing = null;
	el('play').textContent = '▶ Play';
	el('play').setAttribute('aria-label', 'Play');
}
function play() {
	if (playing || cameras.length < 2) return pause();
	if (current === cameras.length - 1) goTo(0);
	playing = setInterval(() => (current === cameras.length - 1 ? pause() : goTo(current + 1)), 80);
	el('play').textContent = '⏸ Pause';
	el('play').setAttribute('aria-label', 'Pause');
}

function choose(row, { place, label, track = null, left = false }) {
	for (const other of document.querySelectorAll('tr.chosen')) other.classList.remove('chosen');
	row.classList.add('chosen');
	Object.assign(chosen, { place, label, track, left });
	pause();
}
function reveal() {
	const box = el('views').getBoundingClientRect();
	if (box.top < 0 || box.bottom > innerHeight) el('views').scrollIntoView({ block: 'start' });
}
/** The frame that shows most of a door, uncut by the image's edge if there is one; −1: none does. */
function bestView(track) {
	let best = -1, most = 0;
	cameras.forEach((camera, i) => {
		const door = (camera.doors || []).find((one) => one.n === track);
		if (!door || door.q.length < 4) return;
		const xs = door.q.map((side) => side[0]), ys = door.q.map((side) => side[1]), high = 1000 * camera.ratio;
		const width = Math.min(1000, Math.max(...xs)) - Math.max(0, Math.min(...xs)), height = Math.min(high, Math.max(...ys)) - Math.max(0, Math.min(...ys));
		if (width <= 0 || height <= 0) return;
		const whole = Math.min(...xs) >= 0 && Math.max(...xs) <= 1000;
		const score = width * height * (whole ? 4 : 1);
		if (score > most) { most = score; best = i; }
	});
	return best;
}
function firstOnPlan(track) {
	const plan = plans.find((one) => one.doors.some((door) => door[0] === track));
	return plan ? cameraAt(plan.i) : cameras.length - 1;
}

/** A table whose rows can be chosen; cells are texts or elements. */
function fillTable(table, head, rows) {
	if (!rows.length) return;
	const body = make('tbody');
	for (const { cells, pick } of rows) {
		const row = make('tr', {}, ...cells.map((cell, i) => make('td', { 'data-label': head[i] }, cell)));
		if (pick) row.addEventListener('click', () => pick(row));
		body.append(row);
	}
	table.append(make('thead', {}, make('tr', {}, ...head.map((text) => make('th', { scope: 'col' }, text)))), body);
}
function fillDoors() {
	const doors = summary.doors;
	el('doors-note').textContent = doors.length
		? `${doors.length} confirmed; ${doors.filter((door) => door.visited).length} driven through. Choose one to see it on the map and in its best frame.`
		: hasPlace ? 'No door was confirmed.' : 'Without a pose each frame is judged by itself: there are no tracks of doors.';
	fillTable(el('doors-table'), ['Door', 'Verdict', 'Width', 'Height', 'Confidence', 'Seen', 'Driven through'], doors.map((door) => ({
		cells: [make('button', { type: 'button' }, 'Door ' + door.track),
			make('span', {}, sign(verdictOf(door.verdict).path, verdictOf(door.verdict).color), ' ' + door.verdict),
			number(door.width, 2) + ' m', door.height === null ? 'not seen' : number(door.height, 2) + ' m',
			number(100 * door.confidence, 0) + ' %', door.seen + ' looks', door.visited ? 'yes ✓' : 'no'],
		pick: (row) => {
			choose(row, { place: door.center_in_map, label: 'door ' + door.track, track: door.track });
			const best = bestView(door.track);
			goTo(best < 0 ? firstOnPlan(door.track) : best);
			show();
			reveal();
		},
	})));
}
function fillLeft() {
	const list = summary.exploration.left_over, total = list.reduce((sum, left) => sum + left.area_m2, 0);
	el('left-note').textContent = list.length ? `${list.length} places, ${number(total, 2)} m² beside their frontiers.`
		: summary.exploration.complete ? 'Nothing.' : 'No account: the exploration did not come to its end (' + summary.exploration.reason + ').';
	fillTable(el('left-table'), ['Place', 'Why', 'Area', 'x', 'y'], list.map((left, i) => ({
		cells: [make('button', { type: 'button' }, 'Place ' + (i + 1)), left.why.replaceAll('_', ' ') + ': ' + (LEFT[left.why] || ''),
			number(left.area_m2, 2) + ' m²', number(left.center_in_map[0], 2) + ' m', number(left.center_in_map[1], 2) + ' m'],
		pick: (row) => {
			choose(row, { place: left.center_in_map, label: left.why.replaceAll('_', ' '), left: true });
			goTo(cameras.length - 1);
			show();
			reveal();
		},
	})));
	for (const cell of el('left-table').querySelectorAll('td:nth-child(2)')) cell.classList.add('wide');
}
function fillTiming() {
	const order = ['read', 'perceive', 'remember', 'choose', 'avoid', 'heading', 'write', 'total'];
	const stages = Object.keys(summary.timing_ms).sort((a, b) => order.indexOf(a) - order.indexOf(b));
	for (const stage of [...stages].reverse()) el('stage-choice').append(make('option', { value: stage }, stage));
	fillTable(el('timing-table'), ['Stage', 'Median [ms]', '99th percentile [ms]'],
		stages.map((stage) => ({ cells: [stage, number(summary.timing_ms[stage].median, 1), number(summary.timing_ms[stage].p99, 1)] })));
	el('stage-choice').addEventListener('change', () => { drawCurves(); show(); });
}
function fillFacts() {
	const { exploration, source, truth } = summary, total = summary.timing_ms.total;
	const end = exploration.complete ? 'complete: ' : 'ended: ';
	el('title').textContent = source.path.split('/').pop() || 'A run of explore-mrpt';
	el('outcome').textContent = `${source.kind} ${source.path} · ${summary.config || 'built-in defaults'} · explore-mrpt ${summary.version} · ${end}${exploration.reason}` + (source.damage ? ` · input damaged: ${source.damage}` : '');
	const fact = (name, id, value) => el('facts').append(make('li', {}, make('b', { id: 'fact-' + id }, value), make('span', {}, name)));
	fact('frames', 'frames', String(source.frames));
	fact('doors', 'doors', String(summary.doors.length));
	fact('corridors', 'corridors', String(summary.corridors.length));
	fact('left over', 'left', String(exploration.left_over.length));
	if (truth && truth.coverage !== null) fact('coverage', 'coverage', number(100 * truth.coverage, 1) + ' %');
	if (exploration.known_free_m2 !== null) fact('free floor', 'free', number(exploration.known_free_m2, 1) + ' m²');
	if (exploration.path_m !== null) fact('way', 'path', number(exploration.path_m, 1) + ' m');
	if (exploration.time_s !== null) fact('time', 'time', clock(exploration.time_s));
	if (truth) fact('collisions', 'collisions', String(truth.collisions));
	if (total) fact('a frame, median', 'frame-ms', number(total.median, 0) + ' ms');
	el('notes').hidden = !summary.warnings.length;
	el('warnings').append(...summary.warnings.map((warning) => make('li', {}, warning)));
}

/** Arrow keys and space work anywhere but in what has a use for them itself. */
function onKey(event) {
	const tag = event.target.tagName, own = ['SELECT', 'BUTTON', 'SUMMARY'].includes(tag) || event.target.type === 'checkbox';
	if (event.ctrlKey || event.altKey || event.metaKey || tag === 'SELECT') return;
	const actions = {
		ArrowLeft: () => goTo(current - 1), ArrowRight: () => goTo(current + 1), PageUp: null, PageDown: null,
		Home: () => goTo(0), End: () => goTo(cameras.length - 1), ' ': play, '+': () => zoomBy(1.5), '-': () => zoomBy(1 / 1.5), 0: () => zoomBy(0),
	};
	if (!actions[event.key] || (own && event.key === ' ')) return;
	event.preventDefault();
	actions[event.key]();
}

function listen() {
	el('slider').max = Math.max(0, cameras.length - 1);
	el('slider').addEventListener('input', () => { pause(); goTo(+el('slider').value); });
	el('back').addEventListener('click', () => { pause(); goTo(current - 1); });
	el('forth').addEventListener('click', () => { pause(); goTo(current + 1); });
	el('play').addEventListener('click', play);
	el('zoom-in').addEventListener('click', () => zoomBy(1.5));
	el('zoom-out').addEventListener('click', () => zoomBy(1 / 1.5));
	el('zoom-fit').addEventListener('click', () => zoomBy(0));
	el('plan').addEventListener('pointermove', (event) => { if (event.buttons & 1 && planView.zoom > 1) panBy(event.movementX, event.movementY); });
	document.addEventListener('keydown', onKey);
	const redraw = () => { readTheme(); planView.drawn = -2; drawCurves(); show(); };
	matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
	addEventListener('resize', redraw);
}
function begin() {
	readTheme();
	fillFacts();
	fillTiming();
	fillDoors();
	fillLeft();
	drawRamp();
	for (const [name, { path, color }] of Object.entries(VERDICTS)) el('verdict-key').append(make('span', {}, sign(path, color), name));
	el('verdict-key').append(make('span', {}, '✓ driven through'));
	const every = run.sampling.every;
	el('hint').textContent = 'Keys: ← → a frame, Home End, space plays, + − 0 zoom.' + (every > 1 ? ` One frame in ${every} is shown, so that this page stays small.` : '');
	if (hasPlace) planView.box = planBox();
	el('plan-none').hidden = hasPlace;
	el('plan-stage').hidden = el('plan-switches').hidden = el('verdict-key').hidden = !hasPlace;
	el('plan-none').textContent = cameras.length ? 'The frames came without poses: there is no map.' : 'No frame was computed.';
	if (hasPlace && !plans.length) el('plan-figure').querySelector('figcaption').textContent = 'Way, seen from above (no map was kept)';
	if (!cameras.length) {
		el('camera-none').hidden = false;
		el('camera-none').textContent = 'No frame was computed.';
		el('camera-stage').hidden = true;
	}
	listen();
	drawCurves();
	show();
}
begin();
