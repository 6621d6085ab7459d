//! Weigh_mix_b4: weighing and mixing with macro-steps, IEC 60848 annex B.4
//!
//! from weigh_mix_b4.gct
//! A call takes at most 9 micro-steps, 161 statements.

#![forbid(unsafe_code)]
#![allow(dead_code, reason = "a program need not use all of it")]
#![allow(
    clippy::collapsible_if,
    clippy::collapsible_match,
    clippy::let_and_return,
    reason = "an arm for each step, an `if` for each transition, a name for each value"
)]
#![allow(
    unused_comparisons,
    clippy::absurd_extreme_comparisons,
    clippy::eq_op,
    clippy::if_same_then_else,
    clippy::manual_range_contains,
    clippy::neg_cmp_op_on_partial_ord,
    clippy::nonminimal_bool,
    clippy::overly_complex_bool_expr,
    reason = "conditions are those of the chart"
)]

use self::runtime::{Flags, Restorer, Saver, Timer, seal};

/// `mix_time`, in milliseconds
pub const MIX_TIME: i64 = 8000;

/// What is read from the plant for a scan.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// `CS`: cycle start
    pub cs: bool,
    /// `TD`: brick passes the detector
    pub td: bool,
    /// weight of A reached
    pub a: bool,
    /// weight of A + B reached
    pub b: bool,
    /// weighing unit empty
    pub z: bool,
    /// `S0`: mixer up
    pub s0: bool,
    /// `S1`: mixer down
    pub s1: bool,
}

/// What a scan gives to the plant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outputs {
    /// `VA`: valve of product A
    pub va: bool,
    /// `VB`: valve of product B
    pub vb: bool,
    /// `VC`: valve of the weighing unit
    pub vc: bool,
    /// `BM`: belt motor
    pub bm: bool,
    /// `MR`: mixer rotation
    pub mr: bool,
    /// `TM_down`: tip the mixer
    pub tm_down: bool,
    /// `TM_up`: bring the mixer back
    pub tm_up: bool,
    /// `BUSY`: lamp: the mixer is being filled
    pub busy: bool,
}

/// The steps of the chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// step 1: ready
    X1,
    /// step 4: mix
    X4,
    /// step 5: tip, still turning
    X5,
    /// step 6: come back up
    X6,
    /// step E2: weigh A
    E2,
    /// step 20: weigh B
    X20,
    /// step 21: empty the weighing unit into the mixer
    X21,
    /// step S2: powder is in
    S2,
    /// step E3: first brick
    E3,
    /// step 30: second brick
    X30,
    /// step S3: bricks are in
    S3,
    /// step 9
    X9,
}

impl Step {
    /// All steps, in order of declaration.
    pub const ALL: [Self; 12] = [
        Self::X1,
        Self::X4,
        Self::X5,
        Self::X6,
        Self::E2,
        Self::X20,
        Self::X21,
        Self::S2,
        Self::E3,
        Self::X30,
        Self::S3,
        Self::X9,
    ];

    const LABELS: [&'static str; 12] = [
        "1", "4", "5", "6", "E2", "20", "21", "S2", "E3", "30", "S3", "9",
    ];

    /// The label in the chart.
    pub const fn label(self) -> &'static str {
        Self::LABELS[self as usize]
    }
}

/// Which of these steps is active.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum AtG1 {
    /// step 1: ready
    X1,
    /// step 4: mix
    X4,
    /// step 5: tip, still turning
    X5,
    /// step 6: come back up
    X6,
    /// step E2: weigh A
    E2,
    /// step 20: weigh B
    X20,
    /// step 21: empty the weighing unit into the mixer
    X21,
    /// step S2: powder is in
    S2,
}

impl AtG1 {
    const ALL: [Self; 8] = [
        Self::X1,
        Self::X4,
        Self::X5,
        Self::X6,
        Self::E2,
        Self::X20,
        Self::X21,
        Self::S2,
    ];
}

