//! To which pin of a board each input and output goes: the file of pins says so, else the address of the variable.
//!
//! `%IX1.5` and `%QX13` are the pin 13, counted in bits; `%IW2` and `%ID2` are the analog input `A2`; `%QW9` and `%QD9` are
//! the pin 9, which must be one that can be dimmed.

use super::pins::{Pin, Pins};
use crate::s7::whole;
use ecow::EcoString;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_formula::Type;
use grafc_logic::scan::{Program, Role, VarId, Variable};
use rustc_hash::FxHashMap;

/// The highest number of a pin.
const HIGHEST: u32 = 255;

/// A variable, and where it goes.
pub(super) struct Wire {
    pub variable: VarId,
    pub pin: Pin,
}

/// All inputs and outputs with their pins, in order of declaration.
///
/// # Errors
/// What has none, what shares one, and what the file of pins says of nothing.
pub(super) fn wires(program: &Program, pins: &Pins) -> Result<Vec<Wire>, Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let mut given: FxHashMap<&str, &Pin> = pins.list.iter().map(|pin| (pin.variable.as_str(), pin)).collect();
    let mut taken: FxHashMap<EcoString, VarId> = FxHashMap::default();
    let mut wires: Vec<Wire> = Vec::new();
    let outside = |role: Role| matches!(role, Role::Input | Role::Output);
    for (id, variable) in program.variables.iter_enumerated().filter(|(_, variable)| outside(variable.role)) {
        let span = variable.span.unwrap_or_else(|| whole(program));
        let mut complain =
            |said: String, help: &str| diagnostics.push(Diagnostic::new(Code::E0507, span, said).help(help));
        let name = &variable.name;
        let given = given.remove(name.as_str()).cloned();
        if variable.ty == Type::Time {
            complain(format!("`{name}` is a time, which no pin has"), "make it a number");
            continue;
        }
        let pin = match given.map_or_else(|| of_address(variable), Ok) {
            Ok(pin) => pin,
            Err(said) => {
                let help = format!(
                    "give it an address, such as `at {}`, or a line `{name} = 2` in a file for `--pins`",
                    example(variable)
                );
                complain(format!("`{name}` {said}"), &help);
                continue;
            }
        };
        let analog = variable.ty != Type::Bool;
        if pin.pullup && (variable.role == Role::Output || analog) {
            complain(format!("`{name}` cannot be pulled up: it is no input of type `bool`"), "leave `pullup` out");
        }
        if pin.inverted && analog {
            complain(format!("`{name}` is a number, which cannot be inverted"), "leave `inverted` out");
        }
        if let Some(other) = taken.insert(pin.pin.as_str().into(), id) {
            let other = &program.variables[other].name;
            complain(format!("`{other}` and `{name}` are both at pin {}", pin.pin), "give one of them another pin");
        }
        wires.push(Wire { variable: id, pin });
    }
    for pin in pins.list.iter().filter(|pin| given.contains_key(pin.variable.as_str())) {
        let said = format!("`{}` has a pin and is neither an input nor an output of the chart", pin.variable);
        diagnostics
            .push(Diagnostic::new(Code::E0507, whole(program), said).help("correct the name in the file of `--pins`"));
    }
    if diagnostics.has_errors() { Err(diagnostics) } else { Ok(wires) }
}

/// The pin that an address stands for; else what is wrong.
fn of_address(variable: &Variable) -> Result<Pin, String> {
    let Some(address) = variable.address.as_deref() else { return Err("has no pin".to_owned()) };
    let other = || format!("is at `{address}`, which is no pin");
    let Some((area, rest)) = address.strip_prefix('%').and_then(|rest| rest.split_at_checked(1)) else {
        return Err(other());
    };
    let numbers = rest.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let numbers: Option<Vec<u32>> = numbers.split('.').map(|number| number.parse().ok()).collect();
    let number = match numbers.as_deref() {
        Some([number]) => Some(*number),
        Some([byte, bit]) if variable.ty == Type::Bool => byte.checked_mul(8).and_then(|first| first.checked_add(*bit)),
        Some(_) | None => None,
    };
    let number = number.filter(|number| area != "M" && *number <= HIGHEST).ok_or_else(other)?;
    let analog = area == "I" && variable.ty != Type::Bool;
    let pin = if analog { format!("A{number}") } else { number.to_string() };
    Ok(Pin { variable: variable.name.to_string(), pin, pullup: false, inverted: false })
}

fn example(variable: &Variable) -> &'static str {
    let size = match variable.ty {
        Type::Bool => 'X',
        Type::Int | Type::Uint => 'W',
        Type::Dint | Type::Udint | Type::Real | Type::Time => 'D',
        Type::Lreal => 'L',
    };
    match (variable.role == Role::Output, size) {
        (false, 'X') => "%IX0.2",
        (false, 'W') => "%IW0",
        (false, 'D') => "%ID0",
        (false, _) => "%IL0",
        (true, 'X') => "%QX1.5",
        (true, 'W') => "%QW9",
        (true, 'D') => "%QD9",
        (true, _) => "%QL9",
    }
}
