//! What one body writes and another reads in the same scan.
//!
//! In SFC bodies are done one after the other, so a later one reads what an earlier one has just written. In a chart the
//! right sides of a scan see the values of before; only those `each scan` see what events of the same scan have stored,
//! and their conditions do not (R15). Where that makes a difference the report says so, once of each variable.

use super::maker::{Action, Maker, When};
use super::terms::{StepId, TermId, TermKind, VarId};
use crate::{Dialect, doubtful, lost};
use rustc_hash::{FxHashMap, FxHashSet};

/// Who does something: a step, or none for what is done whatever step is active.
type Doer = Option<StepId>;

/// When something is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Written {
    Entry,
    Exit,
    Scan,
}

/// How something is read.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Read {
    /// In what an event stores.
    ByEvent,
    /// In what is stored in each scan.
    EachScan,
    /// In the condition of what is stored in each scan.
    Condition,
}

impl Read {
    /// Whether a chart reads the value of before, where the other writes in the same scan.
    fn is_before(self, written: Written) -> bool {
        match self {
            Read::ByEvent | Read::Condition => true,
            Read::EachScan => written == Written::Scan,
        }
    }
}

/// Who writes a variable, and when, by the part of the doer.
type Writers = FxHashMap<VarId, Vec<(Written, Option<usize>, FxHashSet<Doer>)>>;

/// The flags by which CODESYS lets a program act on its chart.
const FLAGS: [&str; 12] = [
    "SFCCurrentStep",
    "SFCEnableLimit",
    "SFCError",
    "SFCErrorAnalyzationTable",
    "SFCErrorPOU",
    "SFCErrorStep",
    "SFCInit",
    "SFCPause",
    "SFCQuitError",
    "SFCReset",
    "SFCTip",
    "SFCTipMode",
];