/// Which of these steps is active.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum AtG1E3 {
    /// none of them
    None,
    /// step E3: first brick
    E3,
    /// step 30: second brick
    X30,
    /// step S3: bricks are in
    S3,
}

impl AtG1E3 {
    const ALL: [Self; 4] = [Self::None, Self::E3, Self::X30, Self::S3];
}

/// weighing and mixing with macro-steps, IEC 60848 annex B.4
///
/// Its state between two scans; see [`Self::scan`].
#[derive(Clone, Debug)]
pub struct WeighMixB4 {
    // which step is active
    at_g1: AtG1,
    at_g1_e3: AtG1E3,
    // steps
    x9: bool,
    // memory from scan to scan
    old_td: bool,
    /// false until the first call
    started: bool,
    // delays
    on_x4: Timer,
    // what can be seen from outside
    outputs: Outputs,
    flags: Flags,
}

impl Default for WeighMixB4 {
    fn default() -> Self {
        Self::new()
    }
}

impl WeighMixB4 {
    /// The chart before its first scan.
    pub const fn new() -> Self {
        Self {
            at_g1: AtG1::X1,
            at_g1_e3: AtG1E3::None,
            x9: false,
            old_td: false,
            started: false,
            on_x4: Timer::new(),
            outputs: Outputs {
                va: false,
                vb: false,
                vc: false,
                bm: false,
                mr: false,
                tm_down: false,
                tm_up: false,
                busy: false,
            },
            flags: Flags {
                livelock: false,
                alloc_conflict: false,
                force_conflict: false,
                div0: false,
            },
        }
    }

    /// One scan: from the inputs to the outputs.
    ///
    /// `now` is the time in milliseconds of a clock that may start anywhere and wraps around after
    /// `u32::MAX`. There must be a scan at least every 24 days: a difference of more than half the
    /// range is a clock that was put back, and counts as no time.
    pub fn scan(&mut self, inputs: &Inputs, now: u32) -> &Outputs {
        if !self.started {
            self.started = true;
            self.x9 = true;
            self.at_g1 = AtG1::X1;
            self.old_td = inputs.td;
        }

        while self.micro_step(inputs, now) {}

        // outputs in G2: the lamp
        let xm2 = self.at_g1 == AtG1::E2
            || self.at_g1 == AtG1::X20
            || self.at_g1 == AtG1::X21
            || self.at_g1 == AtG1::S2;
        let xm3 = self.at_g1_e3 == AtG1E3::E3
            || self.at_g1_e3 == AtG1E3::X30
            || self.at_g1_e3 == AtG1E3::S3;
        self.outputs.busy = self.x9 && (xm2 || xm3);

        &self.outputs
    }

