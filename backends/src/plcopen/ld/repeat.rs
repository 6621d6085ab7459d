//! The stability loop around the rungs (R9).
//!
//! ```text
//! Gate_rungs   one micro-step as a ladder: inputs and outputs as the chart has them, and
//!                  further   input: this is not the first micro-step of the call
//!                  again     output: another micro-step is needed
//! Gate         REPEAT
//!                  rungs(open := open, closed := closed, further := further);
//!                  further := rungs.again;
//!              UNTIL NOT further
//!              END_REPEAT;
//! ```
//!
//! What a call does once before its micro-steps is behind a contact `/further`, and so is what inputs ask for; but timers are called there in each
//! micro-step, as they were at the end of the one before, which makes no difference. Outputs are computed after each
//! micro-step, which makes no difference, since nothing reads them and the last one is what remains; except where a
//! division may raise DIV0, which only the last may do.

use super::circuit::Ladder;
use super::local;
use super::rung::{Contact, Item};
use crate::iec::declarations::{EntryType, VarBlock, VarKind};
use crate::iec::frame;
use crate::iec::names::Names;
use crate::st;
use crate::writer::{self, Writer};
use ecow::EcoString;
use grafc_formula::{Formula, Type};
use grafc_logic::scan::{Program, Repeat, Statement, VarId, is_empty};

/// Whether a statement brings a timer up to date.
pub(super) fn is_call(statement: &Statement) -> bool {
    matches!(statement, Statement::CallTimer { .. })
}

/// The names and the bound of a loop.
pub(super) struct Repeated {
    /// The function block that holds the rungs, and the instance of it.
    pub block: EcoString,
    pub instance: EcoString,
    again: EcoString,
    further: EcoString,
    /// Whether the rungs ask for it.
    asks_further: bool,
    /// What says that there will be no micro-step after this, if the rungs ask for it.
    last: Option<EcoString>,
    /// Whether the outputs wait for the last micro-step.
    waits: bool,
    limit: Option<Limit>,
}

/// The bound, and who knows when it is hit.
struct Limit {
    bound: u32,
    count: EcoString,
    ty: Type,
    flag: EcoString,
    raises: VarId,
}

impl Repeated {
    /// Names what a loop needs.
    pub fn new(program: &Program, names: &mut Names, repeat: Repeat) -> Self {
        let name = |id: VarId| names.variables[id].clone();
        let again = name(repeat.again);
        let limit = repeat.limit.map(|limit| Limit {
            bound: limit.bound,
            count: name(limit.count),
            ty: program.variables[limit.count].ty,
            flag: name(limit.flag),
            raises: limit.flag,
        });
        let waits = program.after.iter().any(|statement| matches!(statement, Statement::Divide(_)));
        Repeated {
            block: names.namer.unit(&format!("{}_rungs", names.block)),
            instance: names.namer.name("rungs"),
            again,
            further: names.namer.name("further"),
            asks_further: !program.before.iter().all(is_call) || !program.asked_and_reaction().0.is_empty(),
            last: limit.as_ref().filter(|_| waits).map(|_| names.namer.name("last")),
            waits,
            limit,
        }
    }

    /// What inputs ask for that is the rungs' to do: all but to lower the flag, which only the loop has.
    pub fn asked_of_rungs(&self, asked: &[Statement]) -> Vec<Statement> {
        let flag = self.limit.as_ref().map(|limit| limit.raises);
        let mut asked = asked.to_vec();
        for statement in &mut asked {
            if let Statement::If(choice) = statement {
                choice.branches.iter_mut().for_each(|(_, body)| body.retain(|inner| !writes(inner, flag)));
            }
        }
        let is_empty_choice =
            |statement: &Statement| matches!(statement, Statement::If(_)) && statement.bodies().all(is_empty);
        asked.retain(|statement| !is_empty_choice(statement));
        asked
    }

    /// Closed in the first micro-step of a call, where something waits for it.
    pub fn at_first(&self) -> Option<Contact> {
        self.asks_further.then(|| Contact { name: self.further.clone(), negated: true })
    }

    /// Closed in the last micro-step of a call, where something waits for it.
    pub fn at_last(&self, ladder: &mut Ladder) -> Option<Contact> {
        let stable = Contact { name: self.again.clone(), negated: true };
        match &self.last {
            _ if !self.waits => None,
            None => Some(stable),
            Some(last) => {
                let last = Contact { name: last.clone(), negated: false };
                Some(ladder.aside(vec![Item::Group(vec![vec![stable], vec![last]])]))
            }
        }
    }

