// Weigh_mix_b5: weighing and mixing, modes by forcing orders, IEC 60848 annex B.5
//
// from weigh_mix_b5.gct
// A call takes at most 9 micro-steps, 922 statements.

/** The inputs of the chart. */
export interface Weigh_mix_b5Inputs {
    /** cycle start */
    CS: boolean;
    /** brick passes the detector */
    TD: boolean;
    /** weight of A reached */
    a: boolean;
    /** weight of A + B reached */
    b: boolean;
    /** weighing unit empty */
    z: boolean;
    /** mixer up */
    S0: boolean;
    /** mixer down */
    S1: boolean;
    /** emergency stop button pressed */
    PBES: boolean;
    /** selector on automatic */
    SSAuto: boolean;
    /** selector on manual */
    SSManu: boolean;
}

/** The outputs of the chart. */
export interface Weigh_mix_b5Outputs {
    /** valve of product A */
    VA: boolean;
    /** valve of product B */
    VB: boolean;
    /** valve of the weighing unit */
    VC: boolean;
    /** belt motor */
    BM: boolean;
    /** mixer rotation */
    MR: boolean;
    /** tip the mixer */
    TM_down: boolean;
    /** bring the mixer back */
    TM_up: boolean;
    /** manual control enabled */
    EMC: boolean;
}

/** The label of a step. */
export type Weigh_mix_b5Step =
    | "D1"
    | "A6"
    | "F1"
    | "1"
    | "2"
    | "3"
    | "4"
    | "5"
    | "6"
    | "7"
    | "8"
    | "9"
    | "10"
    | "11";

/** The designation of a transition, or `#` and its number in order of declaration. */
export type Weigh_mix_b5Transition =
    | "#1"
    | "#2"
    | "#3"
    | "#4"
    | "#5"
    | "1"
    | "2"
    | "3"
    | "4"
    | "5"
    | "6"
    | "7"
    | "8"
    | "9"
    | "10";

/** What has gone wrong. */
export interface Weigh_mix_b5Flags {
    /** No stable situation was found within the bound on micro-steps. */
    livelock: boolean;
    /** Two stored actions gave one variable different values in one micro-step. */
    alloc_conflict: boolean;
    /** Two orders of one grafcet asked for different situations. */
    force_conflict: boolean;
    /** Something was divided by zero. */
    div0: boolean;
}

/** What is seen of a micro-step. */
export interface Weigh_mix_b5MicroStep {
    /** The transitions that were enabled: all steps before them and what encloses them active, and nothing froze them. */
    enabled: Weigh_mix_b5Transition[];
    /** Those of them whose condition was true, so that they cleared. */
    cleared: Weigh_mix_b5Transition[];
    /** Whether the scan is over: nothing changes any more, or LIVELOCK has ended it. */
    stable: boolean;
}

/** What was saved: plain data, which JSON can carry. */
export interface Weigh_mix_b5Saved {
    readonly chart: string;
    readonly program: string;
    readonly state: object;
    readonly seal: number;
}

export declare class Weigh_mix_b5 {
    /** The labels of all steps, in order of declaration. */
    static readonly steps: readonly Weigh_mix_b5Step[];

    /** The chart before its first scan. */
    constructor();

    /**
     * One scan with the inputs that are given, those that are left out as they were, at a time in milliseconds, on a clock
     * that wraps around at 2^32. A scan that was begun by micro-steps goes on to its end, with the inputs and the time of
     * its beginning.
     */
    scan(inputs: Partial<Weigh_mix_b5Inputs>, now_ms: number): Weigh_mix_b5Outputs;

    /** One micro-step. Until the scan is over, inputs and time stay as they were, and outputs stay published. */
    microStep(inputs: Partial<Weigh_mix_b5Inputs>, now_ms: number): Weigh_mix_b5MicroStep;

    /** The outputs of the last scan, always the same object. */
    get outputs(): Weigh_mix_b5Outputs;

    /** The labels of the active steps, in order of declaration. */
    get situation(): Weigh_mix_b5Step[];

    /** What has gone wrong since the start, or since the flags were cleared. */
    get flags(): Weigh_mix_b5Flags;

    /** Lowers all flags. */
    clearFlags(): void;

    /** Back to the state before the first scan, all inputs as they were declared. */
    reset(): void;

    /** All memory. */
    save(): Weigh_mix_b5Saved;

    /**
     * Goes on with what was saved, with the outputs of that situation; the time in between does not count for delays.
     * Throws an error, and changes nothing, if it was saved by another program, or is not as it was saved.
     */
    restore(data: Weigh_mix_b5Saved, now_ms: number): void;

    /** What is seen of the last micro-step, and of the situation that it came to; of claims, of the last scan. */
    get observed(): {
        satisfied: Weigh_mix_b5Transition[];
        frozen: string[];
        forced: string[];
        actions: number[];
        orders: number[];
        broken: number[];
        reached: number[];
    };

    /** Constants and internal variables. */
    get variables(): Record<string, boolean | number>;

    /** The delays: which there are, what is left of them, and whether they run. */
    get delays(): { of: string; owner: string; text: string; total: number; left: number; running: boolean }[];
}

export default Weigh_mix_b5;
