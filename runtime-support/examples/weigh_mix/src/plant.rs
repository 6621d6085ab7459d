//! The plant, simulated: what valves and motors do to it, and what its sensors see.
//!
//! Two powders are weighed into one unit, A up to a first mark and B up to a second, and fall from there into the mixer.
//! A belt brings bricks, which fall past a detector into the mixer too. The mixer turns, and tips to be emptied.

use crate::weigh_mix::{Inputs, Outputs};

/// How long an instant of the simulation is, in milliseconds. All rates below are per instant.
pub const TICK: u32 = 100;

/// What the valves let through, in grams.
const FLOW_A: u32 = 2_000;
const FLOW_B: u32 = 1_000;
const FLOW_C: u32 = 2_500;

/// The marks of the weighing unit, in grams.
const MARK_A: u32 = 60_000;
const MARK_AB: u32 = 100_000;

/// After so many instants the belt has brought the next brick to its end,
const BRICK_DISTANCE: u32 = 20;
/// and for so many the detector sees it fall.
const BRICK_FALLS: u32 = 2;

/// So many instants the mixer takes to tip, and to come back.
const TIPPING: u32 = 30;

/// The state of the plant, and of the panel its operator stands at.
#[derive(Default)]
pub struct Plant {
    /// Buttons and the selector; the sensors have fields of their own.
    pub panel: Inputs,
    /// In the weighing unit: grams of A and of B.
    weighed: [u32; 2],
    /// In the mixer: grams of powder, and bricks.
    powder: u32,
    bricks: u32,
    /// How far the belt has run since the last brick fell.
    belt: u32,
    /// For how many instants the detector will still see a brick.
    falling: u32,
    /// How far the mixer is tipped, from 0 to [`TIPPING`].
    tipped: u32,
}

impl Plant {
    /// What is in the weighing unit, in kilograms.
    pub fn weight(&self) -> f64 {
        f64::from(self.weighed.iter().sum::<u32>()) / 1000.0
    }

    /// What the controller sees: the panel and the sensors.
    pub fn inputs(&self) -> Inputs {
        let total: u32 = self.weighed.iter().sum();
        Inputs {
            td: self.falling > 0,
            a: total >= MARK_A,
            b: total >= MARK_AB,
            z: total == 0,
            s0: self.tipped == 0,
            s1: self.tipped == TIPPING,
            ..self.panel
        }
    }

    /// Somebody takes everything out of the weighing unit.
    pub fn clear_weighing_unit(&mut self) {
        self.weighed = [0, 0];
    }

    /// Lets one instant pass; says what could be heard of it.
    pub fn pass(&mut self, outputs: &Outputs) -> Vec<String> {
        let mut heard = Vec::new();
        if outputs.va {
            self.weighed[0] += FLOW_A;
        }
        if outputs.vb {
            self.weighed[1] += FLOW_B;
        }
        if outputs.vc {
            let mut left = FLOW_C;
            for product in &mut self.weighed {
                let flows = left.min(*product);
                *product -= flows;
                left -= flows;
                self.powder += flows;
            }
        }
        self.falling = self.falling.saturating_sub(1);
        if outputs.bm {
            self.belt += 1;
            if self.belt == BRICK_DISTANCE {
                self.belt = 0;
                self.falling = BRICK_FALLS;
                self.bricks += 1;
                heard.push("a brick falls into the mixer".to_string());
            }
        }
        if outputs.tm_down {
            self.tipped = (self.tipped + 1).min(TIPPING);
            if self.tipped == TIPPING && self.powder > 0 {
                heard.push(format!("{} kg and {} bricks leave the mixer", self.powder / 1000, self.bricks));
                (self.powder, self.bricks) = (0, 0);
            }
        }
        if outputs.tm_up {
            self.tipped = self.tipped.saturating_sub(1);
        }
        heard
    }
}
