//! Ladder diagrams in PLCopen XML: IEC 61131-3, edition 2, clause 4.2, rung by rung in the order in which they stand.
//!
//! Only ladders that are the chart's function block itself are run, and only those at whose pins there are constants,
//! variables and conversions of them.

use super::{Memory, Typed, converted, operated};
use crate::executors::function_block::FunctionBlock;
use crate::executors::jobs::Job;
use crate::plcopen_lint::document::{Document, Id};
use grafc_backends::plcopen::{Options, ld};
use grafc_backends::st;
use grafc_logic::scan::Program;
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Response;
use std::collections::BTreeMap;

/// Runs a job as a ladder; nothing if it is one that is not run here.
///
/// # Errors
/// What is no ladder, or does what cannot be done.
pub fn run(job: &Job) -> Result<Option<Vec<Response>>, String> {
    if job.program.repeat.is_some() {
        return Ok(None);
    }
    let emit = |program: &Program| st::emit(program, &st::Options::default());
    let block = FunctionBlock::new(0, job, emit, st::names)?;
    let project = ld::emit(&block.program, &Options::default()).map_err(|diagnostics| format!("{diagnostics:#?}"))?;
    let document = Document::read(&project)?;
    let body = document.all("LD").next().ok_or("no ladder")?;
    let texts = document.within(body).filter(|id| document.name(*id) == "expression");
    if texts.into_iter().any(|id| document.get(id).text.contains(' ')) {
        return Ok(None);
    }
    let mut memory = Memory::new(&block);
    // What only the ladder has: outputs of timers, parts of formulas.
    for id in document.all("variable").filter(|id| document.child(*id, "type").is_some()) {
        let ty = document.child(id, "type").and_then(|ty| document.get(ty).children.first());
        let initial = match ty.map(|ty| document.name(*ty)) {
            Some("BOOL") => (Type::Bool, Value::Bool(false)),
            Some("TIME") => (Type::Time, Value::Time(0)),
            _ => continue,
        };
        memory.variables.entry(document.attribute(id, "name").unwrap_or_default().to_owned()).or_insert(initial);
    }
    let called = memory.play(job, |memory| Call { document: &document, memory, given: BTreeMap::new() }.rungs(body));
    called.map(Some).map_err(|said| format!("{said} in\n{project}"))
}

/// One call: what each output gives, of an object and a pin.
struct Call<'d, 'm, 'b> {
    document: &'d Document,
    memory: &'m mut Memory<'b>,
    given: BTreeMap<(&'d str, &'d str), Typed>,
}

impl<'d> Call<'d, '_, '_> {
    fn rungs(mut self, body: Id) -> Result<(), String> {
        let document = self.document;
        for &id in &document.get(body).children {
            let number = document.attribute(id, "localId").unwrap_or_default();
            match document.name(id) {
                "comment" | "rightPowerRail" => {}
                "leftPowerRail" => self.give((number, ""), Value::Bool(true)),
                "inVariable" => {
                    let value = self.expression(self.text(id, "expression")?)?;
                    self.given.insert((number, ""), value);
                }
                "contact" => {
                    let closed =
                        self.bit(self.text(id, "variable")?)? != (document.attribute(id, "negated") == Some("true"));
                    let power = self.power(id)?.is_some_and(|power| power && closed);
                    self.give((number, ""), Value::Bool(power));
                }
                "coil" => {
                    let Some(power) = self.power(id)? else { continue };
                    let name = self.text(id, "variable")?;
                    match document.attribute(id, "storage") {
                        None => self.memory.store(name, Value::Bool(power))?,
                        Some("set") if power => self.memory.store(name, Value::Bool(true))?,
                        Some("reset") if power => self.memory.store(name, Value::Bool(false))?,
                        Some("set" | "reset") => {}
                        Some(other) => return Err(format!("a coil of the kind {other}")),
                    }
                    self.give((number, ""), Value::Bool(power));
                }
                "outVariable" => {
                    if let [Some((value, _))] = self.wired(id)[..] {
                        self.memory.store(self.text(id, "expression")?, value)?;
                    }
                }
                "block" => self.block(id, number)?,
                other => return Err(format!("{other} in a ladder")),
            }
        }
        Ok(())
    }

    fn give(&mut self, from: (&'d str, &'d str), value: Value) {
        let ty = matches!(value, Value::Bool(_)).then_some(Type::Bool);
        self.given.insert(from, (value, ty));
    }

