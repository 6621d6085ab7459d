//! Weigh_mix_b5: weighing and mixing, modes by forcing orders, IEC 60848 annex B.5
//!
//! from weigh_mix_b5.gct
//! A call takes at most 200 micro-steps, 8612 statements.

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
    /// `PBES`: emergency stop button pressed
    pub pbes: bool,
    /// `SSAuto`: selector on automatic
    pub ssauto: bool,
    /// `SSManu`: selector on manual
    pub ssmanu: bool,
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
    /// `EMC`: manual control enabled
    pub emc: bool,
}

/// The steps of the chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// step D1: stopped
    D1,
    /// step A6: initial state, manual control
    A6,
    /// step F1: normal production
    F1,
    /// step 1: ready
    X1,
    /// step 2: weigh A
    X2,
    /// step 3: weigh B
    X3,
    /// step 4: empty the weighing unit into the mixer
    X4,
    /// step 5: powder is in
    X5,
    /// step 6: first brick
    X6,
    /// step 7: second brick
    X7,
    /// step 8: bricks are in
    X8,
    /// step 9: mix
    X9,
    /// step 10: tip, still turning
    X10,
    /// step 11: come back up
    X11,
}

impl Step {
    /// All steps, in order of declaration.
    pub const ALL: [Self; 14] = [
        Self::D1,
        Self::A6,
        Self::F1,
        Self::X1,
        Self::X2,
        Self::X3,
        Self::X4,
        Self::X5,
        Self::X6,
        Self::X7,
        Self::X8,
        Self::X9,
        Self::X10,
        Self::X11,
    ];

    const LABELS: [&'static str; 14] = [
        "D1", "A6", "F1", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11",
    ];

    /// The label in the chart.
    pub const fn label(self) -> &'static str {
        Self::LABELS[self as usize]
    }
}

/// weighing and mixing, modes by forcing orders, IEC 60848 annex B.5
///
/// Its state between two scans; see [`Self::scan`].
#[derive(Clone, Debug)]
pub struct WeighMixB5 {
    // which steps are active, a bit each
    situation: [u32; 1],
    // steps
    xa6_d1: bool,
    xf1_a6: bool,
    // memory from scan to scan
    old_td: bool,
    /// false until the first call
    started: bool,
    // delays
    on_x9: Timer,
    // what can be seen from outside
    outputs: Outputs,
    flags: Flags,
}

impl Default for WeighMixB5 {
    fn default() -> Self {
        Self::new()
    }
}

