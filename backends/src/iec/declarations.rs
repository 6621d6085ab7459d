//! The variables of the function block, in the order in which a reader asks for them.

use super::literals::{self, is_zero, type_name};
use super::names::{Names, remark};
use crate::comment::clean;
use crate::writer::{Writer, column_of};
use ecow::EcoString;
use grafc_formula::Type;
use grafc_logic::scan::{GrafcetId, Held, Note, Origin, Origins, Program, Role, State, VarId, Variable};
use rustc_hash::FxHashMap;
use std::borrow::{Borrow, Cow};

/// Comments of neighbouring declarations start in one column, unless a declaration is longer than this.
const FURTHEST_COLUMN: usize = 48;

/// The standard's word for what a warm restart leaves as it is.
pub(crate) const RETAIN: &str = "RETAIN";

/// A block of declarations: sections, each with its heading.
pub(crate) struct VarBlock {
    /// What the variables are to the outside.
    pub kind: VarKind,
    /// Headings and what stands below them; some may be empty.
    pub sections: Vec<(Cow<'static, str>, Vec<Entry>)>,
}

/// The heading of what lives within one call.
const WITHIN: &str = "values within one call";

/// What the variables of a block are to the outside.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum VarKind {
    Input,
    Output,
    Constant,
    Local,
    /// They live within one call, and the target does not keep them.
    Temporary,
}

impl VarKind {
    /// What opens a block of them.
    pub fn keyword(self) -> &'static str {
        match self {
            VarKind::Input => "VAR_INPUT",
            VarKind::Output => "VAR_OUTPUT",
            VarKind::Constant => "VAR CONSTANT",
            VarKind::Local => "VAR",
            VarKind::Temporary => "VAR_TEMP",
        }
    }
}

impl VarBlock {
    fn new(kind: VarKind, sections: Vec<(&'static str, Vec<Entry>)>) -> Self {
        VarBlock { kind, sections: sections.into_iter().map(|(heading, entries)| (heading.into(), entries)).collect() }
    }

    /// Keeps the variables of whose names it is true.
    pub fn retain(&mut self, keep: impl Fn(&str) -> bool) {
        self.sections.iter_mut().for_each(|(_, entries)| entries.retain(|entry| keep(&entry.name)));
    }

    /// The lists that it is declared in: what begins anew after a restart, and what is retained; one that would be empty
    /// is not there.
    pub fn lists(&self) -> impl Iterator<Item = VarList<'_>> {
        [false, true].into_iter().filter_map(|retain| {
            let mut sections = Vec::with_capacity(self.sections.len());
            for (heading, entries) in &self.sections {
                let wanted = || entries.iter().filter(|entry| entry.retain == retain);
                let count = wanted().count();
                if count > 0 {
                    let mut entries = Vec::with_capacity(count);
                    entries.extend(wanted());
                    sections.push((heading.as_ref(), entries));
                }
            }
            (!sections.is_empty()).then_some(VarList { kind: self.kind, retain, sections })
        })
    }

    /// All variables, in order.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.sections.iter().flat_map(|(_, entries)| entries)
    }
}

/// Variables of a block that are declared together.
pub(crate) struct VarList<'b> {
    /// What they are to the outside.
    pub kind: VarKind,
    /// Whether a warm restart leaves them as they are.
    pub retain: bool,
    /// Headings and what stands below them; none is empty.
    pub sections: Vec<(&'b str, Vec<&'b Entry>)>,
}

impl<'b> VarList<'b> {
    /// What opens it; `retain` is the target's word for what is retained.
    pub fn keyword(&self, retain: &str) -> String {
        let keyword = self.kind.keyword();
        if self.retain { format!("{keyword} {retain}") } else { keyword.to_owned() }
    }

    /// All variables, in order.
    pub fn entries(&self) -> impl Iterator<Item = &'b Entry> {
        self.sections.iter().flat_map(|(_, entries)| entries.iter().copied())
    }
}

/// The type of a variable.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum EntryType {
    /// A type of the language.
    Elementary(Type),
    /// A timer.
    Timer,
    /// A function block.
    Block(Note),
}

impl EntryType {
    /// How it is written.
    pub fn name(&self) -> &str {
        match self {
            EntryType::Elementary(ty) => type_name(*ty),
            EntryType::Timer => "TON",
            EntryType::Block(name) => name,
        }
    }
}

