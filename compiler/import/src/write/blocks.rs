//! Function blocks of the standard whose meaning charts have: edges, delays, counters, flip-flops.
//!
//! Their outputs are read under the name of the instance. An edge is put where its output is read; a delay becomes a
//! variable that is true while the delay has passed; counters and flip-flops become variables and assignments. A block
//! keeps its state while nobody calls it, where a chart's delays and edges go on; the report says so.

use super::maker::{Action, Maker, Scope};
use super::outcome::Effects;
use super::resolve::{Environment, Loss, Site};
use super::terms::{Amount, TermId, TermKind, VarId};
use crate::code::tree::{Argument, ExprId, ExprKind};
use crate::{doubtful, lost};
use grafc_diagnostics::Span;
use grafc_syntax::ast::Type;

/// A block that is known.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Standard {
    Rise,
    Fall,
    OnDelay,
    OffDelay,
    CountUp,
    CountDown,
    /// Set first, and reset first.
    SetReset,
    ResetSet,
}

/// A call of a block.
pub struct BlockUse<'c> {
    pub block: Standard,
    pub site: &'c Site,
    /// The condition under which it is done.
    pub here: TermId,
    pub name: &'c str,
    pub arguments: &'c [Argument],
    pub span: Span,
}

/// The block of a type.
fn standard(ty: &str) -> Option<Standard> {
    Some(match ty.to_ascii_uppercase().as_str() {
        "R_TRIG" => Standard::Rise,
        "F_TRIG" => Standard::Fall,
        "TON" => Standard::OnDelay,
        "TOF" => Standard::OffDelay,
        "CTU" => Standard::CountUp,
        "CTD" => Standard::CountDown,
        "SR" => Standard::SetReset,
        "RS" => Standard::ResetSet,
        _ => return None,
    })
}

/// Blocks that nobody can ask more about than that they are there.
const OTHERS: [&str; 4] = ["TP", "CTUD", "SEMA", "RTC"];