impl Maker<'_> {
    /// Says of which variables a chart reads the value of the scan before.
    pub fn order(&mut self) {
        let writers = self.writers();
        let before = self.steps_before();
        for (doer, action) in self.all_actions() {
            let Action::Stored { variable, value, when } = action else { continue };
            let (read, guard) = match when {
                When::EachScan(guard) => (Read::EachScan, guard),
                When::Activation | When::Deactivation => (Read::ByEvent, None),
            };
            for (term, read) in [(Some(value), read), (guard, Read::Condition)] {
                for operand in term.map(|term| self.variables_of(term)).unwrap_or_default() {
                    // A variable that keeps its value where the condition does not hold reads itself.
                    if operand == variable && read == Read::ByEvent {
                        continue;
                    }
                    if let Some(writer) = self.written_in_scan(operand, doer, read, &writers, &before) {
                        self.tell_order(operand, writer, doer, term);
                    }
                }
            }
        }
    }

    /// Says that flags of CODESYS do nothing to the chart.
    pub fn flags(&mut self, unit: usize) {
        if self.dialect != Dialect::Codesys {
            return;
        }
        let declared =
            self.project.units[unit].variables.iter().map(|variable| (variable.name.as_str(), variable.span));
        let read = self.variables.list.iter().map(|variable| (variable.path.as_str(), variable.span));
        let flag = |name: &str| FLAGS.into_iter().find(|flag| flag.eq_ignore_ascii_case(name));
        let mut found: Vec<_> = declared.chain(read).filter_map(|(name, span)| Some((flag(name)?, span))).collect();
        let mut met = FxHashSet::default();
        found.retain(|(flag, _)| met.insert(*flag));
        let Some((_, first)) = found.first() else { return };
        let flags: Vec<String> = found.iter().map(|(flag, _)| format!("`{flag}`")).collect();
        let message = format!("what {} would do to the chart, or tell of it, is lost", flags.join(", "));
        self.diagnostics.push(lost(*first, message).note("flags of CODESYS are variables like all others here"));
    }

    fn all_actions(&self) -> Vec<(Doer, Action)> {
        let of_steps = self.step_texts.iter_enumerated();
        let of_steps = of_steps.flat_map(|(step, text)| text.actions.iter().map(move |&action| (Some(step), action)));
        of_steps.chain(self.always.iter().map(|&action| (None, action))).collect()
    }

    fn part_of(&self, doer: Doer) -> Option<usize> {
        doer.map(|step| self.steps[step].part)
    }

    fn writers(&self) -> Writers {
        let mut writers = Writers::default();
        for (doer, action) in self.all_actions() {
            let Action::Stored { variable, when, .. } = action else { continue };
            let written = match when {
                When::Activation => Written::Entry,
                When::Deactivation => Written::Exit,
                When::EachScan(_) => Written::Scan,
            };
            let part = self.part_of(doer);
            let groups = writers.entry(variable).or_default();
            match groups.iter_mut().find(|(when, of, _)| (*when, *of) == (written, part)) {
                Some((.., doers)) => {
                    doers.insert(doer);
                }
                None => groups.push((written, part, FxHashSet::from_iter([doer]))),
            }
        }
        writers
    }

    /// The steps that are left where each is entered.
    fn steps_before(&self) -> FxHashMap<StepId, Vec<StepId>> {
        let mut before: FxHashMap<StepId, Vec<StepId>> = FxHashMap::default();
        for part in self.parts.iter().filter(|part| part.chart.is_sequential()) {
            let id = |step: usize| StepId::new(part.first + step);
            for transition in &part.chart.transitions {
                for &behind in &transition.behind {
                    before.entry(id(behind)).or_default().extend(transition.before.iter().map(|&step| id(step)));
                }
            }
        }
        before
    }

    /// Who writes a variable in a scan in which another reads it, so that the chart reads the value of before.
    fn written_in_scan(
        &self,
        variable: VarId,
        reader: Doer,
        read: Read,
        writers: &Writers,
        before: &FxHashMap<StepId, Vec<StepId>>,
    ) -> Option<Doer> {
        let part = self.part_of(reader);
        let groups = writers.get(&variable)?.iter().filter(|(written, ..)| read.is_before(*written));
        for (written, of, doers) in groups {
            // The entry of a step comes before its body.
            if read == Read::Condition && *written == Written::Entry && doers.contains(&reader) {
                return Some(reader);
            }
            let sequential = *of == part && part.is_some_and(|part| self.parts[part].chart.is_sequential());
            let found = if !sequential {
                doers.iter().copied().filter(|doer| *doer != reader).min()
            } else if *written == Written::Exit {
                let before = reader.and_then(|reader| before.get(&reader)).into_iter().flatten();
                before.map(|&step| Some(step)).find(|doer| *doer != reader && doers.contains(doer))
            } else {
                None
            };
            if found.is_some() {
                return found;
            }
        }
        None
    }

    fn tell_order(&mut self, variable: VarId, writer: Doer, reader: Doer, term: Option<TermId>) {
        let own = &self.variables.list[variable];
        if own.used.helper || !self.said.insert(format!("order {}", variable.index())) {
            return;
        }
        let span = term.map_or(own.span, |term| self.terms.terms[term].span);
        let name = |doer: Doer| match doer {
            Some(step) => {
                let step = &self.steps[step];
                format!("the step `{}`", self.parts[step.part].chart.steps[step.step].name)
            }
            None => "what is done in each scan".to_string(),
        };
        let (path, writes, reads) = (&own.path, name(writer), name(reader));
        let message = if writer == reader {
            format!("{reads} reads `{path}` in the scan in which its entry writes it, and takes the value of before")
        } else {
            format!("{reads} reads `{path}` in a scan in which {writes} writes it, and takes the value of before")
        };
        let note = "in SFC bodies are done one after the other, and one that comes later takes what was just written";
        self.diagnostics.push(doubtful(span, message).note(note));
    }

    /// The variables in a term.
    fn variables_of(&self, term: TermId) -> Vec<VarId> {
        let mut found = Vec::new();
        self.terms.parts(term, 10_000, |term| {
            if let TermKind::Variable(variable) = term.kind {
                found.push(variable);
            }
        });
        found
    }
}
