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