    fn text(&self, id: Id, name: &str) -> Result<&'d str, String> {
        let text = self.document.child(id, name).ok_or_else(|| format!("{} without {name}", self.document.name(id)))?;
        Ok(self.document.get(text).text.as_str())
    }

    fn bit(&self, name: &str) -> Result<bool, String> {
        truth(self.memory.operand(name)?)
    }

    /// What comes to an input, wire by wire; nothing from a function that was not done.
    fn wired(&self, id: Id) -> Vec<Option<Typed>> {
        let inputs = self.document.children(id, "connectionPointIn");
        let wires = inputs.flat_map(|input| self.document.children(input, "connection"));
        let from = wires.map(|wire| {
            let named = |key| self.document.attribute(wire, key).unwrap_or_default();
            self.given.get(&(named("refLocalId"), named("formalParameter"))).copied()
        });
        from.collect()
    }

    /// Power from any of the wires.
    fn power(&self, id: Id) -> Result<Option<bool>, String> {
        let mut power = None;
        for value in self.wired(id).into_iter().flatten() {
            power = Some(truth(value)? || power == Some(true));
        }
        Ok(power)
    }

    /// A constant, a variable, or a conversion of one.
    fn expression(&self, text: &str) -> Result<Typed, String> {
        match text.strip_suffix(')').and_then(|text| text.split_once('(')) {
            Some((function, operand)) => converted(function, self.expression(operand)?),
            None => self.memory.operand(text),
        }
    }

    fn block(&mut self, id: Id, number: &'d str) -> Result<(), String> {
        let document = self.document;
        let list = document.child(id, "inputVariables").ok_or("a block without inputs")?;
        let mut inputs: BTreeMap<&str, Typed> = BTreeMap::new();
        for pin in document.children(list, "variable") {
            let name = document.attribute(pin, "formalParameter").unwrap_or_default();
            let value = match name {
                "EN" => self.power(pin)?.map(|power| (Value::Bool(power), Some(Type::Bool))),
                _ if self.wired(pin).len() > 1 => self.power(pin)?.map(|power| (Value::Bool(power), Some(Type::Bool))),
                _ => self.wired(pin).pop().flatten(),
            };
            inputs.insert(name, value.ok_or_else(|| format!("nothing at {name}"))?);
        }
        let kind = document.attribute(id, "typeName").unwrap_or_default();
        let input = |name: &str| inputs.get(name).copied().ok_or_else(|| format!("{kind} without {name}"));
        let enabled = inputs.get("EN").copied().map_or(Ok(true), truth)?;
        self.give((number, "ENO"), Value::Bool(enabled));
        if kind == "TON" {
            let name = document.attribute(id, "instanceName").ok_or("a timer without a name")?;
            if enabled {
                self.memory.call_timer(name, input("IN")?.0, input("PT")?.0)?;
            }
            // What it is not called for stays at its outputs.
            for (pin, first) in [("Q", Value::Bool(false)), ("ET", Value::Time(0))] {
                let known = self.memory.variables.get(&format!("{name}.{pin}")).map(|(_, value)| *value);
                self.give((number, pin), known.unwrap_or(first));
            }
        } else if enabled {
            let value = match kind {
                "MOVE" => input("IN")?,
                _ => operated(kind, input("IN1")?, input("IN2")?)?,
            };
            self.given.insert((number, "OUT"), value);
        }
        Ok(())
    }
}

fn truth((value, _): Typed) -> Result<bool, String> {
    match value {
        Value::Bool(truth) => Ok(truth),
        Value::Int(_) | Value::Real(_) | Value::Time(_) => Err(format!("{value:?} is no truth value")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::charts::check;
    use crate::runs::compile;
    use grafc_logic::Options;

    /// A ladder drawn by hand: `go` starts what runs until a timer of five seconds has run out.
    #[test]
    fn ladders_do_what_the_standard_says() {
        let text = "input go : bool\noutput run, late : bool\noutput n : int\ninitial step 1 { run late }\n";
        let program = compile(&check("chart", text).expect("a chart"), &Options::default()).expect("a scan program");
        let job = Job { program, stimuli: Vec::new() };
        let emit = |program: &Program| st::emit(program, &st::Options::default());
        let block = FunctionBlock::new(0, &job, emit, st::names).expect("a function block");
        let mut memory = Memory::new(&block);
        let document = Document::read(include_str!("../../plcopen/ladder.xml")).expect("XML");
        let body = document.all("LD").next().expect("a ladder");
        for (now, go, expected) in [
            (0, false, [false, false]),
            (10, true, [true, false]),
            (20, false, [true, false]),
            (5009, false, [true, false]),
            // It is late behind the rung that looks at it.
            (5010, false, [true, true]),
            (5020, false, [false, false]),
            (5030, false, [false, false]),
        ] {
            memory.now = now;
            memory.store("go", Value::Bool(go)).expect("an input");
            Call { document: &document, memory: &mut memory, given: BTreeMap::new() }.rungs(body).expect("a call");
            let actual = ["run", "late"].map(|name| memory.operand(name).map(|(value, _)| value));
            assert_eq!(actual, expected.map(|bit| Ok(Value::Bool(bit))), "at {now}");
        }
    }
}