    /// The variables of the rungs, from those of the chart.
    pub fn inner(&self, mut blocks: Vec<VarBlock>) -> Vec<VarBlock> {
        let limit = self.limit.as_ref();
        let flag = limit.map(|limit| limit.flag.as_str());
        let count = limit.map(|limit| limit.count.as_str());
        let bit = || EntryType::Elementary(Type::Bool);
        for block in &mut blocks {
            block.retain(|name| Some(name) != flag && Some(name) != count && name != self.again);
            let more = match block.kind {
                VarKind::Input => {
                    let further = self.asks_further.then(|| local(&self.further, bit(), "not the first micro-step"));
                    let last = self.last.as_ref().map(|name| local(name, bit(), "no other micro-step comes"));
                    further.into_iter().chain(last).collect()
                }
                VarKind::Output => vec![local(&self.again, bit(), "another micro-step is needed")],
                VarKind::Constant | VarKind::Local | VarKind::Temporary => Vec::new(),
            };
            block.sections.push(("".into(), more));
        }
        blocks
    }

    /// The variables of the chart's function block, from those of the chart.
    pub fn outer(&self, blocks: Vec<VarBlock>) -> Vec<VarBlock> {
        let bit = || EntryType::Elementary(Type::Bool);
        let mut own = vec![
            local(&self.instance, EntryType::Block(self.block.clone().into()), "one micro-step"),
            local(&self.further, bit(), "another micro-step is needed"),
        ];
        own.extend(self.last.as_ref().map(|name| local(name, bit(), "no other micro-step comes")));
        if let Some(limit) = &self.limit {
            own.push(local(&limit.count, EntryType::Elementary(limit.ty), "micro-steps of this call"));
        }
        let mut outer: Vec<VarBlock> =
            blocks.into_iter().filter(|block| matches!(block.kind, VarKind::Input | VarKind::Output)).collect();
        outer.push(VarBlock { kind: VarKind::Local, sections: vec![("".into(), own)] });
        outer
    }

    /// The statements of the chart's function block.
    pub fn body(&self, program: &Program, names: &Names) -> String {
        let mut out = Writer::new(&writer::IEC);
        let (mut inputs, mut published) = frame::wired(program, names);
        inputs.extend(self.asks_further.then_some(self.further.as_str()));
        inputs.extend(self.last.as_deref());
        let flag = self.limit.as_ref().map(|limit| limit.flag.as_str());
        published.retain(|name| Some(*name) != flag);
        for statement in program.asked_and_reaction().0 {
            if let Statement::If(choice) = statement
                && let Some(limit) = &self.limit
                && let [(when, body)] = choice.branches.as_slice()
                && let Formula::Variable(input) = program.pool.get(*when)
                && body.iter().any(|inner| writes(inner, Some(limit.raises)))
            {
                out.open(&format!("IF {} THEN", names.variables[*input]));
                out.line(&format!("{} := FALSE;", limit.flag));
                out.close("END_IF;");
            }
        }
        out.line(&format!("{} := FALSE;", self.further));
        if let Some(limit) = &self.limit {
            out.line(&format!("{} := 0;", limit.count));
        }
        out.open("REPEAT");
        if let Some(limit) = &self.limit {
            out.line(&format!("{0} := {0} + 1;", limit.count));
            if let Some(last) = &self.last {
                out.line(&format!("{last} := ({} >= {});", limit.count, limit.bound));
            }
        }
        st::call::write(&mut out, &self.instance, &inputs, &published);
        out.line(&format!("{} := {}.{};", self.further, self.instance, self.again));
        out.leave();
        out.line(&match &self.limit {
            Some(limit) => format!("UNTIL NOT {} OR ({} >= {})", self.further, limit.count, limit.bound),
            None => format!("UNTIL NOT {}", self.further),
        });
        out.line("END_REPEAT;");
        if let Some(flag) = flag {
            out.open(&format!("IF {} THEN", self.further));
            out.line(&format!("{flag} := TRUE;"));
            out.close("END_IF;");
        }
        out.finish()
    }
}

/// Whether a statement writes a variable itself.
fn writes(statement: &Statement, variable: Option<VarId>) -> bool {
    matches!(statement, Statement::Assign { target, .. } if Some(*target) == variable)
}
