// The drawing alive: what is active, enabled, cleared, forced, frozen, acting, broken and reached is lit.

import { gather, shape } from './dom.js';

/** How long a clearing stays lit in a run, in milliseconds. */
const AFTERGLOW = 350;

/** One class of light, and the elements that bear it. */
class Light {
  constructor(name) {
    this.name = name;
    this.lit = new Set();
  }

  show(elements) {
    for (const element of this.lit) if (!elements.has(element)) element.classList.remove(this.name);
    for (const element of elements) if (!this.lit.has(element)) element.classList.add(this.name);
    this.lit = elements;
  }
}

/** The lights on a drawing. */
export class View {
  constructor(svg, model) {
    this.svg = svg;
    this.model = model;
    this.steps = gather(svg, 'data-step');
    this.actions = gather(svg, 'data-action');
    this.orders = gather(svg, 'data-order');
    this.grafcets = gather(svg, 'data-grafcet');
    this.claims = gather(svg, 'data-claim');
    const numbers = gather(svg, 'data-number');
    // By the name that the module gives them.
    this.transitions = new Map(model.transitions.map(({ name, index }) => [name, numbers.get(String(index + 1)) ?? []]));
    const names = ['active', 'forced', 'enabled', 'satisfied', 'cleared', 'acting', 'in-force', 'frozen', 'broken', 'reached'];
    this.lights = new Map(names.map((name) => [name, new Light(name)]));
    this.glows = { cleared: new Map(), acted: new Map() };
    const isStored = (group) => group.matches('.on-activation, .on-deactivation, .on-event, .on-clearing');
    this.stored = new Set([...this.actions].filter(([, groups]) => groups.some(isStored)).map(([number]) => number));
    for (const [step] of this.steps.values()) addDot(step);
    for (const frames of this.grafcets.values()) frames.forEach(addFrost);
  }

  /** Shows where the engine is. While it runs, a clearing glows for a moment, else as long as nothing happens. */
  show(engine, isRunning, now) {
    const { situation, enabled, observed } = engine;
    const active = [...situation, ...this.model.activeMacros(situation)];
    this.light('active', this.steps, active);
    this.light('forced', this.steps, observed.forced ?? []);
    this.light('enabled', this.transitions, enabled);
    this.light('satisfied', this.transitions, observed.satisfied ?? []);
    this.light('in-force', this.orders, (observed.orders ?? []).map(String));
    this.light('frozen', this.grafcets, observed.frozen ?? []);
    this.light('broken', this.claims, (observed.broken ?? []).map(String));
    this.light('reached', this.claims, (observed.reached ?? []).map(String));
    this.light('cleared', this.transitions, this.lately('cleared', engine, isRunning, now));
    const acted = [...this.lately('acted', engine, isRunning, now)].map(String).filter((number) => this.stored.has(number));
    this.light('acting', this.actions, [...(observed.actions ?? []).map(String), ...acted]);
  }

  /** What happened in the last scan; in a run, what happened a moment ago. */
  lately(what, engine, isRunning, now) {
    const [glow, fresh] = [this.glows[what], engine.fresh[what]];
    if (isRunning) {
      for (const key of fresh) glow.set(key, now + AFTERGLOW);
      for (const [key, until] of glow) if (until < now) glow.delete(key);
    } else {
      glow.clear();
    }
    fresh.clear();
    return isRunning ? glow.keys() : engine[what];
  }

  light(name, elements, keys) {
    const found = new Set();
    for (const key of keys) for (const element of elements.get(key) ?? []) found.add(element);
    this.lights.get(name).show(found);
  }
}

/** The dot of an active step, so that paper shows it, too. */
function addDot(step) {
  const label = step.querySelector(':scope > .label');
  if (!label || step.querySelector(':scope > .dot')) return;
  const dot = shape('circle', { class: 'fill dot', cx: label.getAttribute('x'), cy: Number(label.getAttribute('y')) + 6, r: 4 });
  label.after(dot);
}

/** What lies under a grafcet that is frozen, also where it has no frame. */
function addFrost(frame) {
  const { x, y, width, height } = frame.getBBox();
  frame.prepend(shape('rect', { class: 'frozen-mark', x: x - 8, y: y - 8, width: width + 16, height: height + 16, rx: 6 }));
}
