//! How many bytes a chart takes in memory.

use super::memory::{self, WORD, words};
use super::names::RustNames;
use super::places::Places;
use crate::types::size;
use grafc_logic::scan::{Program, Role};

/// A timer: an `i64`, a `u32`, a `bool`.
const TIMER: usize = 16;
const FLAGS: usize = 4;

/// What `size_of` gives for the chart's struct on machines that align each number to its own size. rustc sorts the
/// fields of a struct by size, so that only its end is filled up.
pub fn size_of(program: &Program) -> usize {
    let names = RustNames::new(program);
    let places = Places::new(program, &names);
    let mut fields = vec![(FLAGS, 1)];
    fields.extend((words(program) > 0).then(|| (words(program) * WORD / 8, WORD / 8)));
    fields.extend(program.timers.iter().map(|_| (TIMER, 8)));
    for id in memory::fields(program, &places).into_iter().flat_map(|(_, group)| group) {
        let bytes = match places.state(id) {
            Some(state) => enumeration(state.variants.len()),
            None => size(program.variables[id].ty),
        };
        fields.push((bytes, bytes.max(1)));
    }
    for role in [Role::Output, Role::Internal] {
        let own = program.variables.iter().filter(|v| v.role == role).map(|v| (size(v.ty), size(v.ty)));
        fields.push(structure(own.collect()));
    }
    structure(fields).0
}

/// The size and alignment of a struct of fields with these.
fn structure(fields: Vec<(usize, usize)>) -> (usize, usize) {
    let alignment = fields.iter().map(|(_, alignment)| *alignment).max().unwrap_or(1);
    let sum: usize = fields.iter().map(|(size, _)| size).sum();
    (sum.next_multiple_of(alignment), alignment)
}

/// The size of an enum with so many variants; an only one takes none.
fn enumeration(variants: usize) -> usize {
    match variants {
        0 | 1 => 0,
        2..=0x100 => 1,
        0x101..=0x1_0000 => 2,
        _ => 4,
    }
}
