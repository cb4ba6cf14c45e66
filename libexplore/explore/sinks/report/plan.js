// The map seen from above, as it was at the frame that is shown.
const DASH = 'M-8,-2h6v4h-6zM2,-2h6v4h-6z', BAR = 'M-8,-2h16v4h-16z', BLOCK = 'M-7,-7h14v14h-14z';
const planView = { zoom: 1, x: 0, y: 0, image: null, drawn: -1, box: null };
const LEFT = {
	sealed: 'looked at, and nothing came of it: no ray gets in',
	too_narrow: 'the robot does not fit',
	out_of_reach: 'seen across something, without a way there',
	closed_door: 'a door stands there that is closed or blocked',
	behind_glass: 'an opening from which nothing came back',
	drop: 'no floor',
	kept_out: 'in a keep-out area',
	outside_bounds: 'outside of the bounds',
};

/** [left, bottom, right, top] in the map of all that is ever shown. */
function planBox() {
	let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
	const take = (x, y) => { left = Math.min(left, x); right = Math.max(right, x); bottom = Math.min(bottom, y); top = Math.max(top, y); };
	history.seek(plans.length - 1);
	for (let row = 0; row < history.rows; ++row)
		for (let column = 0; column < history.columns; ++column)
			if (history.cells[row * history.columns + column])
				take((history.firstX + column + 0.5) * history.cell_m, (history.firstY + row + 0.5) * history.cell_m);
	for (const pose of poses) if (pose[2] !== null) take(pose[2], pose[3]);
	const margin = 0.6;
	return [left - margin, bottom - margin, right + margin, top + margin];
}

/** Metres to pixels of the canvas. */
function planTransform(width, height) {
	const [left, bottom, right, top] = planView.box;
	const scale = Math.min(width / (right - left), height / (top - bottom)) * planView.zoom;
	const cx = 0.5 * (left + right) + planView.x, cy = 0.5 * (bottom + top) + planView.y;
	return { scale, at: (x, y) => [0.5 * width + (x - cx) * scale, 0.5 * height - (y - cy) * scale] };
}

/** The cells as an image, one pixel each, the largest y on top. */
function cellImage() {
	const { columns, rows, cells } = history;
	if (!columns) return null;
	if (!planView.image) planView.image = make('canvas', { width: columns, height: rows });
	if (planView.drawn === history.told) return planView.image;
	const context = planView.image.getContext('2d'), picture = context.createImageData(columns, rows);
	for (let row = 0; row < rows; ++row)
		for (let column = 0; column < columns; ++column) {
			const state = cells[row * columns + column];
			if (!state) continue;
			const color = theme.cells[state === 4 && !planOn.frontiers ? 1 : state], to = 4 * ((rows - 1 - row) * columns + column);
			picture.data[to] = color[0]; picture.data[to + 1] = color[1]; picture.data[to + 2] = color[2]; picture.data[to + 3] = 255;
		}
	context.putImageData(picture, 0, 0);
	planView.drawn = history.told;
	return planView.image;
}

