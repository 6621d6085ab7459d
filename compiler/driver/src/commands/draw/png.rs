//! PNG.

use super::scene;
use resvg::tiny_skia::{Color, Pixmap, Transform};

/// So many pixels are drawn for one unit, so that print and large screens are sharp.
const SCALE: f32 = 2.0;
/// More pixels than this need more memory than a drawing is worth, and longer sides few viewers can show.
const MOST: f32 = 150e6;
const LONGEST: f32 = 30_000.0;

/// The picture; refused if it is too large.
pub fn png(svg: &str) -> Result<Vec<u8>, String> {
    let tree = scene::tree(svg)?;
    let at = |scale: f32| ((tree.size().width() * scale).ceil(), (tree.size().height() * scale).ceil());
    let fits = |(wide, high): (f32, f32)| wide.max(high) <= LONGEST && wide * high <= MOST;
    let scale = if fits(at(SCALE)) { SCALE } else { 1.0 };
    let (wide, high) = at(scale);
    let refusal = || format!("the drawing of {wide} by {high} pixels is too large for PNG");
    if !fits((wide, high)) {
        return Err(refusal());
    }
    let mut pixels = Pixmap::new(wide as u32, high as u32).ok_or_else(refusal)?;
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| format!("the drawing cannot be converted: {error}"))
}
