//! Declarations: what a variable is to the chart, its first value, its address.
//!
//! What a unit calls local is an input here if nothing sets it, and an output if nothing reads it: in a whole project
//! somebody else does.

use super::maker::Maker;
use super::terms::VarId;
use super::variables::Var;
use crate::code::tree::ExprKind;
use crate::naming::clean;
use crate::sfc::Section;
use crate::{changed, doubtful, lost};
use grafc_syntax::ast::Type;
use rustc_hash::FxHashSet;

/// A declaration as it is written.
pub struct Declaration {
    pub keyword: &'static str,
    pub variable: VarId,
    pub initial: Option<String>,
    pub address: Option<String>,
    pub retain: bool,
}

impl Maker<'_> {
    /// The declarations of all variables that are used.
    pub fn declarations(&mut self) -> Vec<Declaration> {
        let mut found = Vec::new();
        let mut addresses: FxHashSet<String> = FxHashSet::default();
        for id in self.variables.list.indices() {
            let Some(mut keyword) = self.keyword(id) else { continue };
            let initial = self.initial(id);
            if keyword == "const" && initial.is_none() {
                keyword = "input";
            }
            let address = self.address(id, keyword, &mut addresses);
            let variable = &self.variables.list[id];
            let retain = variable.retain && variable.used.stored && matches!(keyword, "var" | "output");
            found.push(Declaration { keyword, variable: id, initial, address, retain });
        }
        self.unused();
        // As the file declares them; what nobody declares comes behind.
        let variables = &self.variables.list;
        let place = |id: VarId| (variables[id].section.is_none(), variables[id].span.start);
        found.sort_by_key(|declaration| place(declaration.variable));
        found
    }

    fn keyword(&mut self, id: VarId) -> Option<&'static str> {
        let variable = &self.variables.list[id];
        let used = variable.used;
        let is_set = used.by_name || used.stored;
        let (path, span) = (variable.path.clone(), variable.span);
        let has_value = variable.initial.is_some();
        let at_input = variable.address.as_deref().is_some_and(|address| address[1..].starts_with(['I', 'i']));
        let at_output = variable.address.as_deref().is_some_and(|address| address[1..].starts_with(['Q', 'q']));
        if used.delays && !is_set {
            return Some("const");
        }
        Some(match variable.section {
            _ if used.helper && is_set => "var",
            _ if used.helper && used.read => {
                let message = format!("`{path}` is an input now, because what sets it could not be said");
                self.diagnostics.push(lost(span, message));
                "input"
            }
            _ if used.helper => return None,
            _ if variable.constant && !is_set => {
                if has_value {
                    "const"
                } else {
                    "input"
                }
            }
            Some(Section::Input) if is_set => {
                let message = format!("`{path}` is an input, and actions set it");
                self.diagnostics.push(doubtful(span, message).note("it is a `var` now"));
                "var"
            }
            Some(Section::Input) => "input",
            _ if is_set && at_input => {
                let message = format!("`{path}` lies at an input of the controller, and actions set it");
                self.diagnostics.push(doubtful(span, message).note("it is a `var` now, without its address"));
                "var"
            }
            Some(Section::Output | Section::InOut | Section::External | Section::Global) if is_set => "output",
            _ if is_set && at_output => "output",
            None if is_set => "output",
            Some(Section::Local) if is_set && !used.read => {
                self.diagnostics.push(changed(span, format!("`{path}` is an output now, since no condition reads it")));
                "output"
            }
            Some(Section::Local) if is_set => "var",
            // From here on nothing sets it.
            Some(Section::Output) if !used.read => "output",
            Some(Section::Local) if has_value && variable.ty != Type::Bool && !at_input => {
                let message = format!("`{path}` is a constant now: nothing in the chart sets it");
                self.diagnostics.push(doubtful(span, message).note("if somebody else sets it, make it an `input`"));
                "const"
            }
            Some(Section::External | Section::Global) => "input",
            Some(_) if at_input => "input",
            Some(_) => {
                let message = format!("`{path}` is an input now: nothing in the chart sets it");
                self.diagnostics.push(
                    doubtful(span, message).note("in the file it keeps its first value, unless somebody else sets it"),
                );
                "input"
            }
            None => {
                if !self.said.contains(&format!("input {}", path.to_lowercase())) {
                    let message = format!("`{path}` is declared nowhere in the file, and is an input now");
                    self.diagnostics.push(
                        doubtful(span, message).note(format!(
                            "as it is used, it is of type `{}`",
                            variable_type(&self.variables.list[id])
                        )),
                    );
                }
                "input"
            }
        })
    }

    fn initial(&mut self, id: VarId) -> Option<String> {
        let variable = &self.variables.list[id];
        let (ty, span, path) = (variable.ty, variable.span, variable.path.clone());
        let value = &self.project.code.exprs[variable.initial?].kind;
        let text = match (value, ty) {
            (ExprKind::Bool(true), Type::Bool) | (ExprKind::Integer(1), Type::Bool) => "true".to_string(),
            (ExprKind::Bool(false), Type::Bool) | (ExprKind::Integer(0), Type::Bool) => return None,
            (ExprKind::Integer(0), _) if !variable.constant && ty.is_whole() && !variable.used.delays => return None,
            (ExprKind::Integer(number), ty) if ty.is_whole() => number.to_string(),
            (ExprKind::Integer(number), Type::Real | Type::Lreal) => format!("{number}.0"),
            (ExprKind::Real(number), Type::Real | Type::Lreal) => number.clone(),
            (ExprKind::Duration(ms), Type::Time) => super::text::duration(*ms),
            (ExprKind::Path(name), ty) if ty.is_whole() && self.constants.contains_key(&name.to_lowercase()) => {
                self.constants[&name.to_lowercase()].to_string()
            }
            _ => {
                self.diagnostics
                    .push(lost(span, format!("the first value of `{path}` is lost: it is no literal of its type")));
                return None;
            }
        };
        Some(text)
    }

    fn address(&mut self, id: VarId, keyword: &str, taken: &mut FxHashSet<String>) -> Option<String> {
        let variable = &self.variables.list[id];
        let address = variable.address.clone()?.to_ascii_uppercase();
        let (span, path) = (variable.span, variable.path.clone());
        let size = match variable.ty {
            Type::Bool => 'X',
            Type::Int | Type::Uint => 'W',
            Type::Dint | Type::Udint | Type::Real | Type::Time => 'D',
            Type::Lreal => 'L',
        };
        let mut letters = address.chars().skip(1);
        let area = letters.next();
        let given = letters.next().filter(char::is_ascii_alphabetic);
        let numbers = address.trim_start_matches(|c: char| !c.is_ascii_digit());
        let numbers: Vec<Option<u32>> = numbers.split('.').map(|number| number.parse().ok()).collect();
        let areas: &[char] = match keyword {
            "input" => &['I', 'M'],
            "output" => &['Q', 'M'],
            "var" => &['M'],
            _ => &[],
        };
        let fits = area.is_some_and(|area| areas.contains(&area))
            && given.unwrap_or('X') == size
            && numbers.iter().all(Option::is_some)
            && (size != 'X' || numbers.len() < 2 || numbers.last().copied().flatten().is_some_and(|bit| bit < 8));
        let key = format!("{}{size}{numbers:?}", area.unwrap_or_default());
        let why = if !fits {
            "it does not fit what the variable is here"
        } else if !taken.insert(key) {
            "another variable has it"
        } else {
            return Some(address);
        };
        self.diagnostics.push(lost(span, format!("the address `{address}` of `{path}` is lost: {why}")));
        None
    }

    /// Says which variables of the unit the chart does not need.
    fn unused(&mut self) {
        let scope = self.parts[0].scope.clone();
        let unit = self.unit(&scope);
        let is_unused = |variable: &&crate::sfc::Variable| {
            super::variables::elementary(&variable.ty).is_some() && self.variables.find(&variable.name).is_none()
        };
        let unused: Vec<&crate::sfc::Variable> = unit.variables.iter().filter(is_unused).collect();
        let Some(first) = unused.first() else { return };
        let named: Vec<String> =
            unused.iter().take(10).map(|variable| format!("`{}`", clean(&variable.name))).collect();
        let more = if unused.len() > named.len() {
            format!(" and {} more", unused.len() - named.len())
        } else {
            String::new()
        };
        let what = if unused.len() == 1 { "a variable is" } else { "variables are" };
        let message = format!("{what} left out, because the chart uses none of them: {}{more}", named.join(", "));
        self.diagnostics.push(changed(
            first.span,
            message
                .replace("uses none of them", if unused.len() == 1 { "does not use it" } else { "uses none of them" }),
        ));
    }
}

fn variable_type(variable: &Var) -> &'static str {
    variable.ty.keyword()
}
