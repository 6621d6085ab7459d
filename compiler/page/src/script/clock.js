// What moves the chart: single scans and micro-steps, and runs at a speed; a run shows what it came to once a frame.

import { Replay } from './replay.js';

/** Milliseconds of a frame that scans may take; the rest is for drawing. */
const BUDGET = 9;
/** What a pause of the browser, as of a page in the background, counts for at most. */
const LONGEST = 250;

/** The time of a page. `tell` is called with what happened: `changed`, `paused`, `break`, `no-delay`, `replayed`. */
export class Clock {
  constructor(engine, settings, tell) {
    Object.assign(this, { engine, settings, tell });
    this.isRunning = false;
    this.replay = null;
    this.isSlow = false;
    this.stats = { frames: 0, scans: 0, since: 0 };
  }

  get period() {
    return this.settings.get('period');
  }

  /** The time of the next scan. */
  get nextTime() {
    return this.replay?.time ?? this.engine.time + this.period;
  }

  run() {
    if (this.isRunning) return;
    this.isRunning = true;
    this.engine.remember();
    this.target = this.engine.time;
    this.last = null;
    this.stats = { frames: 0, scans: 0, since: performance.now() };
    this.tell('running');
    requestAnimationFrame((now) => this.frame(now));
  }

  pause() {
    if (!this.isRunning) return;
    this.isRunning = false;
    this.tell('paused');
  }

  frame(now) {
    if (!this.isRunning) return;
    const elapsed = this.last === null ? 0 : Math.min(now - this.last, LONGEST);
    this.last = now;
    const speed = this.settings.get('speed');
    const isFree = speed === 'max';
    if (!isFree) this.target += elapsed * Number(speed);
    const end = performance.now() + BUDGET;
    const before = this.engine.scans;
    this.isSlow = false;
    while (this.isRunning && (isFree || this.nextTime <= this.target || this.engine.isBegun)) {
      if (!this.step()) break;
      if (performance.now() > end) {
        this.isSlow = !isFree;
        this.target = Math.max(this.engine.time, this.target - elapsed * Number(speed) || 0);
        break;
      }
    }
    this.stats.frames += 1;
    this.stats.scans += this.engine.scans - before;
    if (!this.isRunning) return;
    this.tell('changed');
    requestAnimationFrame((next) => this.frame(next));
  }

  /** One scan of a run; whether it may go on. */
  step() {
    const { engine } = this;
    if (!engine.isBegun) {
      if (!this.prepare()) return false;
      if (!this.replay && engine.hasWaiting) engine.remember();
    }
    const hit = engine.scan(this.due);
    if (!hit) return true;
    this.isRunning = false;
    this.tell('break', hit);
    return false;
  }

  /** What comes next: its time, and in a replay its inputs; whether there is something. */
  prepare() {
    if (!this.replay) {
      this.due = this.engine.time + this.period;
      return true;
    }
    if (this.replay.time === null) {
      this.replay = null;
      this.isRunning = false;
      this.tell('replayed');
      return false;
    }
    this.due = this.replay.take(this.engine);
    return true;
  }

  /** One scan, by hand. */
  scan() {
    this.byHand(() => this.engine.scan(this.due));
  }

  /** One micro-step, by hand. */
  microStep() {
    this.byHand(() => this.engine.microStep(this.due));
  }

  byHand(move) {
    this.pause();
    this.engine.remember();
    if (!this.engine.isBegun && !this.prepare()) {
      this.engine.undos.pop();
      return;
    }
    const hit = move();
    this.tell(hit ? 'break' : 'changed', hit);
  }

  /** On to where the next delay ends. */
  jump() {
    this.pause();
    if (this.replay) {
      this.scan();
      return;
    }
    const { engine } = this;
    engine.remember();
    let hit = engine.finish();
    const due = hit ? null : engine.nextEnd;
    if (due !== null) hit = engine.scan(due);
    else if (!hit) {
      engine.undos.pop();
      this.tell('no-delay');
      return;
    }
    this.tell(hit ? 'break' : 'changed', hit);
  }

  undo() {
    this.pause();
    this.replay = null;
    this.tell(this.engine.undo() ? 'changed' : 'nothing-to-undo');
  }

  /** Begins anew. */
  reset() {
    this.pause();
    this.replay = null;
    this.engine.remember();
    this.engine.start();
    this.engine.initial();
    this.tell('changed');
  }

  /** Takes a trace from its first row, which is done at once; what follows waits for a run or for single scans. */
  load(trace) {
    this.pause();
    this.engine.remember();
    this.engine.start();
    this.replay = new Replay(trace);
    const t = this.replay.take(this.engine);
    this.engine.initial(t);
    this.tell('changed');
  }

  /** Plays a trace from the start. */
  play(trace) {
    this.load(trace);
    this.run();
  }

  /** A change of an input by hand: what remains of a replay is given up. */
  takeOver() {
    if (this.replay) this.tell('taken-over');
    this.replay = null;
  }
}
