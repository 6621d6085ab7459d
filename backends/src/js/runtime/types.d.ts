
/** What has gone wrong. */
export interface CHARTFlags {
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
export interface CHARTMicroStep {
    /** The transitions that were enabled: all steps before them and what encloses them active, and nothing froze them. */
    enabled: CHARTTransition[];
    /** Those of them whose condition was true, so that they cleared. */
    cleared: CHARTTransition[];
    /** Whether the scan is over: nothing changes any more, or LIVELOCK has ended it. */
    stable: boolean;
}

/** What was saved: plain data, which JSON can carry. */
export interface CHARTSaved {
    readonly chart: string;
    readonly program: string;
    readonly state: object;
    readonly seal: number;
}

export declare class CHART {
    /** The labels of all steps, in order of declaration. */
    static readonly steps: readonly CHARTStep[];

    /** The chart before its first scan. */
    constructor();

    /**
     * One scan with the inputs that are given, those that are left out as they were, at a time in milliseconds, on a clock
     * that wraps around at 2^32. A scan that was begun by micro-steps goes on to its end, with the inputs and the time of
     * its beginning.
     */
    scan(inputs: Partial<CHARTInputs>, now_ms: number): CHARTOutputs;

    /** One micro-step. Until the scan is over, inputs and time stay as they were, and outputs stay published. */
    microStep(inputs: Partial<CHARTInputs>, now_ms: number): CHARTMicroStep;

    /** The outputs of the last scan, always the same object. */
    get outputs(): CHARTOutputs;

    /** The labels of the active steps, in order of declaration. */
    get situation(): CHARTStep[];

    /** What has gone wrong since the start, or since the flags were cleared. */
    get flags(): CHARTFlags;

    /** Lowers all flags. */
    clearFlags(): void;

    /** Back to the state before the first scan, all inputs as they were declared. */
    reset(): void;
    // restart

    /** All memory. */
    save(): CHARTSaved;

    /**
     * Goes on with what was saved, with the outputs of that situation; the time in between does not count for delays.
     * Throws an error, and changes nothing, if it was saved by another program, or is not as it was saved.
     */
    restore(data: CHARTSaved, now_ms: number): void;
    // observed
}

export default CHART;
