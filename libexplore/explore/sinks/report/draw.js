// Colours and signs. Okabe and Ito's colours can be told apart by nearly everybody; every sign has a shape of its own too.
const COLORS = {
	black: '#000000', orange: '#e69f00', sky: '#56b4e9', green: '#009e73', yellow: '#f0e442', blue: '#0072b2',
	vermillion: '#d55e00', purple: '#cc79a7', grey: '#8a93a3',
};
/** Paths in a box from −8 to 8. */
const VERDICTS = {
	open: { color: COLORS.green, path: 'M-6,0a6,6 0 1,0 12,0a6,6 0 1,0 -12,0z' },
	ajar: { color: COLORS.yellow, path: 'M-6,6L6,6L6,-6z' },
	passage: { color: COLORS.sky, path: 'M0,-7L7,0L0,7L-7,0z' },
	closed: { color: COLORS.vermillion, path: 'M-6,-6h12v12h-12z' },
	blocked: { color: COLORS.orange, path: 'M-6,-3L-3,-6L0,-3L3,-6L6,-3L3,0L6,3L3,6L0,3L-3,6L-6,3L-3,0z' },
	drop: { color: COLORS.purple, path: 'M-7,-5L7,-5L0,7z' },
	partial: { color: COLORS.blue, path: 'M0,-6a6,6 0 0,0 0,12z' },
	unknown: { color: COLORS.grey, path: 'M-6,-2h12v4h-12z' },
};
const verdictOf = (name) => VERDICTS[name] || VERDICTS.unknown;
const STAR = 'M0,-8L2.2,-2.6L8,-2.4L3.5,1.2L5,7L0,3.7L-5,7L-3.5,1.2L-8,-2.4L-2.2,-2.6z';
const CROSS = 'M-6,-4L-4,-6L0,-2L4,-6L6,-4L2,0L6,4L4,6L0,2L-4,6L-6,4L-2,0z';

let theme = {};
function readTheme() {
	const style = getComputedStyle(document.documentElement);
	for (const name of ['text', 'faint', 'line', 'accent', 'unknown', 'free', 'occupied', 'drop', 'frontier', 'halo', 'card'])
		theme[name] = style.getPropertyValue('--' + name).trim();
	const cells = ['unknown', 'free', 'occupied', 'drop', 'frontier'].map((name) => rgbOf(theme[name]));
	theme.cells = cells;
}
/** Of #rgb or #rrggbb. */
function rgbOf(color) {
	const hex = color.length === 4 ? color.replace(/[0-9a-f]/gi, '$&$&') : color;
	return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
}

/** A small picture of a sign for legends and tables. */
function sign(path, color) {
	return make('svg', { viewBox: '-9 -9 18 18', 'aria-hidden': 'true' },
		make('path', { d: path, fill: color, stroke: 'currentColor', 'stroke-width': '1.2' }));
}
function drawSign(context, path, color, x, y, scale = 1) {
	context.save();
	context.translate(x, y);
	context.scale(scale, scale);
	const shape = new Path2D(path);
	context.lineWidth = 3;
	context.strokeStyle = theme.halo;
	context.stroke(shape);
	context.fillStyle = color;
	context.fill(shape);
	context.lineWidth = 1;
	context.strokeStyle = theme.text;
	context.stroke(shape);
	context.restore();
}
/** Text that can be read on anything. */
function drawText(context, text, x, y, { color = theme.text, halo = theme.halo, align = 'center', size = 12 } = {}) {
	context.font = `600 ${size}px system-ui, sans-serif`;
	context.textAlign = align;
	context.textBaseline = 'middle';
	context.lineJoin = 'round';
	context.lineWidth = 3;
	context.strokeStyle = halo;
	context.strokeText(text, x, y);
	context.fillStyle = color;
	context.fillText(text, x, y);
}
/** A line with a border that sets it off from what is below. */
function drawLine(context, points, color, width, { halo = theme.halo, dash = [] } = {}) {
	if (points.length < 2) return;
	context.beginPath();
	points.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
	context.setLineDash(dash);
	context.lineCap = dash.length ? 'butt' : 'round';
	context.lineJoin = 'round';
	if (halo) {
		context.lineWidth = width + 2;
		context.strokeStyle = halo;
		context.stroke();
	}
	context.lineWidth = width;
	context.strokeStyle = color;
	context.stroke();
	context.setLineDash([]);
}
function drawArrow(context, [x1, y1, x2, y2], color, width, halo) {
	const length = Math.hypot(x2 - x1, y2 - y1);
	if (length < 2) return;
	const head = Math.min(4 * width, 0.6 * length), ux = (x2 - x1) / length, uy = (y2 - y1) / length;
	const nx = x2 - head * ux, ny = y2 - head * uy;
	drawLine(context, [[x1, y1], [nx, ny]], color, width, { halo });
	context.beginPath();
	context.moveTo(x2, y2);
	context.lineTo(nx - 0.5 * head * uy, ny + 0.5 * head * ux);
	context.lineTo(nx + 0.5 * head * uy, ny - 0.5 * head * ux);
	context.closePath();
	context.lineWidth = 2;
	context.strokeStyle = halo;
	context.stroke();
	context.fillStyle = color;
	context.fill();
}
/** Makes a canvas as fine as the screen; returns its context, in CSS pixels, and its size. */
function prepare(canvas) {
	const box = canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
	const width = Math.max(1, Math.round(box.width)), height = Math.max(1, Math.round(box.height));
	if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
		canvas.width = Math.round(width * ratio);
		canvas.height = Math.round(height * ratio);
	}
	const context = canvas.getContext('2d');
	context.setTransform(ratio, 0, 0, ratio, 0, 0);
	context.clearRect(0, 0, width, height);
	return { context, width, height };
}
/** Checkboxes for what is drawn; `change` is called when one is. Returns what is on. */
function makeSwitches(box, entries, change) {
	const on = {};
	for (const [name, label, path, color] of entries) {
		on[name] = true;
		const input = make('input', { type: 'checkbox', checked: '' });
		input.addEventListener('change', () => { on[name] = input.checked; change(); });
		box.append(make('label', {}, input, sign(path, color), label));
	}
	return on;
}
