// What was done: a row a scan. Rows that follow each other at one distance and change no input take one entry.

/** The rows of a run. Each entry is `{ t, every, count, changes, restart }`: `count` rows, the first at `t`, which alone has changes. */
export class Trace {
  constructor() {
    this.entries = [];
    this.length = 0;
  }

  /** Adds a row; `changes` are pairs of the place of an input and its value; `restart` says that the controller restarts before. */
  add(t, changes, restart = false) {
    const last = this.entries.at(-1);
    this.length += 1;
    if (last && changes.length === 0 && !restart) {
      const end = last.t + last.every * (last.count - 1);
      if (last.count === 1 || t - end === last.every) {
        if (last.count === 1) last.every = t - last.t;
        last.count += 1;
        return;
      }
    }
    this.entries.push({ t, every: 0, count: 1, changes, restart });
  }

  /** A place to which `cut` goes back. */
  mark() {
    return { entries: this.entries.length, count: this.entries.at(-1)?.count ?? 0, length: this.length };
  }

  /** Forgets what was added after a mark. */
  cut(mark) {
    this.entries.length = mark.entries;
    const last = this.entries.at(-1);
    if (last) {
      last.count = mark.count;
      if (last.count === 1) last.every = 0;
    }
    this.length = mark.length;
  }

  /** Whether the controller restarts in it. */
  get hasRestart() {
    return this.entries.some((entry) => entry.restart);
  }

  /** All rows in order: `{ t, changes, restart }`. */
  *rows() {
    for (const { t, every, count, changes, restart } of this.entries) {
      yield { t, changes, restart };
      for (let row = 1; row < count; row++) yield { t: t + every * row, changes: [], restart: false };
    }
  }

  /** The time of the last row; 0 without one. */
  get end() {
    const last = this.entries.at(-1);
    return last ? last.t + last.every * (last.count - 1) : 0;
  }
}