impl WeighMixB5 {
    /// The chart before its first scan.
    pub const fn new() -> Self {
        Self {
            situation: [0; 1],
            xa6_d1: false,
            xf1_a6: false,
            old_td: false,
            started: false,
            on_x9: Timer::new(),
            outputs: Outputs {
                va: false,
                vb: false,
                vc: false,
                bm: false,
                mr: false,
                tm_down: false,
                tm_up: false,
                emc: false,
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
        use Step::*;

        if !self.started {
            self.started = true;
            self.set(D1, true);
            self.old_td = inputs.td;
        }
        let mut micro_steps: i16 = 0;

        while self.micro_step(inputs, now) {
            micro_steps += 1;
            if micro_steps >= 200 {
                self.flags.livelock = true;
                break;
            }
        }

        // outputs in G1: the modes
        self.outputs.emc = self.is_active(A6);

        // outputs in G10: the cycle
        self.outputs.va = self.is_active(X2);
        self.outputs.vb = self.is_active(X3);
        self.outputs.vc = self.is_active(X4);
        self.outputs.bm = self.is_active(X6) || self.is_active(X7);
        self.outputs.mr = self.is_active(X9) || self.is_active(X10);
        self.outputs.tm_down = self.is_active(X10);
        self.outputs.tm_up = self.is_active(X11);

        &self.outputs
    }

    // one micro-step; true if another is needed
    #[inline(never)]
    fn micro_step(&mut self, inputs: &Inputs, now: u32) -> bool {
        use Step::*;

        // conditions
        let rise_td = inputs.td && !self.old_td;
        self.on_x9.call(self.is_active(X9), now);

        // memory of edges
        let mut again = inputs.td != self.old_td;
        self.old_td = inputs.td;

        // grafcets that orders freeze
        let frozen_g10 = self.is_active(D1) || self.is_active(A6);

        // next situation in G1: the modes
        let next_d1 = !self.is_active(A6)
            && ((self.is_active(F1) && inputs.pbes) || self.xa6_d1 || self.is_active(D1));
        let next_a6 = !(self.xa6_d1 || self.is_active(F1))
            && ((self.is_active(D1) && !inputs.pbes) || self.xf1_a6 || self.is_active(A6));
        let next_f1 = !(self.xf1_a6 || self.is_active(D1))
            && ((self.is_active(A6) && inputs.ssauto && !inputs.ssmanu && !inputs.pbes)
                || self.is_active(F1));
        let next_a6_d1 =
            !self.is_active(D1) && ((self.is_active(A6) && inputs.pbes) || self.xa6_d1);
        let next_f1_a6 = !self.is_active(A6)
            && ((self.is_active(F1) && inputs.ssmanu && !inputs.pbes) || self.xf1_a6);

        // next situation in G10: the cycle
        if next_d1 && next_a6 {
            self.flags.force_conflict = true;
        }
        let force_g10_by_a6 = next_a6 && !next_d1;
        let forced_g10 = next_d1 || force_g10_by_a6;
        let next_1 = force_g10_by_a6
            || (!forced_g10
                && !(self.is_active(X2) || self.is_active(X6))
                && ((self.is_active(X11) && !frozen_g10 && inputs.s0) || self.is_active(X1)));
        let all_x1_frozen_g10_cs_more =
            self.is_active(X1) && !frozen_g10 && inputs.cs && inputs.z && inputs.s0;
        let next_2 =
            !forced_g10 && !self.is_active(X3) && (all_x1_frozen_g10_cs_more || self.is_active(X2));
        let next_3 = !forced_g10
            && !self.is_active(X4)
            && ((self.is_active(X2) && !frozen_g10 && inputs.a) || self.is_active(X3));
        let next_4 = !forced_g10
            && !self.is_active(X5)
            && ((self.is_active(X3) && !frozen_g10 && inputs.b) || self.is_active(X4));
        let next_5 = !forced_g10
            && !self.is_active(X9)
            && ((self.is_active(X4) && !frozen_g10 && inputs.z) || self.is_active(X5));
        let next_6 =
            !forced_g10 && !self.is_active(X7) && (all_x1_frozen_g10_cs_more || self.is_active(X6));
        let next_7 = !forced_g10
            && !self.is_active(X8)
            && ((self.is_active(X6) && !frozen_g10 && rise_td) || self.is_active(X7));
        let next_8 = !forced_g10
            && !self.is_active(X9)
            && ((self.is_active(X7) && !frozen_g10 && rise_td) || self.is_active(X8));
        let next_9 = !forced_g10
            && !self.is_active(X10)
            && ((self.is_active(X5) && self.is_active(X8) && !frozen_g10) || self.is_active(X9));
        let next_10 = !forced_g10
            && !self.is_active(X11)
            && ((self.is_active(X9) && !frozen_g10 && self.on_x9.has_run(MIX_TIME))
                || self.is_active(X10));
        let next_11 = !forced_g10
            && !self.is_active(X1)
            && ((self.is_active(X10) && !frozen_g10 && inputs.s1) || self.is_active(X11));
        again = again
            || next_d1 != self.is_active(D1)
            || next_a6 != self.is_active(A6)
            || next_f1 != self.is_active(F1)
            || next_1 != self.is_active(X1)
            || next_2 != self.is_active(X2)
            || next_3 != self.is_active(X3)
            || next_4 != self.is_active(X4)
            || next_5 != self.is_active(X5)
            || next_6 != self.is_active(X6)
            || next_7 != self.is_active(X7)
            || next_8 != self.is_active(X8)
            || next_9 != self.is_active(X9)
            || next_10 != self.is_active(X10)
            || next_11 != self.is_active(X11)
            || next_a6_d1 != self.xa6_d1
            || next_f1_a6 != self.xf1_a6;

        // situation in G1: the modes
        self.set(D1, next_d1);
        self.set(A6, next_a6);
        self.set(F1, next_f1);
        self.xa6_d1 = next_a6_d1;
        self.xf1_a6 = next_f1_a6;

        // situation in G10: the cycle
        self.set(X1, next_1);
        self.set(X2, next_2);
        self.set(X3, next_3);
        self.set(X4, next_4);
        self.set(X5, next_5);
        self.set(X6, next_6);
        self.set(X7, next_7);
        self.set(X8, next_8);
        self.set(X9, next_9);
        self.set(X10, next_10);
        self.set(X11, next_11);

        again
    }

    // what follows from the memory that has been restored
    fn restore_outputs(&mut self) {
        use Step::*;

        if self.started {
            // outputs
            self.outputs.va = self.is_active(X2);
            self.outputs.vb = self.is_active(X3);
            self.outputs.vc = self.is_active(X4);
            self.outputs.bm = self.is_active(X6) || self.is_active(X7);
            self.outputs.mr = self.is_active(X9) || self.is_active(X10);
            self.outputs.tm_down = self.is_active(X10);
            self.outputs.tm_up = self.is_active(X11);
            self.outputs.emc = self.is_active(A6);
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

    /// Whether a step is active.
    pub const fn is_active(&self, step: Step) -> bool {
        self.situation[step as usize / 32] >> (step as usize % 32) & 1 != 0
    }

    const fn set(&mut self, step: Step, active: bool) {
        let mask = 1 << (step as usize % 32);
        if active {
            self.situation[step as usize / 32] |= mask;
        } else {
            self.situation[step as usize / 32] &= !mask;
        }
    }

    /// How many bytes the saved memory takes.
    pub const SAVED_LEN: usize = 31;

    /// Which program saved bytes belong to: another chart, or encoding, has another.
    const FINGERPRINT: u64 = 0xe5fbc9439bb3eb10;

    /// All memory as bytes, to be kept where power does not matter.
    pub fn save(&self) -> [u8; Self::SAVED_LEN] {
        let mut bytes = [0; Self::SAVED_LEN];
        let mut out = Saver::new(&mut bytes);
        out.put(Self::FINGERPRINT);
        out.put(self.situation[0]);
        out.put(self.xa6_d1);
        out.put(self.xf1_a6);
        out.put(self.old_td);
        out.put(self.started);
        out.put(self.flags.livelock);
        out.put(self.flags.force_conflict);
        out.put(self.on_x9.state().0);
        out.put(self.on_x9.state().1);
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
        chart.situation[0] = from.take()?;
        chart.xa6_d1 = from.take()?;
        chart.xf1_a6 = from.take()?;
        chart.old_td = from.take()?;
        chart.started = from.take()?;
        chart.flags.livelock = from.take()?;
        chart.flags.force_conflict = from.take()?;
        chart.on_x9 = Timer::resumed((from.take()?, from.take()?), now)?;
        if chart.situation[0] >> 14 != 0 {
            return None;
        }
        if !chart.started && chart.active_steps().next().is_some() {
            return None;
        }
        chart.restore_outputs();
        Some(chart)
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
