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
