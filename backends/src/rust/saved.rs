//! Saving the memory of a chart as bytes, and restoring it.

use super::chart::{memory, words};
use super::literals::size;
use super::names::Names;
use super::places::Places;
use crate::writer::Writer;
use grafc_logic::scan::{Program, Role, VarId};

/// The bytes of the mark that says which chart, in which form, they are the memory of.
const MARK: usize = 4;

/// Writes `save` and `restore`.
pub(super) fn write(out: &mut Writer, program: &Program, names: &Names, places: &Places) {
    let saved = Saved { program, names, places };
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
    names: &'p Names,
    places: &'p Places<'p>,
}

impl Saved<'_> {
    /// Everything that keeps its value, but for the packed situation and the timers.
    fn variables(&self) -> Vec<VarId> {
        let mut list: Vec<VarId> = memory(self.program, self.places).into_iter().flat_map(|(_, group)| group).collect();
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

    /// FNV-1a over the names and types of all that is saved.
    fn fingerprint(&self) -> u32 {
        let mut hash: u32 = 0x811c_9dc5;
        let mut add = |text: &str| {
            for byte in text.bytes().chain([0]) {
                hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
            }
        };
        add(&self.program.name);
        for step in &self.program.steps {
            add(&step.label);
        }
        for id in self.variables() {
            add(&self.names.variables[id]);
            match self.places.state(id) {
                Some(state) => state.variants.iter().for_each(|(_, name)| add(name)),
                None => add(super::literals::type_name(self.program.variables[id].ty)),
            }
        }
        for timer in &self.names.timers {
            add(timer);
        }
        hash
    }

    fn save(&self, out: &mut Writer) {
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
        for id in self.variables() {
            let place = self.places.read(id);
            match self.places.state(id) {
                Some(_) => out.line(&format!("out.put({place} as u32);")),
                None => out.line(&format!("out.put({place});")),
            }
        }
        for id in self.program.timers.indices() {
            out.line(&format!("let (running, elapsed) = {}.state();", self.places.timer(id)));
            out.line("out.put(running);");
            out.line("out.put(elapsed);");
        }
        out.line("bytes");
        out.close("}");
    }

    fn restore(&self, out: &mut Writer) {
        out.blank();
        out.line("/// The chart as it was saved; none if these are not the bytes of this chart. Delays go on at");
        out.line("/// `now`: the time in between does not count.");
        let now = if self.program.timers.is_empty() { "_now" } else { "now" };
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
        for id in self.variables() {
            let place = self.places.read(id).replacen("self.", "chart.", 1);
            match self.places.state(id) {
                Some(state) => {
                    out.line(&format!("{place} = *{}::ALL.get(from.take::<u32>()? as usize)?;", state.ty));
                }
                None => out.line(&format!("{place} = from.take()?;")),
            }
        }
        for id in self.program.timers.indices() {
            let place = self.places.timer(id).replacen("self.", "chart.", 1);
            out.line(&format!("{place} = Timer::resumed((from.take()?, from.take()?), now);"));
        }
        out.line("Some(chart)");
        out.close("}");
    }
}
