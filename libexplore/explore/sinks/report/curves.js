// Curves over the run's time, which can be clicked to go there.
const tidy = (top) => {
	const power = 10 ** Math.floor(Math.log10(top || 1));
	return [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((step) => top / step <= 5) || power;
};
const MARGIN = { left: 52, right: 12, top: 30, bottom: 36 };

/** Draws `series` – {points: [[t, value], …], color, width, dash, name} – into `box`; `marks` are times with a text. */
function drawCurve(box, { series, unit, marks = [], top }) {
	const width = Math.max(200, box.clientWidth), height = box.clientHeight;
	const highest = top || Math.max(1e-9, ...series.flatMap((one) => one.points.map((point) => point[1]))) * 1.05;
	const x = (t) => MARGIN.left + (t / (duration || 1)) * (width - MARGIN.left - MARGIN.right);
	const y = (value) => height - MARGIN.bottom - (value / highest) * (height - MARGIN.top - MARGIN.bottom);
	const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': series.map((one) => one.name).join(', ') + ', over time' });
	const step = tidy(highest);
	for (let value = 0; value <= highest + 1e-9; value += step)
		svg.append(make('line', { x1: MARGIN.left, x2: width - MARGIN.right, y1: y(value), y2: y(value), stroke: theme.line }),
			make('text', { x: MARGIN.left - 6, y: y(value) + 4, 'text-anchor': 'end' }, String(+value.toFixed(6))));
	const timeStep = tidy(duration);
	for (let t = 0; t <= duration + 1e-9; t += timeStep)
		svg.append(make('text', { x: x(t), y: height - MARGIN.bottom + 16, 'text-anchor': 'middle' }, String(+t.toFixed(6))));
	svg.append(make('text', { x: width - MARGIN.right, y: height - 4, 'text-anchor': 'end' }, 'time [s]'),
		make('text', { x: MARGIN.left - 6, y: 11, 'text-anchor': 'end' }, unit));
	for (const [t, text] of marks)
		svg.append(make('path', { d: `M${x(t) - 4},${height - MARGIN.bottom}h8l-4,-8z`, fill: COLORS.yellow, stroke: theme.text, 'stroke-width': 0.8 }, make('title', {}, text)));
	for (const { points, color, width: stroke = 2, dash = '', step: stepped } of series) {
		const corners = points.flatMap(([t, value], i) => (stepped && i ? [[t, points[i - 1][1]], [t, value]] : [[t, value]]));
		svg.append(make('polyline', { points: corners.map(([t, value]) => x(t).toFixed(1) + ',' + y(value).toFixed(1)).join(' '), fill: 'none', stroke: color, 'stroke-width': stroke, 'stroke-dasharray': dash }));
	}
	series.forEach(({ name, color, dash = '' }, i) => {
		const left = MARGIN.left + (i * (width - MARGIN.left)) / series.length;
		svg.append(make('line', { x1: left, x2: left + 26, y1: 7, y2: 7, stroke: color, 'stroke-width': 3, 'stroke-dasharray': dash }),
			make('text', { x: left + 32, y: 11 }, name));
	});
	const cursor = make('line', { y1: MARGIN.top, y2: height - MARGIN.bottom, stroke: theme.accent, 'stroke-width': 2, 'class': 'cursor' });
	svg.append(cursor);
	svg.addEventListener('click', (event) => {
		const share = (event.clientX - svg.getBoundingClientRect().left) / svg.getBoundingClientRect().width * width;
		goTo(cameraAtTime((share - MARGIN.left) / (width - MARGIN.left - MARGIN.right) * duration));
	});
	box.replaceChildren(svg);
	return (t) => { cursor.setAttribute('x1', x(t)); cursor.setAttribute('x2', x(t)); };
}

const cursors = [];
function drawKnown() {
	const covered = plans.filter((plan) => plan.cover !== null).map((plan) => [plan.t, 100 * plan.cover]);
	const known = plans.map((plan) => [plan.t, plan.free]);
	const marks = goals.filter((goal) => goal[1] !== 'none').map((goal) => [timeOf(goal[0]), goal[1] + (goal[2] === null ? '' : ' ' + goal[2]) + ', ' + clock(timeOf(goal[0]))]);
	if (covered.length > 1) {
		el('known-caption').textContent = `Coverage: share of the reachable ${number(summary.truth.reachable_m2, 1)} m² that the map shows as free; ▲ new goals`;
		return drawCurve(el('known-curve'), { series: [{ points: covered, color: COLORS.green, name: 'coverage' }], unit: '%', marks, top: 105 });
	}
	el('known-caption').textContent = 'Floor known to be free; ▲ new goals';
	if (!known.length) {
		el('known-curve').textContent = 'There is no map.';
		return null;
	}
	return drawCurve(el('known-curve'), { series: [{ points: known, color: COLORS.green, name: 'free floor' }], unit: 'm²', marks });
}
function drawTiming() {
	const stage = timing.stages[el('stage-choice').value];
	if (!stage) return null;
	const points = (values) => values.map((value, i) => [timeOf(i * timing.frames), value]);
	const of = timing.frames > 1 ? ` of ${timing.frames} frames` : '';
	return drawCurve(el('timing-curve'), {
		series: timing.frames > 1 ? [{ points: points(stage.max), color: COLORS.vermillion, width: 1, dash: '4 2', name: 'largest' + of },
			{ points: points(stage.median), color: COLORS.blue, name: 'median' + of }] : [{ points: points(stage.median), color: COLORS.blue, name: 'each frame' }],
		unit: 'ms',
	});
}
function drawCurves() {
	cursors.splice(0, cursors.length, ...[drawKnown(), drawTiming()].filter(Boolean));
}
