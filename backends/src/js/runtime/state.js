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
