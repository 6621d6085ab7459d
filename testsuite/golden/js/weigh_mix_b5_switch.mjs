// Weigh_mix_b5: weighing and mixing, modes by forcing orders, IEC 60848 annex B.5
//
// from weigh_mix_b5.gct
// A call takes at most 9 micro-steps, 606 statements.

const constants = {
    mix_time: 8000,  // in milliseconds
};

const INPUTS = {
    CS: "bool",
    TD: "bool",
    a: "bool",
    b: "bool",
    z: "bool",
    S0: "bool",
    S1: "bool",
    PBES: "bool",
    SSAuto: "bool",
    SSManu: "bool",
};
// the transitions: their designations, or their numbers in order of declaration
const TRANSITIONS = [
    "#1", "#2", "#3", "#4", "#5", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10",
];
// the words by which the code calls them
const WORDS = [
    "t_D1_A6", "t_A6_D1", "t_A6_F1", "t_F1_A6", "t_F1_D1", "t_1", "t_2", "t_3", "t_4", "t_5", "t_6",
    "t_7", "t_8", "t_9", "t_10",
];

// all that the chart keeps, as before its first scan
function fresh() {
    return {
        // given for each scan
        inputs: {
            CS: false,  // cycle start
            TD: false,  // brick passes the detector
            a: false,  // weight of A reached
            b: false,  // weight of A + B reached
            z: false,  // weighing unit empty
            S0: false,  // mixer up
            S1: false,  // mixer down
            PBES: false,  // emergency stop button pressed
            SSAuto: false,  // selector on automatic
            SSManu: false,  // selector on manual
        },
        // given to the plant after each scan
        outputs: {
            VA: false,  // valve of product A
            VB: false,  // valve of product B
            VC: false,  // valve of the weighing unit
            BM: false,  // belt motor
            MR: false,  // mixer rotation
            TM_down: false,  // tip the mixer
            TM_up: false,  // bring the mixer back
            EMC: false,  // manual control enabled
        },
        variables: {},
        flags: { livelock: false, alloc_conflict: false, force_conflict: false, div0: false },
        // active steps, and memory from scan to scan
        m: {
            at_G1: 0,
            at_G10: 0,
            at_G10_6: 0,
            old_TD: false,
            started: false,  // false until the first call
        },
        delays: {
            on_X9: delay(),
        },
        // what is seen of the last micro-step
        seen: {
            observed: false,
            enabled: {},
            cleared: {},
        },
        // the time of the scan, whether there has been one, and whether one is under way
        now: 0,
        begun: false,
        scanning: false,
    };
}

// what is done once a scan, before its micro-steps
function begin({ inputs, m }) {
    if (!m.started) {
        m.started = true;
        m.at_G1 = 1;
        m.old_TD = inputs.TD;
    }
}

