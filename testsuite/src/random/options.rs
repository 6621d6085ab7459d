//! What the heading of a random chart chooses of its meaning; drawn apart, so that the rest of a chart stays as it is.

use fastrand::Rng;
use std::fmt::Write as _;

/// The choices, as the heading has them.
#[derive(Clone, Copy, Default)]
pub(super) struct Options {
    /// `evolution scan`, and what says which actions are done each scan.
    scan: Option<u64>,
    initial_actions: Option<bool>,
    bound: Option<u32>,
}

impl Options {
    /// Those of a seed: mostly none.
    pub fn draw(seed: u64) -> Options {
        let mut rng = Rng::with_seed(seed ^ 0x6865_6164);
        let scan = (rng.u8(0..6) == 0).then(|| rng.u64(..));
        Options {
            scan,
            initial_actions: (rng.u8(0..12) == 0).then(|| rng.bool()),
            bound: (scan.is_none() && rng.u8(0..12) == 0).then(|| rng.u32(2..=12)),
        }
    }

    /// What stands behind the name of the chart.
    pub fn text(self) -> String {
        let mut text = String::new();
        if self.scan.is_some() {
            text.push_str(" evolution scan");
        }
        if let Some(on) = self.initial_actions {
            text.push_str(if on { " initial_actions on" } else { " initial_actions off" });
        }
        if let Some(bound) = self.bound {
            let _ = write!(text, " bound {bound}");
        }
        text
    }

    /// What says which actions are done each scan, if the chart evolves so.
    pub fn scans(self) -> Option<Rng> {
        self.scan.map(Rng::with_seed)
    }
}
