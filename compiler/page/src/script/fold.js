// Grafcets and expansions folded to their names, and what stands in them with them; the rest moves together.

import { gather, shape } from './dom.js';

/** From one diagram to the next, as in the drawing. */
const APART = 60;
/** What stays free around all. */
const MARGIN = 20;

/** The frames of a drawing, what each stands in, and which are folded. */
export class Fold {
  constructor(svg, pan, model, changed) {
    Object.assign(this, { svg, pan, changed });
    this.frames = [];
    const steps = gather(svg, 'data-step');
    const holder = (label) => steps.get(label)?.[0].closest('.frame') ?? null;
    for (const group of svg.querySelectorAll('.frame')) {
      const { grafcet, expansion } = group.dataset;
      const enclosing = grafcet === undefined ? expansion : model.grafcets.find((one) => one.name === grafcet)?.enclosing;
      const name = group.querySelector(':scope > .name');
      const at = group.transform.baseVal.consolidate()?.matrix;
      const parent = enclosing === undefined ? null : holder(enclosing);
      this.frames.push({ group, parent, name, key: grafcet ?? expansion, isGrafcet: grafcet !== undefined, x: at?.e ?? 0, y: at?.f ?? 0, isFolded: false });
      name?.addEventListener('click', () => this.toggle(grafcet ?? expansion));
    }
    const byGroup = new Map(this.frames.map((frame) => [frame.group, frame]));
    for (const frame of this.frames) frame.parent = byGroup.get(frame.parent) ?? null;
    this.whole = { ...pan.whole };
  }

  /** What can be folded: whatever has a name to be folded to. */
  get foldable() {
    return this.frames.filter((frame) => frame.name);
  }

  toggle(key) {
    const frame = this.foldable.find((one) => one.key === key);
    if (!frame) return;
    frame.isFolded = !frame.isFolded;
    if (frame.isFolded && !frame.group.querySelector(':scope > .fold-box')) {
      const { x, y, width, height } = frame.name.getBBox();
      frame.group.prepend(shape('rect', { class: 'fold-box', x: x - 8, y: y - 5, width: width + 16, height: height + 10, rx: 5 }));
    }
    this.arrange();
    this.changed(frame);
  }

  /** Hides what is folded, and puts the rest side by side again. */
  arrange() {
    // What a frame stands in comes before it in the drawing.
    for (const frame of this.frames) {
      frame.isAway = frame.parent !== null && (frame.parent.isFolded || frame.parent.isAway);
      frame.root = frame.parent?.root ?? frame;
      frame.group.classList.toggle('folded', frame.isFolded);
      frame.group.classList.toggle('away', frame.isAway);
    }
    const trees = new Map();
    for (const frame of this.frames) trees.has(frame.root) ? trees.get(frame.root).push(frame) : trees.set(frame.root, [frame]);
    if (![...trees.keys()].some((root) => root.isFolded)) {
      for (const frame of this.frames) place(frame, 0, 0);
      this.pan.setWhole(this.whole);
      return;
    }
    const right = this.whole.x + this.whole.width;
    const [left, top] = [this.whole.x + MARGIN, this.whole.y + MARGIN];
    let [x, y, bottom, wide] = [left, top, top, left];
    for (const tree of trees.values()) {
      const own = tree.filter((frame) => !frame.isAway);
      const box = union(own);
      if (x > left && x + box.width > right) [x, y] = [left, bottom + APART];
      for (const frame of own) place(frame, x - box.x, y - box.y);
      x += box.width + APART;
      bottom = Math.max(bottom, y + box.height);
      wide = Math.max(wide, x - APART);
    }
    this.pan.setWhole({ x: left - MARGIN, y: top - MARGIN, width: wide - left + 2 * MARGIN, height: bottom - top + 2 * MARGIN });
  }
}

function place(frame, dx, dy) {
  frame.group.setAttribute('transform', `translate(${frame.x + dx} ${frame.y + dy})`);
}

/** What frames take together, at the places of the drawing. */
function union(frames) {
  const boxes = frames.map((frame) => {
    const { x, y, width, height } = frame.group.getBBox();
    return [frame.x + x, frame.y + y, frame.x + x + width, frame.y + y + height];
  });
  const x = Math.min(...boxes.map((box) => box[0]));
  const y = Math.min(...boxes.map((box) => box[1]));
  return { x, y, width: Math.max(...boxes.map((box) => box[2])) - x, height: Math.max(...boxes.map((box) => box[3])) - y };
}