// a micro-step; whether another is needed
function microStep({ inputs, m, delays, seen, now }) {
    let next_G1, next_G10, next_G10_6, again, frozen_G10;

    // conditions
    const rise_TD = inputs.TD && !m.old_TD;
    run(delays.on_X9, m.at_G10 === 9, now);
    if (seen.observed) {
        // what is seen of transitions
        frozen_G10 = m.at_G1 === 1 || m.at_G1 === 2;
        seen.enabled.t_D1_A6 = m.at_G1 === 1;                 // D1 -> A6
        seen.cleared.t_D1_A6 = seen.enabled.t_D1_A6 && !inputs.PBES;
        seen.enabled.t_A6_D1 = m.at_G1 === 2;                 // A6 -> D1
        seen.cleared.t_A6_D1 = seen.enabled.t_A6_D1 && inputs.PBES;
        seen.enabled.t_A6_F1 = m.at_G1 === 2;                 // A6 -> F1
        seen.cleared.t_A6_F1 =
            seen.enabled.t_A6_F1 && inputs.SSAuto && !inputs.SSManu && !inputs.PBES;
        seen.enabled.t_F1_A6 = m.at_G1 === 3;                 // F1 -> A6
        seen.cleared.t_F1_A6 = seen.enabled.t_F1_A6 && inputs.SSManu && !inputs.PBES;
        seen.enabled.t_F1_D1 = m.at_G1 === 3;                 // F1 -> D1
        seen.cleared.t_F1_D1 = seen.enabled.t_F1_D1 && inputs.PBES;
        seen.enabled.t_1 = m.at_G10 === 1 && !frozen_G10;     // 1 -> 2, 6
        seen.cleared.t_1 = seen.enabled.t_1 && inputs.CS && inputs.z && inputs.S0;
        seen.enabled.t_2 = m.at_G10 === 2 && !frozen_G10;     // 2 -> 3
        seen.cleared.t_2 = seen.enabled.t_2 && inputs.a;
        seen.enabled.t_3 = m.at_G10 === 3 && !frozen_G10;     // 3 -> 4
        seen.cleared.t_3 = seen.enabled.t_3 && inputs.b;
        seen.enabled.t_4 = m.at_G10 === 4 && !frozen_G10;     // 4 -> 5
        seen.cleared.t_4 = seen.enabled.t_4 && inputs.z;
        seen.enabled.t_5 = m.at_G10_6 === 6 && !frozen_G10;   // 6 -> 7
        seen.cleared.t_5 = seen.enabled.t_5 && rise_TD;
        seen.enabled.t_6 = m.at_G10_6 === 7 && !frozen_G10;   // 7 -> 8
        seen.cleared.t_6 = seen.enabled.t_6 && rise_TD;
        seen.enabled.t_7 = m.at_G10 === 5 && m.at_G10_6 === 8 && !frozen_G10;  // 5, 8 -> 9
        seen.cleared.t_7 = seen.enabled.t_7;
        seen.enabled.t_8 = m.at_G10 === 9 && !frozen_G10;     // 9 -> 10
        seen.cleared.t_8 = seen.enabled.t_8 && hasRun(delays.on_X9, constants.mix_time);
        seen.enabled.t_9 = m.at_G10 === 10 && !frozen_G10;    // 10 -> 11
        seen.cleared.t_9 = seen.enabled.t_9 && inputs.S1;
        seen.enabled.t_10 = m.at_G10 === 11 && !frozen_G10;   // 11 -> 1
        seen.cleared.t_10 = seen.enabled.t_10 && inputs.S0;
    }

    // memory of edges
    again = inputs.TD !== m.old_TD;
    m.old_TD = inputs.TD;

    // grafcets that orders freeze
    const frozen_G10_1 = m.at_G1 === 1 || m.at_G1 === 2;

    // transitions in G1: the modes
    next_G1 = m.at_G1;
    if (m.at_G1 === 1 && !inputs.PBES) {
        next_G1 = 2;  // D1 -> A6
    }
    if (m.at_G1 === 2 && inputs.PBES) {
        next_G1 = 1;  // A6 -> D1
    }
    if (m.at_G1 === 2 && inputs.SSAuto && !inputs.SSManu && !inputs.PBES) {
        next_G1 = 3;  // A6 -> F1
    }
    if (m.at_G1 === 3 && inputs.SSManu && !inputs.PBES) {
        next_G1 = 2;  // F1 -> A6
    }
    if (m.at_G1 === 3 && inputs.PBES) {
        next_G1 = 1;  // F1 -> D1
    }

    // transitions in G10: the cycle
    next_G10 = m.at_G10;
    next_G10_6 = m.at_G10_6;
    switch (m.at_G10) {
        case 1:  // step 1: ready
            if (!frozen_G10_1 && inputs.CS && inputs.z && inputs.S0) {
                next_G10 = 2;     // 1 -> 2, 6
                next_G10_6 = 6;
            }
            break;
        case 2:  // step 2: weigh A
            if (!frozen_G10_1 && inputs.a) {
                next_G10 = 3;     // 2 -> 3
            }
            break;
        case 3:  // step 3: weigh B
            if (!frozen_G10_1 && inputs.b) {
                next_G10 = 4;     // 3 -> 4
            }
            break;
        case 4:  // step 4: empty the weighing unit into the mixer
            if (!frozen_G10_1 && inputs.z) {
                next_G10 = 5;     // 4 -> 5
            }
            break;
        case 5:  // step 5: powder is in
            if (m.at_G10_6 === 8 && !frozen_G10_1) {
                next_G10 = 9;     // 5, 8 -> 9
                next_G10_6 = 0;
            }
            break;
        case 9:  // step 9: mix
            if (!frozen_G10_1 && hasRun(delays.on_X9, constants.mix_time)) {
                next_G10 = 10;    // 9 -> 10
            }
            break;
        case 10:  // step 10: tip, still turning
            if (!frozen_G10_1 && inputs.S1) {
                next_G10 = 11;    // 10 -> 11
            }
            break;
        case 11:  // step 11: come back up
            if (!frozen_G10_1 && inputs.S0) {
                next_G10 = 1;     // 11 -> 1
            }
            break;
    }
    if (m.at_G10_6 === 6 && !frozen_G10_1 && rise_TD) {
        next_G10_6 = 7;   // 6 -> 7
    }
    if (m.at_G10_6 === 7 && !frozen_G10_1 && rise_TD) {
        next_G10_6 = 8;   // 7 -> 8
    }

    // enclosures and orders
    if (next_G1 === 1) {
        next_G10 = 0;
    } else if (next_G1 === 2) {
        next_G10 = 1;
    }
    if (next_G1 === 1 || next_G1 === 2) {
        next_G10_6 = 0;
    }
    again = again || next_G1 !== m.at_G1 || next_G10 !== m.at_G10 || next_G10_6 !== m.at_G10_6;

    // situation in G1: the modes
    m.at_G1 = next_G1;

    // situation in G10: the cycle
    m.at_G10 = next_G10;
    m.at_G10_6 = next_G10_6;

    return again;
}