function drawDoors(context, view) {
	for (const [track, x, y, normal, width, verdict, , visited] of history.doors.values()) {
		const { color, path } = verdictOf(verdict), ax = -Math.sin(normal) * width / 2, ay = Math.cos(normal) * width / 2;
		drawLine(context, [view.at(x - ax, y - ay), view.at(x + ax, y + ay)], color, 5);
		const [px, py] = view.at(x, y);
		drawSign(context, path, color, px, py, 0.8);
		drawText(context, track + (visited ? ' ✓' : ''), px + 11, py - 9, { align: 'left' });
	}
}
function drawCorridors(context, view) {
	for (const [track, x1, y1, x2, y2] of history.corridors.values()) {
		const from = view.at(x1, y1), to = view.at(x2, y2);
		drawLine(context, [from, to], COLORS.purple, 2, { dash: [8, 6] });
		drawText(context, 'C' + track, to[0], to[1] + 10);
	}
}
function drawPath(context, view, frame) {
	const end = poseAt(frame), points = [];
	for (let i = 0; i <= end; ++i) if (poses[i][2] !== null) points.push(view.at(poses[i][2], poses[i][3]));
	drawLine(context, points, COLORS.blue, 2);
	const first = poses.find((pose) => pose[2] !== null);
	if (first) drawText(context, 'start', ...view.at(first[2], first[3] - 0.5), { size: 11 });
}
function drawGoals(context, view, frame) {
	for (const goal of goals) {
		if (goal[0] >= frame) break;
		if (goal[3] === null) continue;
		const [x, y] = view.at(goal[3], goal[4]);
		context.beginPath();
		context.arc(x, y, 2.5, 0, 7);
		context.fillStyle = theme.faint;
		context.fill();
	}
	const goal = goalAt(frame), pose = poses[poseAt(frame)];
	if (!goal || goal[3] === null || goal[3] === undefined) return;
	const to = view.at(goal[3], goal[4]);
	if (pose && pose[2] !== null) drawLine(context, [view.at(pose[2], pose[3]), to], theme.text, 1.2, { dash: [3, 4] });
	drawSign(context, STAR, COLORS.yellow, ...to);
	drawText(context, goal[1] + (goal[2] === null ? '' : ' ' + goal[2]), to[0], to[1] + 17);
}
function drawRobot(context, view, frame) {
	const pose = poses[poseAt(frame)];
	if (!pose || pose[2] === null) return;
	const [x, y] = view.at(pose[2], pose[3]), radius = Math.max(6, radius_m * view.scale);
	context.save();
	context.translate(x, y);
	context.rotate(-pose[4]);
	context.beginPath();
	context.moveTo(radius * 2.2, 0);
	context.arc(0, 0, radius, 0.8, 2 * Math.PI - 0.8);
	context.closePath();
	context.fillStyle = COLORS.blue;
	context.strokeStyle = theme.halo;
	context.lineWidth = 4;
	context.stroke();
	context.fill();
	if (pose[5]) {  // it must stand still
		context.fillStyle = '#fff';
		context.fillRect(-0.45 * radius, -0.45 * radius, 0.9 * radius, 0.9 * radius);
	}
	context.restore();
}
function drawLeft(context, view) {
	for (const left of summary.exploration.left_over) {
		const [x, y] = view.at(left.center_in_map[0], left.center_in_map[1]);
		drawSign(context, CROSS, COLORS.grey, x, y, 0.7);
	}
}
function drawChosen(context, view) {
	if (!chosen.place) return;
	const [x, y] = view.at(chosen.place[0], chosen.place[1]);
	for (const [color, width] of [[theme.halo, 6], [theme.accent, 3]]) {
		context.beginPath();
		context.arc(x, y, 18, 0, 7);
		context.lineWidth = width;
		context.strokeStyle = color;
		context.stroke();
	}
	drawText(context, chosen.label, x, y - 28, { size: 13 });
}
/** A bar of a round length. */
function drawScale(context, view, height) {
	const metres = [0.5, 1, 2, 5, 10, 20, 50, 100].find((length) => length * view.scale >= 60) || 200;
	const y = height - 14, end = 12 + metres * view.scale;
	drawLine(context, [[12, y - 4], [12, y], [end, y], [end, y - 4]], theme.text, 2);
	drawText(context, metres + ' m', 0.5 * (12 + end), y - 10);
}

function drawPlan(frame) {
	if (!planView.box) return;
	history.seek(planAt(frame));
	const { context, width, height } = prepare(el('plan')), view = planTransform(width, height);
	const image = cellImage();
	if (image) {
		const [x, y] = view.at(history.firstX * history.cell_m, (history.firstY + history.rows) * history.cell_m);
		context.imageSmoothingEnabled = view.scale * history.cell_m < 2;
		context.drawImage(image, x, y, history.columns * history.cell_m * view.scale, history.rows * history.cell_m * view.scale);
	}
	if (planOn.corridors) drawCorridors(context, view);
	if (planOn.path) drawPath(context, view, frame);
	if (planOn.left && (chosen.left || frame >= cameras[cameras.length - 1].i)) drawLeft(context, view);
	if (planOn.doors) drawDoors(context, view);
	if (planOn.goals) drawGoals(context, view, frame);
	drawRobot(context, view, frame);
	drawChosen(context, view);
	drawScale(context, view, height);
}

const planOn = makeSwitches(el('plan-switches'), [
	['path', 'way', BAR, COLORS.blue], ['doors', 'doors', VERDICTS.open.path, COLORS.green],
	['corridors', 'corridors', DASH, COLORS.purple], ['frontiers', 'frontiers', BLOCK, COLORS.orange],
	['goals', 'goals', STAR, COLORS.yellow], ['left', 'left over', CROSS, COLORS.grey],
], () => { planView.drawn = -2; show(); });

function zoomBy(factor) {
	planView.zoom = Math.min(20, Math.max(1, planView.zoom * factor));
	if (planView.zoom === 1) planView.x = planView.y = 0;
	el('plan').classList.toggle('zoomed', planView.zoom > 1);
	show();
}
function panBy(dx, dy) {
	const box = el('plan').getBoundingClientRect(), { scale } = planTransform(box.width, box.height);
	planView.x -= dx / scale;
	planView.y += dy / scale;
	show();
}