    // one micro-step; true if another is needed
    #[inline(never)]
    fn micro_step(&mut self, inputs: &Inputs, now: u32) -> bool {
        // conditions
        self.on_x4.call(self.at_g1 == AtG1::X4, now);
        let rise_td = inputs.td && !self.old_td;

        // memory of edges
        let mut again = inputs.td != self.old_td;
        self.old_td = inputs.td;

        // transitions in G1: the cycle
        let was_at_g1_e3 = self.at_g1_e3;
        match self.at_g1 {
            // step 1: ready
            AtG1::X1 => {
                if inputs.cs && inputs.z && inputs.s0 {
                    // 1 -> E2, E3
                    self.at_g1 = AtG1::E2;
                    self.at_g1_e3 = AtG1E3::E3;
                    self.outputs.va = true;
                    self.outputs.bm = true;
                    again = true;
                }
            }
            // step 4: mix
            AtG1::X4 => {
                if self.on_x4.has_run(MIX_TIME) {
                    // 4 -> 5
                    self.at_g1 = AtG1::X5;
                    self.outputs.tm_down = true;
                    again = true;
                }
            }
            // step 5: tip, still turning
            AtG1::X5 => {
                if inputs.s1 {
                    // 5 -> 6
                    self.at_g1 = AtG1::X6;
                    self.outputs.mr = false;
                    self.outputs.tm_down = false;
                    self.outputs.tm_up = true;
                    again = true;
                }
            }
            // step 6: come back up
            AtG1::X6 => {
                if inputs.s0 {
                    // 6 -> 1
                    self.at_g1 = AtG1::X1;
                    self.outputs.tm_up = false;
                    again = true;
                }
            }
            // step E2: weigh A
            AtG1::E2 => {
                if inputs.a {
                    // E2 -> 20
                    self.at_g1 = AtG1::X20;
                    self.outputs.va = false;
                    self.outputs.vb = true;
                    again = true;
                }
            }
            // step 20: weigh B
            AtG1::X20 => {
                if inputs.b {
                    // 20 -> 21
                    self.at_g1 = AtG1::X21;
                    self.outputs.vb = false;
                    self.outputs.vc = true;
                    again = true;
                }
            }
            // step 21: empty the weighing unit into the mixer
            AtG1::X21 => {
                if inputs.z {
                    // 21 -> S2
                    self.at_g1 = AtG1::S2;
                    self.outputs.vc = false;
                    again = true;
                }
            }
            // step S2: powder is in
            AtG1::S2 => {
                if self.at_g1_e3 == AtG1E3::S3 {
                    // S2, S3 -> 4
                    self.at_g1 = AtG1::X4;
                    self.at_g1_e3 = AtG1E3::None;
                    self.outputs.mr = true;
                    again = true;
                }
            }
        }
        match was_at_g1_e3 {
            // step E3: first brick
            AtG1E3::E3 => {
                if rise_td {
                    // E3 -> 30
                    self.at_g1_e3 = AtG1E3::X30;
                    again = true;
                }
            }
            // step 30: second brick
            AtG1E3::X30 => {
                if rise_td {
                    // 30 -> S3
                    self.at_g1_e3 = AtG1E3::S3;
                    self.outputs.bm = false;
                    again = true;
                }
            }
            _ => {}
        }

        again
    }

    // what follows from the memory that has been restored
    fn restore_outputs(&mut self) {
        if self.started {
            // outputs
            self.outputs.va = self.at_g1 == AtG1::E2;
            self.outputs.vb = self.at_g1 == AtG1::X20;
            self.outputs.vc = self.at_g1 == AtG1::X21;
            self.outputs.bm = self.at_g1_e3 == AtG1E3::E3 || self.at_g1_e3 == AtG1E3::X30;
            self.outputs.mr = self.at_g1 == AtG1::X4 || self.at_g1 == AtG1::X5;
            self.outputs.tm_down = self.at_g1 == AtG1::X5;
            self.outputs.tm_up = self.at_g1 == AtG1::X6;
            let xm2_1 = self.at_g1 == AtG1::E2
                || self.at_g1 == AtG1::X20
                || self.at_g1 == AtG1::X21
                || self.at_g1 == AtG1::S2;
            let xm3_1 = self.at_g1_e3 == AtG1E3::E3
                || self.at_g1_e3 == AtG1E3::X30
                || self.at_g1_e3 == AtG1E3::S3;
            self.outputs.busy = self.x9 && (xm2_1 || xm3_1);
        }
    }

    /// The outputs of the last scan.
    pub const fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// What has gone wrong since the start, or since the flags were cleared.
    pub const fn flags(&self) -> Flags {
        self.flags
    }

    /// Lowers all flags.
    pub const fn clear_flags(&mut self) {
        self.flags.livelock = false;
        self.flags.alloc_conflict = false;
        self.flags.force_conflict = false;
        self.flags.div0 = false;
    }

    /// Back to the state before the first scan; the next one is the initial reaction.
    pub const fn reset(&mut self) {
        *self = Self::new();
    }