// what is done once a scan, after its micro-steps
function end({ outputs, m }) {
    // outputs in G1: the modes
    outputs.EMC = m.at_G1 === 2;  // A6

    // outputs in G10: the cycle
    outputs.VA = m.at_G10 === 2;                          // 2
    outputs.VB = m.at_G10 === 3;                          // 3
    outputs.VC = m.at_G10 === 4;                          // 4
    outputs.BM = m.at_G10_6 === 6 || m.at_G10_6 === 7;    // 6, 7
    outputs.MR = m.at_G10 === 9 || m.at_G10 === 10;       // 9, 10
    outputs.TM_down = m.at_G10 === 10;                    // 10
    outputs.TM_up = m.at_G10 === 11;                      // 11
}

// what follows from memory that has been given back
function restoring({ outputs, m }) {
    if (m.started) {
        // outputs
        outputs.VA = m.at_G10 === 2;                          // 2
        outputs.VB = m.at_G10 === 3;                          // 3
        outputs.VC = m.at_G10 === 4;                          // 4
        outputs.BM = m.at_G10_6 === 6 || m.at_G10_6 === 7;    // 6, 7
        outputs.MR = m.at_G10 === 9 || m.at_G10 === 10;       // 9, 10
        outputs.TM_down = m.at_G10 === 10;                    // 10
        outputs.TM_up = m.at_G10 === 11;                      // 11
        outputs.EMC = m.at_G1 === 2;                          // A6
    }
}

// the labels of the active steps
function situation({ m }) {
    const active = [];
    if (m.at_G1 === 1) active.push("D1");
    if (m.at_G1 === 2) active.push("A6");
    if (m.at_G1 === 3) active.push("F1");
    if (m.at_G10 === 1) active.push("1");
    if (m.at_G10 === 2) active.push("2");
    if (m.at_G10 === 3) active.push("3");
    if (m.at_G10 === 4) active.push("4");
    if (m.at_G10 === 5) active.push("5");
    if (m.at_G10_6 === 6) active.push("6");
    if (m.at_G10_6 === 7) active.push("7");
    if (m.at_G10_6 === 8) active.push("8");
    if (m.at_G10 === 9) active.push("9");
    if (m.at_G10 === 10) active.push("10");
    if (m.at_G10 === 11) active.push("11");
    return active;
}

// a delay that does not run; times are in milliseconds
function delay() {
    return { running: false, elapsed: 0, last: 0 };
}

// brings a delay up to date with what it delays
function run(delay, input, now) {
    if (!input) {
        delay.elapsed = 0;
    } else if (delay.running) {
        // Right across the end of the clock's range; more than half of that is a clock that was put back.
        const passed = (now - delay.last) >>> 0;
        if (passed <= 0x80000000) {
            delay.elapsed += passed;
        }
        delay.last = now;
    } else {
        delay.elapsed = 0;
        delay.last = now;
    }
    delay.running = input;
}

// whether the time is over: it is from the very instant on
function hasRun(delay, preset) {
    return delay.running && delay.elapsed >= preset;
}

const RANGES = {
    int: [-32768, 32767],
    dint: [-2147483648, 2147483647],
    uint: [0, 65535],
    udint: [0, 4294967295],
    time: [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER],
};