impl Maker<'_> {
    /// The block of an instance.
    pub fn standard_block(&self, scope: &Scope, instance: &str) -> Option<Standard> {
        let unit = self.unit(scope);
        let ty = unit.variables.find(instance);
        standard(&ty?.ty)
    }

    /// What an output of a block is; none if the path is no such output.
    pub fn block_output(&mut self, path: &str, span: Span, site: &Site) -> Result<Option<TermId>, Loss> {
        let Some((instance, pin)) = path.rsplit_once('.') else { return Ok(None) };
        let Some(variable) = self.unit(&site.scope).variables.find(instance) else {
            return Ok(None);
        };
        let Some(block) = standard(&variable.ty) else {
            if OTHERS.contains(&variable.ty.to_ascii_uppercase().as_str()) {
                let why = format!("`{instance}` is a block of the type `{}`, which charts do not have", variable.ty);
                return Err(Loss { why, span });
            }
            return Ok(None);
        };
        let key = format!("{}{instance}", site.scope.prefix);
        let pin = pin.to_ascii_uppercase();
        let why = || format!("charts do not know the output `{path}`");
        match (block, pin.as_str()) {
            (Standard::Rise | Standard::Fall, "Q") => self.edge(block, &key, instance, span).map(Some),
            (Standard::OnDelay | Standard::OffDelay, "Q") => {
                let lower = key.to_lowercase();
                if self.delays_called.contains(&lower) {
                    self.read_behind.entry(lower).or_insert(span);
                }
                let id = self.variables.helper(&format!("{key}.Q"), Type::Bool, variable.span);
                Ok(Some(self.read(id, span)))
            }
            (Standard::CountUp | Standard::CountDown, "CV") => {
                let id = self.counter(&key, variable.span);
                Ok(Some(self.read(id, span)))
            }
            (Standard::CountUp | Standard::CountDown, "Q") => {
                let id = self.counter(&key, variable.span);
                let value = self.read(id, span);
                let sign = if block == Standard::CountUp { " >= " } else { " <= " };
                let limit = if block == Standard::CountUp {
                    self.preset(&key, "PV", Type::Int, span)?
                } else {
                    self.terms.add(TermKind::Integer(0), Some(Type::Int), span)
                };
                Ok(Some(self.terms.logic(TermKind::Pair(sign, value, limit), span)))
            }
            (Standard::SetReset | Standard::ResetSet, "Q1") => {
                let id = self.variables.helper(&format!("{key}.Q1"), Type::Bool, variable.span);
                Ok(Some(self.read(id, span)))
            }
            _ => Err(Loss { why: why(), span }),
        }
    }

    fn read(&mut self, id: VarId, span: Span) -> TermId {
        self.variables.list[id].used.read = true;
        let ty = self.variables.list[id].ty;
        self.terms.add(TermKind::Variable(id), Some(ty), span)
    }

    fn counter(&mut self, key: &str, span: Span) -> VarId {
        self.variables.helper(&format!("{key}.CV"), Type::Int, span)
    }

    /// An argument of the call of a block, and where its names are looked up.
    fn argument(&self, key: &str, pin: &str) -> Option<(ExprId, Scope)> {
        let call = self.calls.get(&key.to_lowercase())?;
        let named =
            call.arguments.iter().find(|a| a.name.as_deref().is_some_and(|name| name.eq_ignore_ascii_case(pin)));
        Some((named?.value, call.scope.clone()))
    }

    fn preset(&mut self, key: &str, pin: &str, ty: Type, span: Span) -> Result<TermId, Loss> {
        let Some((id, scope)) = self.argument(key, pin) else {
            return Err(Loss { why: format!("nobody gives `{key}` its `{pin}`"), span });
        };
        let site = Site { scope, part: 0, own: None };
        let cases = self.value(id, ty, &site, &Environment::default())?;
        cases.first().map(|(_, value)| *value).ok_or_else(|| Loss { why: format!("`{pin}` has no value"), span })
    }

    /// The edge that a block finds, while it is called.
    fn edge(&mut self, block: Standard, key: &str, instance: &str, span: Span) -> Result<TermId, Loss> {
        if self.depth >= 4 {
            return Err(Loss { why: "edges of edges of edges".into(), span });
        }
        let Some((clock, scope)) = self.argument(key, "CLK") else {
            return Err(Loss { why: format!("nothing calls `{instance}`"), span });
        };
        self.depth += 1;
        let operand = self.condition(clock, &Site { scope, part: 0, own: None }, &Environment::default());
        self.depth -= 1;
        let operand = operand?;
        if self.has(operand, |kind| matches!(kind, TermKind::Rise(_) | TermKind::Fall(_) | TermKind::Delay { .. })) {
            return Err(Loss { why: "charts have no edge of what holds an edge or a delay".into(), span });
        }
        if self.once(format!("edge {key}")) {
            self.edges.push((format!("{instance}.Q"), span));
        }
        let kind = if block == Standard::Rise { TermKind::Rise(operand) } else { TermKind::Fall(operand) };
        Ok(self.terms.logic(kind, span))
    }

    /// Says which blocks became edges.
    pub fn tell_edges(&mut self) {
        let edges = std::mem::take(&mut self.edges);
        let Some((_, first)) = edges.first() else { return };
        let names: Vec<String> = edges.iter().map(|(name, _)| format!("`{name}`")).collect();
        let message = match &names[..] {
            [name] => format!("{name} is written as the edge of its operand"),
            _ => format!("{} are written as edges of their operands", names.join(", ")),
        };
        let note =
            "a block sees an edge in the first call after it, and takes a true operand in its first call for one";
        let chart = "a chart sees it in the scan in which it is, and none at the start";
        self.diagnostics.push(doubtful(*first, message).note(note).note(chart));
    }

    /// What a call does at each scan: counters and flip-flops; edges and delays need nothing.
    pub fn step_block(&mut self, usage: &BlockUse, effects: &mut Effects) -> Result<(), Loss> {
        let &BlockUse { block, site, here, name, arguments, span } = usage;
        let key = format!("{}{name}", site.scope.prefix);
        let pin = |maker: &mut Self, wanted: &str| {
            let named =
                arguments.iter().find(|a| a.name.as_deref().is_some_and(|name| name.eq_ignore_ascii_case(wanted)));
            match named {
                Some(argument) => maker.condition(argument.value, site, &effects.environment),
                None => Ok(maker.terms.constant(false, span)),
            }
        };
        match block {
            Standard::Rise | Standard::Fall => Ok(()),
            Standard::OnDelay | Standard::OffDelay => {
                self.delays_called.insert(key.to_lowercase());
                Ok(())
            }
            Standard::CountUp | Standard::CountDown => {
                let up = block == Standard::CountUp;
                let count = pin(self, if up { "CU" } else { "CD" })?;
                let reset = pin(self, if up { "R" } else { "LD" })?;
                if self
                    .has(count, |kind| matches!(kind, TermKind::Rise(_) | TermKind::Fall(_) | TermKind::Delay { .. }))
                {
                    return Err(Loss { why: "charts have no edge of what holds an edge".into(), span });
                }
                let id = self.counter(&key, span);
                let value = self.terms.add(TermKind::Variable(id), Some(Type::Int), span);
                let one = self.terms.add(TermKind::Integer(1), Some(Type::Int), span);
                let (next, most, fresh) = if up {
                    let most = self.preset(&key, "PV", Type::Int, span).ok();
                    let next = self.terms.add(TermKind::Pair(" + ", value, one), Some(Type::Int), span);
                    (next, most.map(|most| (" < ", most)), self.terms.add(TermKind::Integer(0), Some(Type::Int), span))
                } else {
                    let zero = self.terms.add(TermKind::Integer(0), Some(Type::Int), span);
                    let next = self.terms.add(TermKind::Pair(" - ", value, one), Some(Type::Int), span);
                    (next, Some((" > ", zero)), self.preset(&key, "PV", Type::Int, span)?)
                };
                let edge = self.terms.logic(TermKind::Rise(count), span);
                let not = self.terms.not(reset);
                let mut counted = self.terms.and(not, edge);
                if let Some((sign, limit)) = most {
                    let below = self.terms.logic(TermKind::Pair(sign, value, limit), span);
                    counted = self.terms.and(counted, below);
                }
                let (counted, reset) = (self.terms.and(here, counted), self.terms.and(here, reset));
                self.variables.list[id].used.read = true;
                let next = self.certain(next);
                self.set(id, counted, next, effects);
                if !self.terms.is(reset, false) {
                    let fresh = self.certain(fresh);
                    self.set(id, reset, fresh, effects);
                }
                Ok(())
            }
            Standard::SetReset | Standard::ResetSet => {
                let set_first = block == Standard::SetReset;
                let set = pin(self, if set_first { "S1" } else { "S" })?;
                let reset = pin(self, if set_first { "R" } else { "R1" })?;
                let id = self.variables.helper(&format!("{key}.Q1"), Type::Bool, span);
                let (first, second) = if set_first { (set, reset) } else { (reset, set) };
                let not = self.terms.not(first);
                let second = self.terms.and(not, second);
                for (guard, value) in [(second, !set_first), (first, set_first)] {
                    let guard = self.terms.and(here, guard);
                    let value = self.terms.constant(value, span);
                    let value = self.certain(value);
                    if !self.terms.is(guard, false) {
                        self.set(id, guard, value, effects);
                    }
                }
                Ok(())
            }
        }
    }

    /// Writes the delays whose outputs are read.
    pub fn delays(&mut self) {
        let mut calls: Vec<(String, Span)> = self.calls.iter().map(|(key, call)| (key.clone(), call.span)).collect();
        calls.sort_by(|a, b| (a.1.start, &a.0).cmp(&(b.1.start, &b.0)));
        // One delay may wait for another that nobody else reads.
        let mut done = 0;
        while let Some(place) = calls[done..].iter().position(|(key, _)| self.is_read_delay(key)) {
            calls.swap(done, done + place);
            let (key, span) = calls[done].clone();
            done += 1;
            if let Err(loss) = self.delay(&key, span) {
                let message = format!("the delay of `{key}` is lost: {}", loss.why);
                self.diagnostics.push(lost(loss.span, message).note(format!("`{key}.Q` is an input in its place")));
            }
        }
    }

    fn is_read_delay(&self, key: &str) -> bool {
        self.variables.find(&format!("{key}.Q")).is_some_and(|id| self.variables.list[id].used.read)
    }

    fn delay(&mut self, key: &str, span: Span) -> Result<(), Loss> {
        let Some(id) = self.variables.find(&format!("{key}.Q")) else { return Ok(()) };
        let Some(call) = self.calls.get(key) else { return Ok(()) };
        let scope = call.scope.clone();
        let called = if call.always { Vec::new() } else { call.while_true.clone() };
        let instance = key.rsplit('.').next().unwrap_or(key).to_string();
        let block = self.standard_block(&scope, &instance);
        let site = Site { scope, part: 0, own: None };
        let Some((input, _)) = self.argument(key, "IN") else {
            return Err(Loss { why: "nobody gives it its `IN`".into(), span });
        };
        let Some((time, _)) = self.argument(key, "PT") else {
            return Err(Loss { why: "nobody gives it its `PT`".into(), span });
        };
        let operand = self.condition(input, &site, &Environment::default())?;
        if self.has(operand, |kind| matches!(kind, TermKind::Rise(_) | TermKind::Fall(_) | TermKind::Delay { .. })) {
            return Err(Loss { why: "charts have no delay of an edge".into(), span });
        }
        let amount = self.amount(time, &site)?;
        if let Some(span) = self.read_behind.get(key).copied()
            && !self.is_of_inputs(operand)
        {
            let message =
                format!("`{instance}.Q` is taken here as it was in the scan before, since steps make its input");
            self.diagnostics.push(
                doubtful(span, message)
                    .note("in the file the timer is called first, and what stands behind takes what it gives then")
                    .note("a delay of a chart begins in the scan after the one that makes its operand true"),
            );
        }
        let always = called.is_empty();
        let operand = if always {
            operand
        } else {
            let any = self.terms.any(called, span);
            // `T1(IN := S.X)` says it already.
            if self.terms.terms[any].kind == self.terms.terms[operand].kind {
                operand
            } else {
                self.terms.and(any, operand)
            }
        };
        if self.once(format!("delay {key}")) && !always {
            let message = format!("the time of `{instance}` runs while its step is active and its input is true");
            self.diagnostics.push(
                doubtful(span, message)
                    .note("a timer that nobody calls any more keeps its output and goes on from its old start"),
            );
        }
        let delay = match block {
            Some(Standard::OffDelay) => TermKind::Delay { on: None, operand, off: Some(amount) },
            _ => TermKind::Delay { on: Some(amount), operand, off: None },
        };
        let condition = Some(self.terms.logic(delay, span));
        self.variables.list[id].used.by_name = true;
        self.always.push(Action::Continuous { variable: id, condition });
        Ok(())
    }

    /// The time of a delay: a constant, or a variable that nothing sets.
    pub fn amount(&mut self, id: ExprId, site: &Site) -> Result<Amount, Loss> {
        let span = self.project.code.exprs[id].span;
        let loss = || Loss { why: "its time is no constant".into(), span };
        match &self.project.code.exprs[id].kind {
            ExprKind::Duration(ms) => Ok(Amount::Ms(*ms)),
            _ => {
                let cases = self.value(id, Type::Time, site, &Environment::default())?;
                let [(_, value)] = cases.as_slice() else { return Err(loss()) };
                match self.terms.terms[*value].kind {
                    TermKind::Duration(ms) => Ok(Amount::Ms(ms)),
                    TermKind::Variable(variable) => {
                        let found = &mut self.variables.list[variable];
                        if found.initial.is_none() || found.used.stored {
                            return Err(loss());
                        }
                        found.used.delays = true;
                        Ok(Amount::Constant(variable))
                    }
                    _ => Err(loss()),
                }
            }
        }
    }
}
