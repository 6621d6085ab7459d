// The part of the drawing that is seen: it is moved by dragging, enlarged around the pointer, and made to fit.

/** The view box of a drawing. */
export class Pan {
  constructor(canvas, svg) {
    this.canvas = canvas;
    this.svg = svg;
    const { x, y, width, height } = svg.viewBox.baseVal;
    this.whole = { x, y, width, height };
    this.fit();
    this.listen();
  }

  /** Shows all of it. What is small is not made larger than twice its size. */
  fit() {
    const { clientWidth: wide, clientHeight: high } = this.canvas;
    const { x, y, width, height } = this.whole;
    const scale = Math.min(wide / width, high / height, 2) || 1;
    this.isFit = true;
    this.show({ x: x + width / 2 - wide / scale / 2, y: y + height / 2 - high / scale / 2, width: wide / scale || width, height: high / scale || height });
  }

  /** Another whole, as after folding. */
  setWhole(whole) {
    this.whole = whole;
    if (this.isFit) this.fit();
  }

  show(box) {
    this.box = box;
    this.svg.setAttribute('viewBox', `${box.x} ${box.y} ${box.width} ${box.height}`);
  }

  move(dx, dy) {
    const scale = this.box.width / this.canvas.clientWidth;
    this.isFit = false;
    this.show({ ...this.box, x: this.box.x - dx * scale, y: this.box.y - dy * scale });
  }

  /** Enlarges around a point of the window, by default the middle. */
  zoom(factor, clientX, clientY) {
    const area = this.canvas.getBoundingClientRect();
    const across = clientX === undefined ? 0.5 : (clientX - area.left) / area.width;
    const down = clientY === undefined ? 0.5 : (clientY - area.top) / area.height;
    const width = this.box.width / factor;
    const height = this.box.height / factor;
    const scale = area.width / width;
    if (scale > 16 || scale < 0.01) return;
    this.isFit = false;
    this.show({ x: this.box.x + (this.box.width - width) * across, y: this.box.y + (this.box.height - height) * down, width, height });
  }

  /** Moves so that an element is seen. */
  reveal(element) {
    const area = this.canvas.getBoundingClientRect();
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const by = (low, high, least, most) => (low < least ? least - low + 24 : high > most ? most - high - 24 : 0);
    const dx = by(left, right, area.left, area.right);
    const dy = by(top, bottom, area.top, area.bottom);
    if (dx || dy) this.move(dx, dy);
  }

  listen() {
    const { canvas } = this;
    const pointers = new Map();
    let moved = 0;
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), event.clientX, event.clientY);
    }, { passive: false });
    canvas.addEventListener('pointerdown', (event) => {
      pointers.set(event.pointerId, event);
      moved = 0;
    });
    window.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const [dx, dy] = [event.clientX - before.clientX, event.clientY - before.clientY];
      moved += Math.abs(dx) + Math.abs(dy);
      if (moved > 4) canvas.classList.add('moving');
      if (pointers.size === 2) {
        const [other] = [...pointers.values()].filter((one) => one.pointerId !== event.pointerId);
        const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY) || 1;
        this.zoom(apart(event) / apart(before), other.clientX, other.clientY);
      } else if (moved > 4) {
        this.move(dx, dy);
      }
      pointers.set(event.pointerId, event);
    });
    const up = (event) => {
      pointers.delete(event.pointerId);
      canvas.classList.remove('moving');
    };
    window.addEventListener('pointerup', up);
    window.addEventListener('pointercancel', up);
    // A click that ended a drag is none.
    canvas.addEventListener('click', (event) => {
      if (moved > 4) event.stopPropagation();
      moved = 0;
    }, true);
    new ResizeObserver(() => (this.isFit ? this.fit() : this.keepScale())).observe(canvas);
  }

  /** After the window has changed, at the same scale. */
  keepScale() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth && clientHeight) this.show({ ...this.box, height: (this.box.width * clientHeight) / clientWidth });
  }
}