/// One declaration.
pub(crate) struct Entry {
    /// The name.
    pub name: EcoString,
    /// Where the variable lies.
    pub address: Option<Note>,
    /// The type.
    pub ty: EntryType,
    /// The initial value, if it is not the one of the type.
    pub initial: Option<Note>,
    /// Whether a warm restart leaves it as it is.
    pub retain: bool,
    /// What stands beside it, clean.
    pub comment: Option<Note>,
    /// Where the variable comes from, if somebody asks.
    pub origin: Origin,
}

impl Entry {
    /// A variable of an elementary type, without anything beside it.
    pub fn plain(name: EcoString, ty: Type) -> Entry {
        Entry {
            name,
            address: None,
            ty: EntryType::Elementary(ty),
            initial: None,
            retain: false,
            comment: None,
            origin: Origin::Chart,
        }
    }

    /// How long its text is, in bytes.
    fn length(&self) -> usize {
        let address = self.address.as_deref().map_or(0, |address| " AT ".len() + address.len());
        let initial = self.initial.as_deref().map_or(0, |initial| " := ".len() + initial.len());
        self.name.len() + address + " : ".len() + self.ty.name().len() + initial + ";".len()
    }

    /// The pieces of its text, the name first.
    fn pieces(&self) -> impl Iterator<Item = &str> {
        let address = self.address.as_deref().map_or(["", ""], |address| [" AT ", address]);
        let initial = self.initial.as_deref().map_or(["", ""], |initial| [" := ", initial]);
        let [at, address] = address;
        let [becomes, initial] = initial;
        [self.name.as_str(), at, address, " : ", self.ty.name(), becomes, initial, ";"].into_iter()
    }

    /// Whether it may share a line. MATIEC crashes on lists of function blocks.
    fn is_plain(&self) -> bool {
        let elementary = match self.ty {
            EntryType::Elementary(_) => true,
            EntryType::Timer | EntryType::Block(_) => false,
        };
        elementary && self.address.is_none() && self.initial.is_none() && self.comment.is_none()
    }
}

/// All declarations of the function block; `more` are further values that live within one call.
pub(crate) fn interface(program: &Program, names: &Names, more: Vec<Entry>) -> Vec<VarBlock> {
    interface_from(program, names, None, more).collect()
}

/// The same, each block made when it is asked for; with `origins` it is noted where variables come from.
pub(crate) fn interface_from<'p>(
    program: &'p Program,
    names: &'p Names,
    origins: Option<&'p Origins>,
    mut more: Vec<Entry>,
) -> impl Iterator<Item = VarBlock> + use<'p> {
    let of_variable = move |id: VarId| origins.map_or(Origin::Chart, |origins| origins.variables[id]);
    let timers = move || {
        let timers = program.timers.iter_enumerated().map(|(id, timer)| Entry {
            name: names.timers[id].clone(),
            address: None,
            ty: EntryType::Timer,
            initial: None,
            retain: false,
            comment: timer.comment.as_deref().map(clean).filter(|text| !text.is_empty()).map(Note::from),
            origin: origins.map_or(Origin::Chart, |origins| origins.timers[id]),
        });
        timers.collect()
    };
    let kinds = [VarKind::Input, VarKind::Output, VarKind::Constant, VarKind::Local];
    kinds.into_iter().map(move |kind| {
        let sections = match kind {
            VarKind::Input => vec![("", entries(program, names, of_variable, |v| v.role == Role::Input))],
            VarKind::Output => {
                let mut published = entries(program, names, of_variable, |v| v.role == Role::Output);
                published
                    .extend(entries(program, names, of_variable, |v| v.role == Role::Internal && v.is_published()));
                published.extend(entries(program, names, of_variable, |v| matches!(v.role, Role::Flag(_))));
                vec![("", published)]
            }
            VarKind::Constant => vec![("", entries(program, names, of_variable, |v| v.role == Role::Constant))],
            VarKind::Local => {
                let mut within = entries(program, names, of_variable, |v| v.role == Role::Temporary);
                within.append(&mut more);
                let internal = entries(program, names, of_variable, |v| v.role == Role::Internal && !v.is_published());
                let mut sections = vec![("internal variables".into(), internal)];
                sections.extend(steps(program, names, of_variable));
                sections.extend([
                    ("timers".into(), timers()),
                    (
                        "memory from call to call".into(),
                        entries(program, names, of_variable, |v| v.role == Role::Memory),
                    ),
                    (WITHIN.into(), within),
                ]);
                return VarBlock { kind, sections };
            }
            VarKind::Temporary => Vec::new(),
        };
        VarBlock::new(kind, sections)
    })
}

