// What the run left in this page, and how to look things up in it.
const read = (id) => JSON.parse(document.getElementById(id).textContent);
const summary = read('summary'), timing = read('timing'), run = read('run');
const el = (id) => document.getElementById(id);
const cameras = run.cameras, poses = run.poses, goals = run.goals, plans = run.plans;
const range_m = run.beginning ? run.beginning.range : 5;
const radius_m = run.beginning ? run.beginning.radius : 0.22;
const hasPlace = poses.some((pose) => pose[2] !== null);

/** The last place in `list`, in which key() grows, whose key is not above `value`; −1: there is none. */
function lastUpTo(list, value, key) {
	let low = 0, high = list.length;
	while (low < high) {
		const middle = (low + high) >> 1;
		if (key(list[middle]) <= value) low = middle + 1;
		else high = middle;
	}
	return low - 1;
}

const poseAt = (frame) => lastUpTo(poses, frame, (pose) => pose[0]);
const planAt = (frame) => lastUpTo(plans, frame, (plan) => plan.i);
const goalAt = (frame) => goals[lastUpTo(goals, frame, (goal) => goal[0])];
const cameraAt = (frame) => Math.max(0, lastUpTo(cameras, frame, (camera) => camera.i));
const cameraAtTime = (t) => Math.max(0, lastUpTo(cameras, t, (camera) => camera.t));
const timeOf = (frame) => { const at = poseAt(frame); return at < 0 ? 0 : poses[at][1]; };
const duration = poses.length ? poses[poses.length - 1][1] : 0;

const number = (value, digits) => (value === null || value === undefined ? '–' : value.toFixed(digits));
const clock = (t) => (duration < 120 ? t.toFixed(1) + ' s' : Math.floor(t / 60) + ':' + String(Math.floor(t % 60)).padStart(2, '0'));

/** An element with attributes, or a text where a child is one. Texts are only ever set as texts. */
function make(tag, attributes, ...children) {
	const drawn = /^(svg|path|line|polyline|text|g|rect|circle|title)$/.test(tag);
	const element = drawn ? document.createElementNS('http://www.w3.org/2000/svg', tag) : document.createElement(tag);
	for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
	element.append(...children);
	return element;
}

/** The plan as it was when one of `plans` was told. Steps forward are quick; the way back starts at a kept state. */
class PlanHistory {
	constructor() {
		const at = plans.length ? plans[plans.length - 1].at : [0, 0, 0, 0, 0.05];
		[this.firstX, this.firstY, this.columns, this.rows, this.cell_m] = at;
		this.kept = [];
		this.restart({ told: -1, cells: new Uint8Array(this.columns * this.rows), doors: new Map(), corridors: new Map() });
	}
	restart(state) {
		this.told = state.told;
		this.cells = state.cells.slice();
		this.doors = new Map(state.doors);
		this.corridors = new Map(state.corridors);
	}
	seek(wanted) {
		const every = 32;
		if (!this.kept.length) this.kept.push({ told: -1, cells: this.cells.slice(), doors: new Map(), corridors: new Map() });
		const nearest = Math.min(this.kept.length - 1, Math.floor((wanted + 1) / every));
		if (wanted < this.told || this.kept[nearest].told > this.told) this.restart(this.kept[nearest]);
		while (this.told < wanted) {
			this.apply(plans[++this.told]);
			if ((this.told + 1) % every === 0 && this.kept.length === (this.told + 1) / every)
				this.kept.push({ told: this.told, cells: this.cells.slice(), doors: new Map(this.doors), corridors: new Map(this.corridors) });
		}
	}
	apply(plan) {
		const [x, y, columns] = plan.at;
		const bytes = Uint8Array.from(atob(plan.cells), (c) => c.charCodeAt(0));
		let next = 0, cell = 0;
		const take = () => {
			let value = 0, factor = 1, byte;
			do { byte = bytes[next++]; value += (byte & 127) * factor; factor *= 128; } while (byte & 128);
			return value;
		};
		while (next < bytes.length) {
			cell += take();
			const change = take(), state = change % 8;
			for (let count = Math.floor(change / 8); count > 0; --count, ++cell)
				this.cells[(Math.floor(cell / columns) + y - this.firstY) * this.columns + (cell % columns) + x - this.firstX] = state;
		}
		for (const track of plan.gone) this.doors.delete(track);
		for (const door of plan.doors) this.doors.set(door[0], door);
		for (const track of plan.ended) this.corridors.delete(track);
		for (const corridor of plan.corridors) this.corridors.set(corridor[0], corridor);
	}
}
const history = new PlanHistory();
