// A trace that is played again, row by row.

/** The rows that are still to come. */
export class Replay {
  constructor(trace) {
    this.rows = trace.rows();
    this.next = this.rows.next();
  }

  /** The time of the next row; null after the last. */
  get time() {
    return this.next.done ? null : this.next.value.t;
  }

  /** Gives the next row's inputs to an engine, and says its time. */
  take(engine) {
    const { t, changes, restart } = this.next.value;
    engine.isRestarting = restart;
    for (const [place, value] of changes) engine.set(place, value);
    this.next = this.rows.next();
    return t;
  }
}
