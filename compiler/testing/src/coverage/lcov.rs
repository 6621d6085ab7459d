//! Coverage on the lines of the text, in the form of lcov, which editors and servers show.

use super::Coverage;
use grafc_diagnostics::SourceFile;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// What is known of a line.
#[derive(Default)]
struct Line {
    /// The least of the counts of what stands on it: a line is covered if all of it is.
    count: Option<u64>,
    /// For each value of each atom on it, how often it was met; none if the condition was never asked.
    branches: Vec<[Option<u64>; 2]>,
}

/// The record of a chart. A step, a transition, an action and an order count for the line that they begin on, an atom of a
/// condition for its own: its two values are two branches.
pub fn lcov(coverage: &Coverage, source: &SourceFile) -> String {
    let mut lines: BTreeMap<usize, Line> = BTreeMap::new();
    let line_of = |byte: u32| source.position(byte as usize).line;
    for item in coverage.items() {
        let line = lines.entry(line_of(item.span.start)).or_default();
        line.count = Some(line.count.map_or(item.count, |least| least.min(item.count)));
        let Some(condition) = item.condition else { continue };
        let of_item = line_of(item.span.start);
        for atom in &condition.atoms {
            let place = line_of(coverage.place(atom.expr).start);
            let line = lines.entry(place).or_default();
            let asked = atom.counts[0] + atom.counts[1];
            line.branches.push(atom.counts.map(|count| (asked > 0).then_some(count)));
            if place != of_item {
                line.count = Some(line.count.map_or(asked, |least| least.min(asked)));
            }
        }
    }
    let mut text = format!("TN:\nSF:{}\n", source.name);
    let (mut branches, mut branches_met) = (0, 0);
    for (number, line) in &lines {
        for (block, branch) in line.branches.iter().enumerate() {
            for (value, count) in branch.iter().enumerate() {
                let taken = count.map_or("-".to_string(), |count| count.to_string());
                let _ = writeln!(text, "BRDA:{number},{block},{value},{taken}");
                branches += 1;
                branches_met += usize::from(count.is_some_and(|count| count > 0));
            }
        }
    }
    if branches > 0 {
        let _ = writeln!(text, "BRF:{branches}\nBRH:{branches_met}");
    }
    let counts = || lines.iter().filter_map(|(number, line)| Some((number, line.count?)));
    for (number, count) in counts() {
        let _ = writeln!(text, "DA:{number},{count}");
    }
    let met = counts().filter(|(_, count)| *count > 0).count();
    let _ = writeln!(text, "LF:{}\nLH:{met}\nend_of_record", counts().count());
    text
}
