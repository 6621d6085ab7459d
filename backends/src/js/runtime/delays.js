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
