//! Saving what a chart retains over a restart, and starting anew with it.
//!
//! These bytes are of a few variables by their names and types, so that they outlive a change of the chart elsewhere. All
//! memory, to go on where the chart stood, is another matter: `saved`.

use super::literals::{size, type_name};
use super::names::RustNames;
use super::places::Places;
use super::saved::{Chunks, Fingerprint, MARK};
use crate::writer::Writer;
use grafc_logic::scan::{Program, VarId, Variable};

/// Writes `save_retained` and `restarted`, in functions of at most about `longest` lines; nothing where nothing is retained.
pub(super) fn write(out: &mut Writer, program: &Program, names: &RustNames, places: &Places, longest: usize) {
    let retained = || program.variables.iter_enumerated().filter(|(_, variable)| variable.retain);
    if retained().next().is_none() {
        return;
    }
    let length = MARK + retained().map(|(_, variable)| size(variable.ty)).sum::<usize>();
    let mut print = Fingerprint::of(&program.name);
    let mut add = |(id, variable): (VarId, &Variable)| {
        print.add(&names.variables[id]);
        print.add(type_name(variable.ty));
    };
    retained().for_each(&mut add);
    let of_each =
        |text: fn(&str) -> String| -> Vec<String> { retained().map(|(id, _)| text(places.read(id))).collect() };
    out.blank();
    out.line("/// How many bytes the retained variables take.");
    out.line(&format!("pub const RETAINED_LEN: usize = {length};"));
    out.blank();
    out.line("/// Which retained variables saved bytes belong to.");
    out.line(&format!("const RETAINED: u32 = 0x{:08x};", print.0));
    save(out, &of_each(|place| format!("out.put({place});")), longest);
    restart(out, &of_each(|place| format!("{place} = from.take()?;")), longest);
}

fn save(out: &mut Writer, lines: &[String], longest: usize) {
    let chunks = Chunks::new("save_retained", lines, longest);
    out.blank();
    out.line("/// The retained variables as bytes, to be kept where power does not matter.");
    out.open("pub fn save_retained(&self) -> [u8; Self::RETAINED_LEN] {");
    out.line("let mut bytes = [0; Self::RETAINED_LEN];");
    out.line("let mut out = Saver::new(&mut bytes);");
    out.line("out.put(Self::RETAINED);");
    match &chunks {
        None => lines.iter().for_each(|line| out.line(line)),
        Some(chunks) => chunks.call(out, |name| format!("self.{name}(&mut out);")),
    }
    out.line("bytes");
    out.close("}");
    if let Some(chunks) = chunks {
        chunks.write(out, |_| "(&self, out: &mut Saver)".to_owned(), None);
    }
}

fn restart(out: &mut Writer, lines: &[String], longest: usize) {
    let chunks = Chunks::new("restarted", lines, longest);
    out.blank();
    out.line("/// The chart before its first scan, with the retained variables as they were saved; none if these");
    out.line("/// are not the bytes of its retained variables.");
    out.open("pub fn restarted(bytes: &[u8]) -> Option<Self> {");
    out.line("let mut from = Restorer::new(bytes);");
    out.open("if bytes.len() != Self::RETAINED_LEN || from.take() != Some(Self::RETAINED) {");
    out.line("return None;");
    out.close("}");
    out.line("let mut chart = Self::new();");
    match &chunks {
        None => lines.iter().for_each(|line| out.line(&line.replacen("self.", "chart.", 1))),
        Some(chunks) => chunks.call(out, |name| format!("chart.{name}(&mut from)?;")),
    }
    out.line("Some(chart)");
    out.close("}");
    if let Some(chunks) = chunks {
        let head = |_: &[String]| "(&mut self, from: &mut Restorer) -> Option<()>".to_owned();
        chunks.write(out, head, Some("Some(())"));
    }
}
