// The depth image of the frame that is shown, with what was found in it and where the robot wants to go.
const NO_RETURN = 24, FAR = 48, NEAR = 255;  // grey values of the pictures
/** The same colours as pictures/NNNNNN.png: near is pale, far is deep blue. */
const DEPTHS = [[238, 232, 213], [160, 193, 189], [86, 143, 165], [49, 92, 137], [33, 44, 88]];
const ARROWS = {
	vp: ['VP', COLORS.purple, 4], door: ['nearest door', COLORS.yellow, 4], avoid: ['evade', COLORS.green, 4], go: ['go', '#ffffff', 6],
};

const depthColors = Array.from({ length: 256 }, (_, grey) => {
	if (grey < NO_RETURN) return [0, 0, 0];
	const at = Math.min(1, Math.max(0, (NEAR - grey) / (NEAR - FAR))) * (DEPTHS.length - 1), below = Math.min(Math.floor(at), DEPTHS.length - 2);
	return DEPTHS[below].map((value, i) => value + (at - below) * (DEPTHS[below + 1][i] - value));
});

/** Pictures that were decoded lately, as canvases in colour. */
const pictures = new Map();
async function pictureOf(camera) {
	if (!camera.img) return null;
	if (pictures.has(camera.i)) return pictures.get(camera.i);
	const image = new Image();
	image.src = 'data:image/jpeg;base64,' + camera.img;
	await image.decode();
	const canvas = make('canvas', { width: image.naturalWidth, height: image.naturalHeight });
	const context = canvas.getContext('2d', { willReadFrequently: true });
	context.drawImage(image, 0, 0);
	const picture = context.getImageData(0, 0, canvas.width, canvas.height);
	for (let i = 0; i < picture.data.length; i += 4) {
		const color = depthColors[picture.data[i]];
		picture.data[i] = color[0]; picture.data[i + 1] = color[1]; picture.data[i + 2] = color[2];
	}
	context.putImageData(picture, 0, 0);
	if (pictures.size >= 80) pictures.delete(pictures.keys().next().value);
	pictures.set(camera.i, canvas);
	return canvas;
}

function drawOutlines(context, camera, scale) {
	for (const door of camera.doors) {
		const { color } = verdictOf(door.v), sides = door.q.map((side) => side.map((value) => value * scale));
		const wide = chosen.track !== null && door.n === chosen.track;
		for (const [x1, y1, x2, y2] of sides) drawLine(context, [[x1, y1], [x2, y2]], color, wide ? 5 : 3, { halo: '#000' });
	}
	for (const door of camera.doors) {
		if (!door.q.length) continue;
		const { color, path } = verdictOf(door.v), xs = door.q.map((side) => side[0] * scale), ys = door.q.map((side) => side[1] * scale);
		const x = Math.min(Math.max(0.5 * (Math.min(...xs) + Math.max(...xs)), 40), 1000 * scale - 40);
		const y = Math.min(Math.max(0.5 * (Math.min(...ys) + Math.max(...ys)), 20), 1000 * scale * camera.ratio - 30);
		drawSign(context, path, color, x, y - 16);
		drawText(context, (door.n === null ? '' : door.n + ' ') + (door.v === 'open' ? 'door' : door.v), x, y, { color: '#fff', halo: '#000' });
		drawText(context, door.c.toFixed(2) + ' m', x, y + 14, { color: '#fff', halo: '#000', size: 11 });
	}
}
function drawMarks(context, camera, scale) {
	const scaled = (values) => values.map((value) => value * scale);
	if (cameraOn.walls)
		for (const wall of camera.walls) {
			const [x1, y1, x2, y2] = scaled(wall);
			drawLine(context, [[x1, y1], [x2, y2]], COLORS.sky, 3, { halo: '#000' });
		}
	if (cameraOn.arrows)
		for (const [name, ends] of Object.entries(camera.arrows)) {
			const [label, color, width] = ARROWS[name], arrow = scaled(ends);
			drawArrow(context, arrow, color, width, '#000');
			drawText(context, label, arrow[2], arrow[3] - 10, { color, halo: '#000' });
		}
	if (cameraOn.doors) drawOutlines(context, camera, scale);
	if (cameraOn.vp)
		for (const [u, v] of camera.vp) {
			const [x, y] = [u * scale, v * scale];
			for (const [color, width] of [['#000', 5], [COLORS.purple, 3]]) {
				context.beginPath();
				context.arc(x, y, 9, 0, 7);
				context.moveTo(x - 14, y); context.lineTo(x + 14, y);
				context.moveTo(x, y - 14); context.lineTo(x, y + 14);
				context.lineWidth = width;
				context.strokeStyle = color;
				context.stroke();
			}
			drawText(context, 'VP', x, y - 22, { color: COLORS.purple, halo: '#000' });
		}
}

async function drawCamera(camera) {
	const picture = await pictureOf(camera);
	if (cameras[current] !== camera) return;  // another frame was asked for in the meantime
	el('camera-none').hidden = Boolean(camera.img);
	el('camera-stage').hidden = !camera.img;
	if (!picture) {
		el('camera-none').textContent = 'A cloud of points, or an empty frame: there is no image. Openings found: ' + camera.seen + '.';
		return;
	}
	el('camera-stage').style.aspectRatio = `1 / ${camera.ratio}`;
	const { context, width } = prepare(el('camera'));
	context.imageSmoothingEnabled = true;
	context.drawImage(picture, 0, 0, width, width * camera.ratio);
	drawMarks(context, camera, width / 1000);
	if (camera.stop) drawText(context, 'STOP: ' + camera.stop.replaceAll('_', ' '), width / 2, 16, { color: '#fff', halo: '#b00000', size: 14 });
}

const cameraOn = makeSwitches(el('camera-switches'), [
	['doors', 'doors', 'M-5,8V-8H5V8', 'none'], ['walls', 'wall–floor lines', BAR, COLORS.sky],
	['vp', 'vanishing point', 'M-8,0H8M0,-8V8M-5,0a5,5 0 1,0 10,0a5,5 0 1,0 -10,0z', COLORS.purple],
	['arrows', 'headings: nearest door (yellow), VP (pink), evade (green), go (white)', 'M-8,-2H2V-6L8,0L2,6V2H-8z', COLORS.yellow],
], () => show());

function drawRamp() {
	const context = el('ramp').getContext('2d');
	for (let x = 0; x < 200; ++x) {
		const [r, g, b] = depthColors[Math.round(NEAR + (x / 199) * (FAR - NEAR))];
		context.fillStyle = `rgb(${r},${g},${b})`;
		context.fillRect(x, 0, 1, 10);
	}
	el('ramp-far').textContent = range_m + ' m and more';
}
