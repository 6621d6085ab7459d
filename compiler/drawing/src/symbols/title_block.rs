//! The title block of a sheet.

use crate::font::{COMMENT, TEXT, shown, width};
use crate::picture::{Anchor, Group, Shape, Style};
use grafc_layout::{Bounds, Point};

/// What stands in it.
pub(crate) struct TitleBlock<'a> {
    pub chart: &'a str,
    /// The grafcets and expansions on the sheet.
    pub parts: String,
    pub revision: Option<&'a str>,
    pub page: usize,
    pub pages: usize,
}

/// Its height.
pub(crate) const HEIGHT: i32 = 36;

impl TitleBlock<'_> {
    /// Draws it as wide as the sheet, with the upper left corner at a place; so many times as large as it is at full size.
    pub(crate) fn draw(&self, left: i32, top: i32, wide: i32, times: f64) -> (Group, Bounds) {
        let more = |length: i32| (f64::from(length) * times).round() as i32;
        let (small, normal, high) = (more(COMMENT), more(TEXT), more(HEIGHT));
        let mut group = Group::new("title-block");
        group.at = Point { x: left, y: top };
        let page = format!("{} of {}", self.page, self.pages);
        let revision = self.revision.map(shown);
        let mut columns = vec![("page", page)];
        columns.extend(revision.map(|revision| ("revision", revision)));
        let least = |text: &str, head: &str| width(text, normal).max(width(head, small)) + more(20);
        let name = shown(self.chart);
        let fixed: i32 = columns.iter().map(|(head, text)| least(text, head).max(more(70))).sum();
        let first = least(&name, "chart");
        let parts = shorten(&self.parts, (wide - fixed - first).max(more(120)) - more(20), normal);
        let wide = wide.max(fixed + first + least(&parts, "grafcets"));
        let mut right = wide;
        let mut cells = Vec::new();
        for (head, text) in &columns {
            let own = least(text, head).max(more(70));
            right -= own;
            cells.push((right, *head, text.clone()));
        }
        cells.push((0, "chart", name));
        if !parts.is_empty() {
            cells.push((first, "grafcets", parts));
        }
        group.shapes.push(Shape::rect(0, 0, wide, high, Style::Box));
        for (x, head, text) in cells {
            if x > 0 {
                group.shapes.push(Shape::line(&[(x, 0), (x, high)]));
            }
            group.shapes.push(Shape::text((x + more(8), more(13)), Anchor::Start, "heading", small, head.to_string()));
            group.shapes.push(Shape::text((x + more(8), more(29)), Anchor::Start, "entry", normal, text));
        }
        (group, Bounds { left, top, right: left + wide, bottom: top + high })
    }
}

/// As many names as fit, and how many are left out.
fn shorten(parts: &str, most: i32, size: i32) -> String {
    if width(parts, size) <= most {
        return parts.to_string();
    }
    let names: Vec<&str> = parts.split(", ").collect();
    let mut out = String::new();
    for (place, name) in names.iter().enumerate() {
        let rest = format!("{out}{name}, + {}", names.len() - place - 1);
        if place > 0 && width(&rest, size) > most {
            out.push_str(&format!("+ {}", names.len() - place));
            return out;
        }
        out.push_str(name);
        out.push_str(", ");
    }
    parts.to_string()
}
