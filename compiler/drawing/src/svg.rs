//! The text of a picture: SVG that any viewer and any program can read, without scripts and without anything from outside.

use crate::picture::{Anchor, Group, Picture, Shape, Style};
use crate::sheet::Page;
use grafc_layout::{Bounds, Point};
use std::fmt::Write as _;

/// The look of everything, also where several drawings stand in one document. The first fonts have equal widths.
const SHEET: &str = "\
.grafc{background:#fff}\
.grafc rect,.grafc path,.grafc circle{fill:none;stroke:#111;stroke-width:1.5}\
.grafc .fill{fill:#111;stroke:none}\
.grafc .box{fill:#fff}\
.grafc .outline{stroke:#555;stroke-width:1}\
.grafc text{font-family:\"Liberation Sans\",Arial,Helvetica,\"Grafc Sans\",sans-serif;\
font-kerning:none;fill:#111;white-space:pre}\
.grafc .comment,.grafc .heading{fill:#555}\
@media (prefers-color-scheme:dark){\
.grafc,.grafc .box{background:#1b1d20;fill:#1b1d20}\
.grafc rect,.grafc path,.grafc circle{stroke:#e4e4e4}\
.grafc .fill{fill:#e4e4e4;stroke:none}\
.grafc .outline{stroke:#999}\
.grafc text{fill:#e4e4e4}\
.grafc .comment,.grafc .heading{fill:#a8a8a8}}\
@media print{\
.grafc,.grafc .box{background:#fff;fill:#fff}\
.grafc rect,.grafc path,.grafc circle{stroke:#000}\
.grafc .fill{fill:#000;stroke:none}\
.grafc text,.grafc .comment,.grafc .heading{fill:#000}}";

/// Writes a picture. On a page it is as large as the paper.
pub fn svg(picture: &Picture, page: Option<Page>) -> String {
    let size = match page.map(Page::millimetres) {
        Some((wide, high)) => format!("width=\"{wide}mm\" height=\"{high}mm\""),
        None => format!("width=\"{}\" height=\"{}\"", picture.bounds.width(), picture.bounds.height()),
    };
    write(
        picture,
        "xmlns=\"http://www.w3.org/2000/svg\" ",
        &format!("{size} "),
        "img",
        &format!("<style>{SHEET}{}</style>\n", picture.look),
    )
}

/// Writes a picture as a part of an HTML page: its parts have names of their own there, and the page gives the look.
pub fn svg_in_html(picture: &Picture) -> String {
    write(picture, "", "", "group", "")
}

fn write(picture: &Picture, namespace: &str, size: &str, role: &str, style: &str) -> String {
    let Bounds { left, top, .. } = picture.bounds;
    let (wide, high) = (picture.bounds.width(), picture.bounds.height());
    let mut out = String::new();
    let _ = write!(
        out,
        "<svg {namespace}class=\"grafc\" {size}viewBox=\"{left} {top} {wide} {high}\" role=\"{role}\" \
         aria-labelledby=\"grafc-title grafc-description\">\n<title id=\"grafc-title\">{}</title>\n\
         <desc id=\"grafc-description\">{}</desc>\n{style}",
        escaped(&picture.title),
        escaped(&picture.description)
    );
    // Groups are few levels deep whatever the chart: a diagram, its elements, their actions.
    for group in &picture.groups {
        write_group(&mut out, group, 0);
    }
    out.push_str("</svg>\n");
    out
}

fn write_group(out: &mut String, group: &Group, depth: usize) {
    let indent = "  ".repeat(depth);
    let _ = write!(out, "{indent}<g class=\"{}\"", escaped(&group.class));
    for (name, value) in &group.data {
        let _ = write!(out, " {name}=\"{}\"", escaped(value));
    }
    if group.at != Point::default() {
        let _ = write!(out, " transform=\"translate({} {})\"", group.at.x, group.at.y);
    }
    out.push('>');
    if let Some(title) = &group.title {
        let _ = write!(out, "<title>{}</title>", escaped(title));
    }
    group.shapes.iter().for_each(|shape| write_shape(out, shape));
    if !group.groups.is_empty() {
        out.push('\n');
        group.groups.iter().for_each(|inner| write_group(out, inner, depth + 1));
        out.push_str(&indent);
    }
    out.push_str("</g>\n");
}

fn write_shape(out: &mut String, shape: &Shape) {
    let _ = match shape {
        Shape::Rect { bounds, style } => {
            let Bounds { left, top, .. } = *bounds;
            let (wide, high) = (bounds.width(), bounds.height());
            let class = class(*style);
            write!(out, "<rect{class} x=\"{left}\" y=\"{top}\" width=\"{wide}\" height=\"{high}\"/>")
        }
        Shape::Path { lines, closed, style } => {
            let mut d = String::new();
            for line in lines {
                path(&mut d, line);
                if *closed {
                    d.push('Z');
                }
            }
            write!(out, "<path{} d=\"{d}\"/>", class(*style))
        }
        Shape::Dot { at } => write!(out, "<circle class=\"fill dot\" cx=\"{}\" cy=\"{}\" r=\"4\"/>", at.x, at.y),
        Shape::Text { at, anchor, class, size, text } => {
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
                Anchor::End => " text-anchor=\"end\"",
            };
            let text = escaped(text);
            let Point { x, y } = *at;
            write!(out, "<text class=\"{class}\" x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{anchor}>{text}</text>")
        }
    };
}

fn class(style: Style) -> &'static str {
    match style {
        Style::Box => " class=\"box\"",
        Style::Line => "",
        Style::Bar => " class=\"fill bar\"",
        Style::Filled => " class=\"fill\"",
        Style::Frame => " class=\"outline\"",
    }
}

/// `M0 0H40V20`: what is horizontal or vertical needs one number.
fn path(d: &mut String, line: &[Point]) {
    let mut last: Option<Point> = None;
    for point in line {
        let Point { x, y } = *point;
        let _ = match last {
            None => write!(d, "M{x} {y}"),
            Some(before) if before.y == y => write!(d, "H{x}"),
            Some(before) if before.x == x => write!(d, "V{y}"),
            Some(_) => write!(d, "L{x} {y}"),
        };
        last = Some(*point);
    }
}

/// A text as it stands between tags and in attributes. Characters that XML has no way to write are shown as such.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            '\t' | '\n' | '\r' => {
                let _ = write!(out, "&#{};", c as u32);
            }
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
