//! What is claimed of the chart, as a table in the margin: a row a claim, in the order of the text, each with its keyword, what
//! its author calls it, and its body as written.

use crate::font::{COMMENT, TEXT, shown, width, wrapped};
use crate::panel::Panel;
use crate::picture::{Anchor, Group, Shape, Style};
use grafc_layout::{Bounds, Point};
use grafc_model::chart::{Claim, Tables};

/// What such a table is called where the parts of a sheet are named.
pub(crate) const NAME: &str = "claims";

/// A text that is wider is broken at blanks.
const MOST: i32 = 240;
/// A body that is wider is broken at blanks.
const MOST_BODY: i32 = 360;
/// From the line around a cell to what is in it.
const PADDING: i32 = 8;
/// From one line of a cell to the next.
const LINE: i32 = 16;

/// A row: the lines of its cells, and the place of its claim among all.
struct Row<'a> {
    claim: &'a Claim,
    place: usize,
    text: Vec<String>,
    body: Vec<String>,
}

impl Row<'_> {
    fn height(&self) -> i32 {
        LINE * self.text.len().max(self.body.len()).max(1) as i32 + PADDING
    }
}

/// The claims of a chart in as many tables as they need, none higher than `most` if it has more than one row. None where
/// nothing is claimed.
pub(crate) fn claims(chart: &Tables, most: i32) -> Vec<Panel> {
    let rows: Vec<Row<'_>> = chart.claims.list.iter().enumerate().map(|(place, claim)| row(claim, place)).collect();
    let texts = rows.iter().flat_map(|row| &row.text).map(|line| width(line, COMMENT)).max();
    let keyword = rows.iter().map(|row| width(row.claim.kind.keyword(), TEXT)).max().unwrap_or(0);
    let body = rows.iter().flat_map(|row| &row.body).map(|line| width(line, TEXT)).max().unwrap_or(0);
    // Where nobody has given a claim a name, there is no column for it.
    let columns = [Some(keyword), texts, Some(body)].map(|wide| wide.map_or(0, |wide| wide + 2 * PADDING));
    let mut tables: Vec<(i32, Vec<Row<'_>>)> = Vec::new();
    for row in rows {
        let high = row.height();
        match tables.last_mut() {
            Some((total, rows)) if *total + high <= most => {
                *total += high;
                rows.push(row);
            }
            Some(_) | None => tables.push((high, vec![row])),
        }
    }
    tables.into_iter().map(|(high, rows)| table(&rows, columns, high)).collect()
}

fn row(claim: &Claim, place: usize) -> Row<'_> {
    let named = claim.text.as_deref().map(|text| format!("\"{}\"", shown(text)));
    let text = named.map(|text| wrapped(&text, COMMENT, MOST)).unwrap_or_default();
    Row { claim, place, text, body: wrapped(&shown(&claim.written), TEXT, MOST_BODY) }
}

fn table(rows: &[Row<'_>], columns: [i32; 3], high: i32) -> Panel {
    let wide = columns.iter().sum();
    let mut group = Group::new("claims");
    let mut top = 0;
    for row in rows {
        let height = row.height();
        let mut drawn = Group::new(&format!("claim {}", row.claim.kind.keyword()))
            .of("data-claim", row.place.to_string())
            .about(row.claim.text.as_deref());
        drawn.at = Point { x: 0, y: top };
        drawn.shapes.push(Shape::rect(0, 0, wide, height, Style::Frame));
        let mut left = 0;
        let cells: [(&str, i32, &[String]); 3] = [
            ("keyword", TEXT, &[row.claim.kind.keyword().to_string()]),
            ("comment", COMMENT, &row.text),
            ("condition", TEXT, &row.body),
        ];
        for ((class, size, lines), column) in cells.into_iter().zip(columns) {
            if left > 0 && column > 0 {
                drawn.shapes.push(Shape::path(&[(left, 0), (left, height)], false, Style::Frame));
            }
            drawn.shapes.extend(lines.iter().enumerate().map(|(number, line)| {
                let baseline = PADDING / 2 + LINE * number as i32 + 12;
                Shape::text((left + PADDING, baseline), Anchor::Start, class, size, line.clone())
            }));
            left += column;
        }
        group.groups.push(drawn);
        top += height;
    }
    Panel { groups: vec![group], bounds: Bounds { left: 0, top: 0, right: wide, bottom: high } }
}
