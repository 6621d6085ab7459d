//! SVG as PDF and PNG read it: with the embedded font alone, so that the same is made everywhere.

use grafc::drawing::font;
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};
use std::sync::Arc;

/// Reads what grafc has written.
pub fn tree(svg: &str) -> Result<Tree, String> {
    let mut fonts = Database::new();
    fonts.load_font_data(font::FILE.to_vec());
    for set in [Database::set_sans_serif_family, Database::set_serif_family] {
        set(&mut fonts, font::FAMILY);
    }
    let options = Options { fontdb: Arc::new(fonts), font_family: font::FAMILY.to_string(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(|error| format!("the drawing cannot be converted: {error}"))
}