    /// The situation: the active steps, in order of declaration.
    pub fn active_steps(&self) -> impl Iterator<Item = Step> + '_ {
        Step::ALL.into_iter().filter(|step| self.is_active(*step))
    }

    /// Whether a step is active; none is before the first scan.
    pub fn is_active(&self, step: Step) -> bool {
        if !self.started {
            return false;
        }
        match step {
            Step::X1 => self.at_g1 == AtG1::X1,
            Step::X4 => self.at_g1 == AtG1::X4,
            Step::X5 => self.at_g1 == AtG1::X5,
            Step::X6 => self.at_g1 == AtG1::X6,
            Step::E2 => self.at_g1 == AtG1::E2,
            Step::X20 => self.at_g1 == AtG1::X20,
            Step::X21 => self.at_g1 == AtG1::X21,
            Step::S2 => self.at_g1 == AtG1::S2,
            Step::E3 => self.at_g1_e3 == AtG1E3::E3,
            Step::X30 => self.at_g1_e3 == AtG1E3::X30,
            Step::S3 => self.at_g1_e3 == AtG1E3::S3,
            Step::X9 => self.x9,
        }
    }

    /// How many bytes the saved memory takes.
    pub const SAVED_LEN: usize = 32;

    /// Which program saved bytes belong to: another chart, or encoding, has another.
    const FINGERPRINT: u64 = 0x5efa7406e6b18ea6;

    /// All memory as bytes, to be kept where power does not matter.
    pub fn save(&self) -> [u8; Self::SAVED_LEN] {
        let mut bytes = [0; Self::SAVED_LEN];
        let mut out = Saver::new(&mut bytes);
        out.put(Self::FINGERPRINT);
        out.put(self.at_g1 as u32);
        out.put(self.at_g1_e3 as u32);
        out.put(self.x9);
        out.put(self.old_td);
        out.put(self.started);
        out.put(self.on_x4.state().0);
        out.put(self.on_x4.state().1);
        seal(&mut bytes);
        bytes
    }

    /// The chart as it was saved; none if these are not the bytes of this very program, not all as
    /// they were saved, or no situation of the chart. Outputs are those of its situation under
    /// `inputs`. Delays go on at `now`: the time in between does not count.
    pub fn restore(bytes: &[u8], _inputs: &Inputs, now: u32) -> Option<Self> {
        if bytes.len() != Self::SAVED_LEN {
            return None;
        }
        let mut from = Restorer::sealed(bytes)?;
        if from.take() != Some(Self::FINGERPRINT) {
            return None;
        }
        let mut chart = Self::new();
        chart.at_g1 = *AtG1::ALL.get(from.take::<u32>()? as usize)?;
        chart.at_g1_e3 = *AtG1E3::ALL.get(from.take::<u32>()? as usize)?;
        chart.x9 = from.take()?;
        chart.old_td = from.take()?;
        chart.started = from.take()?;
        chart.on_x4 = Timer::resumed((from.take()?, from.take()?), now)?;
        if !chart.is_possible() {
            return None;
        }
        chart.restore_outputs();
        Some(chart)
    }

    /// For each step the number of the set that it excludes the others of; 0 is none.
    const SETS: [usize; 12] = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1];

    /// Whether the active steps can be active together.
    fn is_possible(&self) -> bool {
        let mut taken = [false; 1];
        for step in self.active_steps() {
            let set = Self::SETS[step as usize];
            if set > 0 && core::mem::replace(&mut taken[set - 1], true) {
                return false;
            }
        }
        // of the first sets, one step is always active
        !self.started || taken.iter().all(|taken| *taken)
    }
}

