//! The symbols of the standard, one kind a file, each drawn around its own origin: for what stands in a diagram the axis
//! and the upper end of its body.

pub(crate) mod action;
pub(crate) mod comment;
pub(crate) mod frame;
pub(crate) mod label;
pub(crate) mod link;
pub(crate) mod order;
pub(crate) mod step;
pub(crate) mod title_block;
pub(crate) mod transition;

use crate::picture::Group;
use grafc_layout::Size;

/// A symbol, and what it takes.
#[derive(Clone, Debug)]
pub(crate) struct Symbol {
    pub group: Group,
    pub size: Size,
}

/// A square step is so wide and high.
pub(crate) const STEP: i32 = 40;