/// The declarations of those variables that are `wanted`.
fn entries(
    program: &Program,
    names: &Names,
    of_variable: impl Fn(VarId) -> Origin,
    wanted: impl Fn(&Variable) -> bool,
) -> Vec<Entry> {
    let all = || program.variables.iter_enumerated().filter(|(_, variable)| wanted(variable));
    // Without a list that grows there is no room that is never used.
    let mut entries = Vec::with_capacity(all().count());
    entries.extend(all().map(|(id, variable)| Entry { origin: of_variable(id), ..entry(id, variable, names) }));
    entries
}

/// The same blocks, with what lives within one call in one of its own.
pub(crate) fn with_temporaries(mut blocks: Vec<VarBlock>) -> Vec<VarBlock> {
    let mut sections: Vec<Vec<(Cow<'static, str>, Vec<Entry>)>> = Vec::new();
    for block in blocks.iter_mut().filter(|block| block.kind == VarKind::Local) {
        let (within, kept) =
            std::mem::take(&mut block.sections).into_iter().partition(|(heading, _)| heading == WITHIN);
        block.sections = kept;
        sections.push(within);
    }
    let mut sections: Vec<_> = sections.into_iter().flatten().collect();
    sections.iter_mut().for_each(|(heading, _)| *heading = "".into());
    blocks.push(VarBlock { kind: VarKind::Temporary, sections });
    blocks
}

/// The declaration of a variable.
pub(super) fn entry(id: VarId, variable: &Variable, names: &Names) -> Entry {
    let name = &names.variables[id];
    let comment = match variable.role {
        Role::Input | Role::Output | Role::Internal | Role::Constant | Role::Step | Role::State => {
            remark(&variable.name, name, variable.comment.as_deref())
        }
        Role::Flag(_) | Role::Memory | Role::Temporary | Role::Observed => {
            remark(name, name, variable.comment.as_deref())
        }
    };
    let shown = !is_zero(variable.initial()) || variable.role == Role::Constant;
    Entry {
        name: name.clone(),
        address: None,
        ty: EntryType::Elementary(variable.ty),
        initial: shown.then(|| literals::initial(variable.initial(), variable.ty).into()),
        retain: variable.retain,
        comment: comment.map(Note::from),
        origin: Origin::Chart,
    }
}

/// The situation, grafcet by grafcet: a variable a step, or one that says which of several steps is active.
fn steps(
    program: &Program,
    names: &Names,
    of_variable: impl Fn(VarId) -> Origin,
) -> Vec<(Cow<'static, str>, Vec<Entry>)> {
    let states: FxHashMap<VarId, &State> = program.states.iter().map(|state| (state.variable, state)).collect();
    let all = program.variables.iter_enumerated().filter(|(_, v)| matches!(v.role, Role::Step | Role::State));
    let with_values = |(id, variable)| {
        let mut entry = Entry { origin: of_variable(id), ..entry(id, variable, names) };
        if let Some(state) = states.get(&id) {
            let values = values(program, state);
            entry.comment =
                Some(entry.comment.map_or_else(|| values.clone(), |text| format!("{text}: {values}")).into());
        }
        entry
    };
    let elements = &program.elements;
    let headed = elements.has_several_grafcets() || elements.grafcets.iter().any(|g| g.comment.is_some());
    if !headed {
        let mut entries = Vec::with_capacity(all.clone().count());
        entries.extend(all.map(with_values));
        return vec![("steps".into(), entries)];
    }
    let mut of: FxHashMap<VarId, GrafcetId> = FxHashMap::default();
    for (s, step) in program.steps.iter_enumerated() {
        let variable = match step.held {
            Held::Bit(variable) => variable,
            Held::State(place, _) => program.states[place].variable,
        };
        of.extend(elements.grafcet_of(s).map(|g| (variable, g)));
    }
    // Steps that a pass has added are in none.
    let mut sections: Vec<(Cow<'static, str>, Vec<Entry>)> =
        elements.grafcets.iter().map(|g| (format!("steps of {}", clean(&g.title())).into(), Vec::new())).collect();
    sections.push(("steps of ours".into(), Vec::new()));
    for (id, variable) in all {
        let place = of.get(&id).map_or(elements.grafcets.len(), |g| g.index());
        sections[place].1.push(with_values((id, variable)));
    }
    sections
}

/// So many values of a state are explained one by one.
const EXPLAINED: usize = 24;

/// What the values of a state stand for: `0 none, 1 Closed, 2 Opening`, and of steps that are numbers `1 to 11`.
fn values(program: &Program, state: &State) -> String {
    let mut values: Vec<(i64, &str)> = state.values.iter().map(|(s, value)| (*value, program.label(*s))).collect();
    values.sort_unstable();
    // `Y` of step `Y3` with the value 3.
    let word = |(value, label): &(i64, &'_ str)| label.strip_suffix(&value.to_string()).map(str::to_owned);
    let runs = values.chunk_by(|a, b| a.0 + 1 == b.0 && word(a).is_some() && word(a) == word(b));
    let mut parts: Vec<String> = state.idle.iter().map(|idle| format!("{idle} none")).collect();
    for run in runs {
        match run {
            [first, _, .., last] if word(first).is_some_and(|word| word.is_empty()) => {
                parts.push(format!("{} to {}", first.0, last.0));
            }
            [first, _, .., last] => parts.push(format!("{} to {} {} to {}", first.0, last.0, first.1, last.1)),
            few => parts.extend(few.iter().map(|(value, label)| match *label {
                label if label == value.to_string() => label.to_owned(),
                label => format!("{value} {label}"),
            })),
        }
    }
    let more = parts.len().saturating_sub(EXPLAINED);
    if more > 1 {
        parts.truncate(EXPLAINED);
        parts.push(format!("… ({more} more)"));
    }
    clean(&parts.join(", "))
}

/// A block of local variables.
pub(super) fn local(entries: Vec<Entry>) -> VarBlock {
    VarBlock::new(VarKind::Local, vec![("", entries)])
}

/// Writes blocks, each section under its heading; nothing of what is empty. `retain` is the target's word for what
/// is retained.
pub(crate) fn write(out: &mut Writer, blocks: impl IntoIterator<Item = impl Borrow<VarBlock>>, retain: &str) {
    for block in blocks {
        write_block(out, block.borrow(), retain);
    }
}

fn write_block(out: &mut Writer, block: &VarBlock, retain: &str) {
    for list in block.lists() {
        out.blank();
        out.open(&list.keyword(retain));
        for (heading, entries) in &list.sections {
            out.blank();
            out.comment(heading);
            section(out, entries);
        }
        out.close("END_VAR");
        out.blank();
    }
}

fn section(out: &mut Writer, entries: &[&Entry]) {
    let commented = entries.iter().filter(|entry| entry.comment.is_some());
    let lengths = commented.map(|entry| out.indent() + entry.length());
    let column = column_of(lengths.filter(|length| *length <= FURTHEST_COLUMN).max().unwrap_or(0));
    let outer = out.origin(Origin::Chart);
    // How many neighbours are alike but have a line each.
    let mut alone = 0;
    let mut place = 0;
    while let Some(entry) = entries.get(place) {
        place += 1;
        out.origin(entry.origin);
        let length = out.indent() + entry.length();
        if let Some(comment) = &entry.comment {
            if !out.fits_behind(length.max(column), comment) {
                out.comment(comment);
                out.start();
                entry.pieces().for_each(|piece| out.text(piece));
                out.end();
                continue;
            }
            out.start();
            entry.pieces().for_each(|piece| out.text(piece));
            out.trailing_comment(length, column, comment);
            out.end();
            continue;
        }
        // Plain neighbours of one type share a line if all of them fit; else each has its own, so that one more does not
        // move all others.
        out.start();
        out.text(&entry.name);
        if alone == 0 {
            let alike = entries[place..].iter().take_while(|next| next.is_plain() && next.ty == entry.ty);
            let alike = if entry.is_plain() { alike.count() } else { 0 };
            let names = entries[place..place + alike].iter().map(|next| 2 + next.name.len()).sum::<usize>();
            if length + names <= out.width() {
                for next in &entries[place..place + alike] {
                    out.text(", ");
                    out.text(&next.name);
                    out.also(next.origin);
                }
                place += alike;
            } else {
                alone = alike;
            }
        } else {
            alone -= 1;
        }
        entry.pieces().skip(1).for_each(|piece| out.text(piece));
        out.end();
    }
    out.origin(outer);
}