/// What the chart needs at run time.
pub mod runtime {
    /// What has gone wrong since the start or since the flags were last cleared. A
    /// flag stays raised once it is.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct Flags {
        /// LIVELOCK: the situation did not become stable within the bound of
        /// micro-steps. The reaction stopped there, and the next call went on (R9).
        pub livelock: bool,
        /// ALLOC_CONFLICT: two stored actions gave one variable different values at
        /// the same time; the last assignment won (R7).
        pub alloc_conflict: bool,
        /// FORCE_CONFLICT: two forcing orders asked for different situations of one
        /// grafcet; the order of the highest grafcet, then the first, won (R2).
        pub force_conflict: bool,
        /// DIV0: something was divided by zero; the result was 0.
        pub div0: bool,
    }

    impl Flags {
        /// Whether any flag is raised.
        #[inline]
        pub const fn any(&self) -> bool {
            self.livelock || self.alloc_conflict || self.force_conflict || self.div0
        }
    }

    /// A value that can be saved in a fixed number of bytes.
    pub trait Saved: Sized {
        /// How many bytes it takes.
        const LEN: usize;

        /// Writes the value to the first `LEN` bytes. If there are fewer, nothing is
        /// written.
        fn write(self, into: &mut [u8]);

        /// Reads a value from the first `LEN` bytes. None if there are fewer, or if
        /// they are no value of this type.
        fn read(from: &[u8]) -> Option<Self>;
    }

    /// How many bytes the seal takes.
    pub const SEAL_LEN: usize = u32::LEN;

    /// The CRC-32 of IEEE 802.3, as zip and Ethernet have it. It finds each change of
    /// one, two or three bits in up to 11 KiB, each change of one or two in any buffer
    /// up to 512 MiB, and of other changes all but one in four thousand million.
    pub fn crc32(bytes: &[u8]) -> u32 {
        // Bit by bit: a table would be larger than most charts.
        let mut crc = u32::MAX;
        for byte in bytes {
            crc ^= u32::from(*byte);
            for _ in 0..u8::BITS {
                let feedback = if crc & 1 == 1 { 0xEDB8_8320 } else { 0 };
                crc = (crc >> 1) ^ feedback;
            }
        }
        !crc
    }

    /// Writes the seal of all bytes before it to the last [`SEAL_LEN`] bytes. A buffer
    /// that is shorter is left as it is.
    pub fn seal(buffer: &mut [u8]) {
        if let Some(length) = buffer.len().checked_sub(SEAL_LEN) {
            let (bytes, seal) = buffer.split_at_mut(length);
            crc32(bytes).write(seal);
        }
    }

    /// Saves values in a buffer, one after the other.
    #[derive(Debug)]
    pub struct Saver<'b> {
        rest: &'b mut [u8],
    }

    impl<'b> Saver<'b> {
        /// Begins at the start of `buffer`.
        #[inline]
        pub fn new(buffer: &'b mut [u8]) -> Self {
            Self { rest: buffer }
        }

        /// Saves one value. A value that does not fit is left out, and so are all
        /// that follow it: the buffer never holds a later value in an earlier's place.
        // It is called for each variable: inlined, it would be most of the code.
        #[inline(never)]
        pub fn put<V: Saved>(&mut self, value: V) {
            let rest = core::mem::take(&mut self.rest);
            if let Some((head, tail)) = rest.split_at_mut_checked(V::LEN) {
                value.write(head);
                self.rest = tail;
            }
        }
    }

    /// Takes values back from a buffer, one after the other.
    #[derive(Clone, Debug)]
    pub struct Restorer<'b> {
        rest: &'b [u8],
    }

    impl<'b> Restorer<'b> {
        /// Begins at the start of `buffer`.
        #[inline]
        pub const fn new(buffer: &'b [u8]) -> Self {
            Self { rest: buffer }
        }

        /// Begins at the start of a buffer that was sealed, and ends before the seal.
        /// None if the seal is not that of the bytes before it.
        pub fn sealed(buffer: &'b [u8]) -> Option<Self> {
            let length = buffer.len().checked_sub(SEAL_LEN)?;
            let (bytes, seal) = buffer.split_at_checked(length)?;
            (u32::read(seal) == Some(crc32(bytes))).then_some(Self::new(bytes))
        }

        /// Takes the next value. None, and nothing is taken, if there are not enough
        /// bytes left or if they are no value of this type, as a bool that is 2.
        // It is called for each variable: inlined, it would be most of the code.
        #[inline(never)]
        pub fn take<V: Saved>(&mut self) -> Option<V> {
            let (head, tail) = self.rest.split_at_checked(V::LEN)?;
            let value = V::read(head)?;
            self.rest = tail;
            Some(value)
        }

        /// Whether all bytes have been taken.
        #[inline]
        pub const fn is_done(&self) -> bool {
            self.rest.is_empty()
        }
    }

    impl Saved for bool {
        const LEN: usize = 1;

        fn write(self, into: &mut [u8]) {
            u8::from(self).write(into);
        }

        fn read(from: &[u8]) -> Option<Self> {
            match from.first() {
                Some(0) => Some(false),
                Some(1) => Some(true),
                _ => None,
            }
        }
    }

    /// Numbers: each pattern of bits is a value.
    macro_rules! saved_numbers {
        ($($number:ty)*) => {$(
            impl Saved for $number {
                const LEN: usize = size_of::<Self>();

                fn write(self, into: &mut [u8]) {
                    if let Some(bytes) = into.first_chunk_mut() {
                        *bytes = self.to_le_bytes();
                    }
                }

                fn read(from: &[u8]) -> Option<Self> {
                    let bytes = from.first_chunk()?;
                    Some(Self::from_le_bytes(*bytes))
                }
            }
        )*};
    }

    saved_numbers!(u8 u16 i16 u32 i32 u64 i64 f32 f64);

    /// An on-delay in the sense of TON (IEC 61131-3): it measures for how long its
    /// input has been true without interruption.
    ///
    /// The clock `now` counts milliseconds and wraps around every 49.7 days. So a
    /// timer must be called at least once in half that time, but it may run longer.
    /// What looks like more than half the range between two calls is a clock that was
    /// put back: it counts as no time, so that no delay ends by it.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub struct Timer {
        /// How long the input had been true at the last call, in milliseconds.
        elapsed: i64,
        /// The time of the last call in which the input was true.
        last: u32,
        /// The input of the last call.
        running: bool,
    }

    impl Timer {
        /// The longest time between two calls, in milliseconds: half the range.
        const LONGEST_GAP: u32 = 1 << 31;

        /// A timer whose input is false.
        #[inline]
        pub const fn new() -> Self {
            Self {
                elapsed: 0,
                // It is not read before the timer starts.
                last: 0,
                running: false,
            }
        }

        /// Brings the timer up to date. All that is asked of it afterwards holds for
        /// this very `now`.
        #[inline]
        pub fn call(&mut self, input: bool, now: u32) {
            if !input {
                self.elapsed = 0;
            } else if self.running {
                // The difference is right across the end of the clock's range too.
                let passed = now.wrapping_sub(self.last);
                if passed <= Self::LONGEST_GAP {
                    self.elapsed = self.elapsed.saturating_add(i64::from(passed));
                }
                self.last = now;
            } else {
                self.elapsed = 0;
                self.last = now;
            }
            self.running = input;
        }

        /// Whether the input has been true for `preset` milliseconds. The interval is
        /// closed (rule X5): this is so from the very instant start + preset.
        #[inline]
        pub const fn has_run(&self, preset: i64) -> bool {
            self.running && self.elapsed >= preset
        }

        /// How long the input has been true, in milliseconds; 0 while it is false.
        #[inline]
        pub const fn elapsed(&self) -> i64 {
            self.elapsed
        }

        /// What is to be saved of the timer: whether it runs, and for how long it has.
        #[inline]
        pub const fn state(&self) -> (bool, i64) {
            (self.running, self.elapsed)
        }

        /// The timer that was saved as `state`, going on at `now`. The time in between
        /// does not count. None if no timer has this state: an elapsed time is not
        /// negative, and of a timer that does not run it is 0.
        pub const fn resumed(state: (bool, i64), now: u32) -> Option<Self> {
            let (running, elapsed) = state;
            if elapsed < 0 || (!running && elapsed > 0) {
                return None;
            }
            let mut timer = Self::new();
            if running {
                timer.running = true;
                timer.last = now;
                timer.elapsed = elapsed;
            }
            Some(timer)
        }
    }
}
