//! The values of attributes by their types in the meta-model; what is missing has its default.

use super::model::{Delay, ForcingOrderType, Sort, StoredActionType, TimeConditionType};
use crate::xml::Element;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use std::fmt::Display;

/// `xsi:type` without its prefix.
pub fn class(element: &Element) -> Option<&str> {
    let value = element.attribute("xsi:type")?;
    Some(value.rsplit_once(':').map_or(value, |(_, class)| class))
}

/// A value that its type does not have.
pub fn wrong(element: &Element, name: &str, expected: impl Display, diagnostics: &mut Diagnostics) {
    let value = element.attribute(name).unwrap_or_default();
    diagnostics.push(
        Diagnostic::new(Code::E0705, element.span, format!("`{name}` of `{}` is `{value}`", element.name))
            .note(format!("it is {expected}"))
            .help("correct the value in the tool that made the chart, or in the file"),
    );
}

/// `EInt`: 32 bits, 0 if missing.
pub fn integer(element: &Element, name: &str, diagnostics: &mut Diagnostics) -> i32 {
    match element.attribute(name).map(str::parse) {
        None => 0,
        Some(Ok(value)) => value,
        Some(Err(_)) => {
            wrong(element, name, "a whole number of 32 bits", diagnostics);
            0
        }
    }
}

/// `EBoolean`: false if missing.
pub fn boolean(element: &Element, name: &str, diagnostics: &mut Diagnostics) -> bool {
    match element.attribute(name) {
        None | Some("false") => false,
        Some("true") => true,
        Some(_) => {
            wrong(element, name, "`true` or `false`", diagnostics);
            false
        }
    }
}

/// One of an enumeration; the first if missing.
fn one_of<T: Copy>(element: &Element, name: &str, values: &[(&str, T)], diagnostics: &mut Diagnostics) -> T {
    let found = element.attribute(name).map(|value| values.iter().find(|(literal, _)| *literal == value));
    match found {
        None => values[0].1,
        Some(Some((_, value))) => *value,
        Some(None) => {
            let literals: Vec<String> = values.iter().map(|(literal, _)| format!("`{literal}`")).collect();
            wrong(element, name, format_args!("one of {}", literals.join(", ")), diagnostics);
            values[0].1
        }
    }
}

/// `forcingOrderType`.
pub fn forcing_order_type(element: &Element, diagnostics: &mut Diagnostics) -> ForcingOrderType {
    let values = [
        ("currentSituation", ForcingOrderType::Current),
        ("emptySituation", ForcingOrderType::Empty),
        ("initialSituation", ForcingOrderType::Initial),
        ("explicitSituation", ForcingOrderType::Explicit),
    ];
    one_of(element, "forcingOrderType", &values, diagnostics)
}

/// `storedActionType`.
pub fn stored_action_type(element: &Element, diagnostics: &mut Diagnostics) -> StoredActionType {
    let values = [
        ("activation", StoredActionType::Activation),
        ("deactivation", StoredActionType::Deactivation),
        ("event", StoredActionType::Event),
    ];
    one_of(element, "storedActionType", &values, diagnostics)
}

/// Whether `continuousActionType` says that there is a condition.
pub fn is_conditional(element: &Element, diagnostics: &mut Diagnostics) -> bool {
    one_of(element, "continuousActionType", &[("continuousAction", false), ("assignationCondition", true)], diagnostics)
}

/// What a declaration says it declares; the step of a step variable is another attribute.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Declares {
    Input,
    Output,
    Internal,
    Step,
}

/// `variableDeclarationType`.
pub fn variable_declaration_type(element: &Element, diagnostics: &mut Diagnostics) -> Declares {
    let values = [
        ("input", Declares::Input),
        ("output", Declares::Output),
        ("internal", Declares::Internal),
        ("step", Declares::Step),
    ];
    one_of(element, "variableDeclarationType", &values, diagnostics)
}

/// `timeConditionType`, `delayTime`, `resetTime`, `unit`.
pub fn time(element: &Element, diagnostics: &mut Diagnostics) -> (TimeConditionType, Delay, Delay) {
    let types = [
        ("none", TimeConditionType::None),
        ("timeDependent", TimeConditionType::Dependent),
        ("timeDelayed", TimeConditionType::Delayed),
        ("timeLimited", TimeConditionType::Limited),
    ];
    let time = one_of(element, "timeConditionType", &types, diagnostics);
    // A `second` is written `s`; both are there in files.
    let units = [("s", ("s", 1000)), ("ms", ("ms", 1)), ("second", ("s", 1000)), ("millisecond", ("ms", 1))];
    let (unit, milliseconds) = one_of(element, "unit", &units, diagnostics);
    let mut delay = |name| {
        let count = integer(element, name, diagnostics);
        if count < 0 || count.checked_mul(milliseconds).is_none() {
            wrong(element, name, "a time from 0 to 2147483647 ms", diagnostics);
        }
        Delay { count, unit }
    };
    (time, delay("delayTime"), delay("resetTime"))
}

/// The class of a sort.
pub fn sort(element: &Element, diagnostics: &mut Diagnostics) -> Sort {
    match class(element) {
        Some("Bool") => Sort::Bool,
        Some("Integer") => Sort::Integer,
        Some(_) | None => {
            wrong(element, "xsi:type", "`terms:Bool` or `terms:Integer`", diagnostics);
            Sort::Bool
        }
    }
}
