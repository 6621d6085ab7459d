// The drawing for those who do not see it or have no pointer: each step and transition has a name that says its state, one
// of them can be reached by Tab, and the arrow keys go on to the next one in their direction.

import { mark, shape } from './dom.js';
import { shown } from './values.js';
import { word } from './texts.js';

/** The parts of a drawing as buttons, which set a breakpoint. */
export class Names {
  constructor(svg, model, view, pan, press) {
    this.parts = [];
    const macros = new Map(model.macros.map((macro) => [macro.label, macro]));
    for (const [label, groups] of view.steps) {
      const about = model.step.get(label) ?? macros.get(label);
      for (const group of groups) this.add(group, { kind: 'step', key: label, isMacro: macros.has(label), comment: about?.comment });
    }
    for (const [name, groups] of view.transitions) {
      for (const group of groups) {
        const about = model.transitions[Number(group.dataset.number) - 1];
        this.add(group, { kind: 'transition', key: name, about, comment: about.comment });
      }
    }
    this.parts[0]?.group.setAttribute('tabindex', '0');
    svg.addEventListener('click', (event) => this.pressed(event.target.closest('.step, .transition'), press));
    svg.addEventListener('keydown', (event) => this.key(event, pan, press));
    svg.addEventListener('focusin', (event) => this.rove(event.target));
  }

  add(group, part) {
    group.setAttribute('tabindex', '-1');
    group.setAttribute('role', 'button');
    const box = group.querySelector(':scope > .box');
    let area = { x: -18, y: -9, width: 36, height: 22 };
    let corner = { cx: 0, cy: 2 };
    if (box) {
      const [x, y, width, height] = ['x', 'y', 'width', 'height'].map((name) => Number(box.getAttribute(name)));
      area = { x: x - 4, y: y - 4, width: width + 8, height: height + 8 };
      corner = { cx: x, cy: y };
    } else {
      group.prepend(shape('rect', { class: 'hit', ...area }));
    }
    group.append(shape('rect', { class: 'focus-ring', ...area, rx: 5 }), shape('circle', { class: 'mark', ...corner, r: 5.5 }));
    this.parts.push({ group, ...part });
  }

  /** Names that say what is now. */
  show(breaks) {
    for (const part of this.parts) {
      const { group, kind, key } = part;
      const { classList } = group;
      const states = [['active', 'is-active'], ['forced', 'is-forced'], ['enabled', 'is-enabled'], ['satisfied', 'is-satisfied'], ['cleared', 'is-cleared']];
      const is = states.filter(([name]) => classList.contains(name)).map(([, text]) => word(text));
      const name = [this.title(part), part.comment ? shown(part.comment) : '', ...is].filter(Boolean).join(', ');
      mark(group, 'aria-label', name);
      const isBreak = (kind === 'step' ? breaks.steps : breaks.transitions).has(key);
      mark(group, 'aria-pressed', String(isBreak));
      classList.toggle('breaks', isBreak);
    }
  }

  title({ kind, key, isMacro, about }) {
    if (kind === 'step') return word(isMacro ? 'macro-named' : 'step-named', { label: shown(key) });
    return transitionName(about);
  }

  pressed(group, press) {
    const part = group && this.parts.find((one) => one.group === group);
    if (part) press(part.kind, part.key);
  }

  /** The one that Tab comes to. */
  rove(target) {
    if (!this.parts.some((part) => part.group === target)) return;
    for (const part of this.parts) part.group.setAttribute('tabindex', part.group === target ? '0' : '-1');
  }

  key(event, pan, press) {
    const from = event.target.closest('.step, .transition');
    if (!from || event.ctrlKey || event.altKey || event.metaKey) return;
    const way = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] }[event.key];
    if (way && event.shiftKey) pan.move(-60 * way[0], -60 * way[1]);
    else if (way) this.next(from, way, pan);
    else if (event.key === 'Enter' || event.key === ' ') this.pressed(from, press);
    else if (event.key === '+') pan.zoom(1.25);
    else if (event.key === '-') pan.zoom(0.8);
    else if (event.key === '0') pan.fit();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** The nearest part in a direction; what is aside counts as further. */
  next(from, [across, down], pan) {
    const middle = (element) => {
      const { left, right, top, bottom } = element.getBoundingClientRect();
      const box = element.querySelector(':scope > .box, :scope > .bar')?.getBoundingClientRect();
      return box ? [(box.left + box.right) / 2, (box.top + box.bottom) / 2] : [(left + right) / 2, (top + bottom) / 2];
    };
    const [x, y] = middle(from);
    let best = null;
    for (const { group } of this.parts) {
      if (group === from || group.closest('.folded, .away')) continue;
      const [otherX, otherY] = middle(group);
      const along = (otherX - x) * across + (otherY - y) * down;
      const aside = Math.abs((otherX - x) * down) + Math.abs((otherY - y) * across);
      if (along > 1 && (!best || along + 2.5 * aside < best.far)) best = { group, far: along + 2.5 * aside };
    }
    if (!best) return;
    best.group.focus({ preventScroll: true });
    pan.reveal(best.group);
  }
}

/** What a transition is called: by its designation, or by the steps before and after it. */
export function transitionName({ designation, before, after }) {
  if (designation !== undefined) return word('transition-named', { label: shown(designation) });
  const list = (labels) => labels.map(shown).join(', ');
  return word('transition-between', { before: list(before), after: list(after) });
}