// what is given, as it is kept; nothing has changed if something of it is refused
function accepted(given) {
    const values = [];
    for (const name of Object.keys(given ?? {})) {
        const value = given[name];
        const type = Object.hasOwn(INPUTS, name) ? INPUTS[name] : undefined;
        if (type === undefined) {
            throw new TypeError(`${CHART} has no input ${JSON.stringify(name)}`);
        }
        if (value === undefined) {
            continue;
        }
        if (typeof value !== (type === "bool" ? "boolean" : "number")) {
            throw new TypeError(`input ${JSON.stringify(name)} is of type ${type}, which ${String(value)} is not`);
        }
        const range = RANGES[type];
        if (range && !(Number.isInteger(value) && value >= range[0] && value <= range[1])) {
            throw new RangeError(`input ${JSON.stringify(name)} takes whole numbers of type ${type}, not ${value}`);
        }
        values.push([name, kept(type, value)]);
    }
    return values;
}

function kept(type, value) {
    switch (type) {
        case "real":
            return Math.fround(value);
        case "time":
            return BigInt(value);
        case "bool":
        case "lreal":
            return value;
        default:
            return value + 0; // no whole number is -0
    }
}

// milliseconds on a clock that wraps around at 2^32
function clock(now_ms) {
    if (typeof now_ms !== "number" || !Number.isFinite(now_ms)) {
        throw new TypeError(`the time is a number of milliseconds, which ${String(now_ms)} is not`);
    }
    return Math.floor(now_ms) >>> 0;
}

// sets a property, whatever it is called
function put(object, name, value) {
    if (Object.hasOwn(object, name)) {
        object[name] = value;
    } else {
        Object.defineProperty(object, name, { value, writable: true, enumerable: true, configurable: true });
    }
}

// values as they are seen from outside: a time is a number of milliseconds
function shown(values, into = {}) {
    for (const name of Object.keys(values)) {
        const value = values[name];
        put(into, name, typeof value === "bigint" ? Number(value) : value);
    }
    return into;
}

// which program saved data belong to: another chart, or encoding, has another
const PROGRAM = "e71502b8d318f3ad";
const CHART = "Weigh_mix_b5";
// what follows from the rest of the memory
const FOLLOWING = new Set([
    "outputs.VA", "outputs.VB", "outputs.VC", "outputs.BM", "outputs.MR", "outputs.TM_down",
    "outputs.TM_up", "outputs.EMC",
]);

const KEPT = ["inputs", "outputs", "variables", "flags", "m"];

// the values of a group that do not follow from others
function names(s, group) {
    return Object.keys(s[group]).filter((name) => !FOLLOWING.has(`${group}.${name}`));
}

// a value that JSON can carry
function plain(value) {
    if (typeof value === "bigint") {
        return String(value);
    }
    if (typeof value === "number" && (!Number.isFinite(value) || Object.is(value, -0))) {
        return Object.is(value, -0) ? "-0" : String(value);
    }
    return value;
}

// the value that was made plain, of the type of another
function full(value, like) {
    switch (typeof like) {
        case "bigint":
            return BigInt(value);
        case "number":
            return Number(value);
        default:
            return value;
    }
}

// all that has to be saved: values and delays, and the outputs that are published while a scan goes on
function saved(s, published) {
    const state = { begun: s.begun, scanning: s.scanning, delays: {} };
    for (const group of KEPT) {
        state[group] = {};
        for (const name of names(s, group)) {
            put(state[group], name, plain(s[group][name]));
        }
    }
    for (const name of Object.keys(s.delays)) {
        put(state.delays, name, [s.delays[name].running, s.delays[name].elapsed]);
    }
    if (s.scanning) {
        state.published = {};
        for (const name of Object.keys(published)) {
            put(state.published, name, plain(published[name]));
        }
    }
    return { chart: CHART, program: PROGRAM, state, seal: seal(state) };
}

// a number that a change of any value changes, in the order of this program whatever the order of what was saved
function seal(state) {
    const like = fresh();
    const values = [state.begun, state.scanning];
    for (const group of [...KEPT, "delays"]) {
        for (const name of names(like, group)) {
            values.push(Object.hasOwn(state[group], name) ? state[group][name] : null);
        }
    }
    for (const name of state.scanning ? Object.keys(like.outputs) : []) {
        values.push(Object.hasOwn(state.published, name) ? state.published[name] : null);
    }
    let print = 0x811c9dc5;
    for (const unit of JSON.stringify(values)) {
        print = Math.imul(print ^ unit.codePointAt(0), 0x01000193);
    }
    return print >>> 0;
}

