//! One sheet, its paper and its margins.

use crate::picture::Picture;

/// A size of paper.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Page {
    /// 210 x 297 mm, upright.
    A4,
    /// 420 x 297 mm, across.
    A3,
}

impl Page {
    /// Width and height in millimetres.
    pub fn millimetres(self) -> (i32, i32) {
        match self {
            Page::A4 => (210, 297),
            Page::A3 => (420, 297),
        }
    }
}

/// What stays free around a sheet, and around what is on a page.
pub(crate) const MARGIN: i32 = 20;
pub(crate) const EDGE: i32 = 40;
/// From one grafcet to the next.
pub(crate) const APART: i32 = 60;
/// A sheet without its title block.
pub(crate) struct Sheet {
    pub picture: Picture,
    pub parts: Vec<String>,
    /// So many times as large as its page is what is drawn on it; its title block and margins are that, too, so that
    /// they are equal on all pages.
    pub times: f64,
}

/// A length that is equal on all pages.
pub(crate) fn on_paper(length: i32, times: f64) -> i32 {
    (f64::from(length) * times).round() as i32
}
