//! Saving the memory of a chart as bytes, and restoring it.

use super::literals::size;
use super::memory::{self, words};
use super::names::RustNames;
use super::places::Places;
use crate::writer::Writer;
use grafc_logic::scan::{Program, Role, VarId};

/// The bytes of the mark that says which chart, in which form, they are the memory of.
pub(super) const MARK: usize = 4;

/// Such a mark: FNV-1a over texts.
pub(super) struct Fingerprint(pub u32);

impl Fingerprint {
    /// That of one text.
    pub fn of(text: &str) -> Self {
        let mut print = Fingerprint(0x811c_9dc5);
        print.add(text);
        print
    }

    /// Takes another text in.
    pub fn add(&mut self, text: &str) {
        for byte in text.bytes().chain([0]) {
            self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
        }
    }
}

/// Writes `save` and `restore`, in functions of at most about `longest` lines.
pub(super) fn write(out: &mut Writer, program: &Program, names: &RustNames, places: &Places, longest: usize) {
    let saved = Saved { program, names, places, longest };
    out.line("/// How many bytes the saved memory takes.");
    out.line(&format!("pub const SAVED_LEN: usize = {};", saved.length()));
    out.blank();
    out.line("/// Which chart, and which form of its memory, saved bytes belong to.");
    out.line(&format!("const FINGERPRINT: u32 = 0x{:08x};", saved.fingerprint()));
    saved.save(out);
    saved.restore(out);
}

struct Saved<'p> {
    program: &'p Program,
    names: &'p RustNames,
    places: &'p Places<'p>,
    longest: usize,
}

impl Saved<'_> {
    /// Everything that keeps its value, except the packed situation and the timers.
    fn variables(&self) -> Vec<VarId> {
        let mut list: Vec<VarId> =
            memory::fields(self.program, self.places).into_iter().flat_map(|(_, group)| group).collect();
        let kept = |role| matches!(role, Role::Output | Role::Internal | Role::Flag(_));
        list.extend(self.program.variables.iter_enumerated().filter(|(_, v)| kept(v.role)).map(|(id, _)| id));
        list
    }

    /// A state is saved as the number of its variant.
    fn size(&self, id: VarId) -> usize {
        match self.places.state(id) {
            Some(_) => 4,
            None => size(self.program.variables[id].ty),
        }
    }

    fn length(&self) -> usize {
        let variables: usize = self.variables().into_iter().map(|id| self.size(id)).sum();
        MARK + 4 * words(self.program) + variables + self.program.timers.len() * (1 + 8)
    }

    /// Of the names and types of all that is saved.
    fn fingerprint(&self) -> u32 {
        let mut print = Fingerprint::of(&self.program.name);
        for step in &self.program.steps {
            print.add(&step.label);
        }
        for id in self.variables() {
            print.add(&self.names.variables[id]);
            match self.places.state(id) {
                Some(state) => state.variants.iter().for_each(|(_, name)| print.add(name)),
                None => print.add(super::literals::type_name(self.program.variables[id].ty)),
            }
        }
        for timer in &self.names.timers {
            print.add(timer);
        }
        print.0
    }

    fn save(&self, out: &mut Writer) {
        let mut lines = Vec::new();
        for id in self.variables() {
            let place = self.places.read(id);
            lines.push(match self.places.state(id) {
                Some(_) => format!("out.put({place} as u32);"),
                None => format!("out.put({place});"),
            });
        }
        for id in self.program.timers.indices() {
            let timer = self.places.timer(id);
            lines.push(format!("out.put({timer}.state().0);"));
            lines.push(format!("out.put({timer}.state().1);"));
        }
        let chunks = Chunks::new("save", &lines, self.longest);
        out.blank();
        out.line("/// All memory as bytes, to be kept where power does not matter.");
        out.open("pub fn save(&self) -> [u8; Self::SAVED_LEN] {");
        out.line("let mut bytes = [0; Self::SAVED_LEN];");
        out.line("let mut out = Saver::new(&mut bytes);");
        out.line("out.put(Self::FINGERPRINT);");
        if words(self.program) > 0 {
            out.open("for word in self.situation {");
            out.line("out.put(word);");
            out.close("}");
        }
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

    fn restore(&self, out: &mut Writer) {
        let mut lines = Vec::new();
        for id in self.variables() {
            let place = self.places.read(id);
            lines.push(match self.places.state(id) {
                Some(state) => format!("{place} = *{}::ALL.get(from.take::<u32>()? as usize)?;", state.ty),
                None => format!("{place} = from.take()?;"),
            });
        }
        for id in self.program.timers.indices() {
            lines.push(format!("{} = Timer::resumed((from.take()?, from.take()?), now);", self.places.timer(id)));
        }
        let chunks = Chunks::new("restore", &lines, self.longest);
        let now = if self.program.timers.is_empty() { "_now" } else { "now" };
        out.blank();
        out.line("/// The chart as it was saved; none if these are not the bytes of this chart. Delays go on at");
        out.line("/// `now`: the time in between does not count.");
        out.open(&format!("pub fn restore(bytes: &[u8], {now}: u32) -> Option<Self> {{"));
        out.line("let mut from = Restorer::new(bytes);");
        out.open("if bytes.len() != Self::SAVED_LEN || from.take() != Some(Self::FINGERPRINT) {");
        out.line("return None;");
        out.close("}");
        out.line("let mut chart = Self::new();");
        if words(self.program) > 0 {
            out.open("for word in &mut chart.situation {");
            out.line("*word = from.take()?;");
            out.close("}");
        }
        match &chunks {
            None => lines.iter().for_each(|line| out.line(&line.replacen("self.", "chart.", 1))),
            Some(chunks) => chunks.call(out, |name| format!("chart.{name}(&mut from, {now})?;")),
        }
        out.line("Some(chart)");
        out.close("}");
        if let Some(chunks) = chunks {
            let timers = |lines: &[String]| lines.iter().any(|line| line.contains("Timer::resumed("));
            let now = |lines: &[String]| if timers(lines) { "now" } else { "_now" };
            let head =
                |lines: &[String]| format!("(&mut self, from: &mut Restorer, {}: u32) -> Option<()>", now(lines));
            chunks.write(out, head, Some("Some(())"));
        }
    }
}

/// The lines of a function that is too long for rustc, as functions of their own.
pub(super) struct Chunks<'l> {
    function: &'static str,
    lines: std::slice::Chunks<'l, String>,
}

impl<'l> Chunks<'l> {
    pub fn new(function: &'static str, lines: &'l [String], longest: usize) -> Option<Self> {
        (lines.len() > longest).then(|| Chunks { function, lines: lines.chunks(longest) })
    }

    /// Writes the calls of all parts.
    pub fn call(&self, out: &mut Writer, call: impl Fn(&str) -> String) {
        for part in 1..=self.lines.len() {
            out.line(&call(&format!("{}_{part}", self.function)));
        }
    }

    /// Writes the parts; `end` is the last line of each.
    pub fn write(self, out: &mut Writer, head: impl Fn(&[String]) -> String, end: Option<&str>) {
        for (part, lines) in (1..).zip(self.lines) {
            out.blank();
            out.line("#[inline(never)]");
            out.open(&format!("fn {}_{part}{} {{", self.function, head(lines)));
            lines.iter().for_each(|line| out.line(line));
            end.iter().for_each(|line| out.line(line));
            out.close("}");
        }
    }
}
