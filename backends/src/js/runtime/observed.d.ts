
    /** What is seen of the last micro-step, and of the situation that it came to; of claims, of the last scan. */
    get observed(): {
        satisfied: CHARTTransition[];
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
