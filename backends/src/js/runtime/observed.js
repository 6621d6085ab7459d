// what is seen of the last micro-step, and of the situation that it came to; of claims, of the last scan
get observed() {
    const { seen } = this.#s;
    const of = (names, list = []) => names.filter((_, k) => list[k]);
    return {
        satisfied: TRANSITIONS.filter((_, t) => seen.satisfied?.[WORDS[t]]),
        frozen: of(FROZEN, seen.frozen),
        forced: of(FORCED, seen.forced),
        actions: of(ACTIONS, seen.actions),
        orders: of(ORDERS, seen.orders),
        broken: of(ASSERTED, seen.asserted?.map((holds) => !holds)),
        reached: of(WANTED, seen.wanted),
    };
}

// constants and internal variables
get variables() {
    return shown(this.#s.variables, { ...constants });
}

// the delays: which there are, what is left of them, and whether they run
get delays() {
    const s = this.#s;
    return DELAYS.map(({ of, owner, text, total, delay, held }) => {
        const { running, elapsed } = s.delays[delay];
        const left = running ? Math.max(total - elapsed, 0) : total;
        return { of, owner, text, total, left, running: running && left > 0 && (held === undefined || s.m[held]) };
    });
}