// what was saved, to go on with at a time; an error if it is not of this program, or not as it was saved
function restored(data, now) {
    const refuse = (why) => new Error(`${CHART} cannot be restored: ${why}`);
    if (typeof data !== "object" || data === null) {
        throw refuse("these are no saved data");
    }
    if (data.chart !== CHART || data.program !== PROGRAM) {
        throw refuse("these are data of another program");
    }
    let sealed = false;
    try {
        sealed = seal(data.state) === data.seal;
    } catch {
        // Something is not there, or is no object.
    }
    if (!sealed) {
        throw refuse("these data are not as they were saved");
    }
    const { state } = data;
    const s = fresh();
    for (const group of KEPT) {
        for (const name of names(s, group)) {
            put(s[group], name, full(state[group][name], s[group][name]));
        }
    }
    for (const name of Object.keys(s.delays)) {
        const [running, elapsed] = state.delays[name];
        s.delays[name] = { running, elapsed, last: now };
    }
    if (state.begun) {
        // What is computed for this raises no flag.
        const flags = { ...s.flags };
        restoring(s);
        s.flags = flags;
    }
    s.now = now;
    s.begun = state.begun;
    s.scanning = state.scanning;
    return s;
}

// weighing and mixing, modes by forcing orders, IEC 60848 annex B.5
export class Weigh_mix_b5 {
    // the labels of all steps, in order of declaration
    static steps = Object.freeze([
        "D1", "A6", "F1", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11",
    ]);

    // what the chart keeps, and its outputs as they are published
    #s = fresh();
    #shown = shown(this.#s.outputs);

    // one scan at a time in milliseconds, on a clock that wraps around at 2^32, with the inputs that have changed; the outputs.
    // A scan that was begun by micro-steps goes on to its end, with the inputs and the time of its beginning.
    scan(inputs, now_ms) {
        this.#begin(inputs, now_ms);
        while (microStep(this.#s)) {}
        this.#end();
        return this.#shown;
    }

    #begin(inputs, now_ms) {
        const s = this.#s;
        if (s.scanning) {
            return;
        }
        const values = accepted(inputs);
        s.now = clock(now_ms);
        for (const [name, value] of values) {
            s.inputs[name] = value;
        }
        s.begun = true;
        s.scanning = true;
        begin(s);
    }

    #end() {
        end(this.#s);
        this.#s.scanning = false;
        shown(this.#s.outputs, this.#shown);
    }

    // one micro-step, the first of a scan after the initial reaction if that is due: the
    // transitions that were
    // enabled, those that cleared, and whether the scan is over; until it is, inputs and time
    // stay as they were
    microStep(inputs, now_ms) {
        const s = this.#s;
        this.#begin(inputs, now_ms);
        s.seen.observed = true;
        const stable = !microStep(s);
        s.seen.observed = false;
        if (stable) {
            this.#end();
        }
        const of = (words = {}) => TRANSITIONS.filter((_, t) => words[WORDS[t]]);
        return { enabled: of(s.seen.enabled), cleared: of(s.seen.cleared), stable };
    }

    // lowers all flags
    clearFlags() {
        this.#s.flags = fresh().flags;
    }

    // the outputs of the last scan
    get outputs() {
        return this.#shown;
    }

    // the labels of the active steps, in order of declaration; none is before the first scan
    get situation() {
        return this.#s.begun ? situation(this.#s) : [];
    }

    // what has gone wrong since the start, or since the flags were cleared
    get flags() {
        return { ...this.#s.flags };
    }

    // back to the state before the first scan, all inputs as they were declared
    reset() {
        this.#s = fresh();
        shown(this.#s.outputs, this.#shown);
    }

    // all memory as plain data, which JSON can carry
    save() {
        return saved(this.#s, this.#shown);
    }

    // goes on with what was saved, with the outputs of that situation; the time in between does not count for delays
    restore(data, now_ms) {
        const s = restored(data, clock(now_ms));
        if (s.scanning) {
            for (const name of Object.keys(s.outputs)) {
                put(this.#shown, name, full(data.state.published[name], this.#shown[name]));
            }
        } else {
            shown(s.outputs, this.#shown);
        }
        this.#s = s;
    }
}

export default Weigh_mix_b5;
