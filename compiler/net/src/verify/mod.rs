//! Checks the invariants that [`crate::net`] lists. A violation is a fault of grafc, never of the chart.
//!
//! First the tables, in `tables`: once those are right, nothing that reads the net can go astray. Then what the passes
//! say that they have brought about, in `facts`.

mod facts;
mod tables;

use crate::net::Net;

/// Says which invariant of the net does not hold, if one does not.
pub fn verify(net: &Net) -> Result<(), String> {
    tables::verify(net)?;
    facts::verify(net)
}
