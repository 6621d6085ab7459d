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
