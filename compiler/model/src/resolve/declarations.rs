//! Variables: their types, and the values given to them.
//!
//! A value is a constant expression, and items have no order, so a constant may be used above its declaration. Values are
//! found in the order of dependence, with a stack of our own.

use super::addresses;
use super::comment;
use super::expressions::{Context, Need, Scratch, note_names};
use super::fold::{Constants, fold};
use super::parts::Parts;
use super::scope::{Reference, Scope};
use super::types;
use crate::chart::{Type, Variable, VariableId, VariableKind};
use crate::symbols::Symbols;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};
use grafc_syntax::ast;
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

/// The type of a variable whose type could not be read; nothing is said of how it is used (see [`Scope::is_typed`]).
const STAND_IN: Type = Type::Bool;

/// The variables as declared, all zero.
pub fn variables(parts: &Parts) -> IndexVec<VariableId, Variable> {
    let mut variables = IndexVec::with_capacity(parts.declarations.iter().map(|d| d.names.len()).sum());
    for declaration in &parts.declarations {
        for declared in &declaration.names {
            let (kind, ty) = (addresses::kind(declaration.kind), declaration.ty.unwrap_or(STAND_IN));
            variables.push(Variable {
                comment: comment(&declared.comment),
                retain: declaration.retain.is_some(),
                ..Variable::new(declared.name.text.clone(), kind, ty, types::zero(ty), declared.name.span)
            });
        }
    }
    variables
}

/// Evaluates all values of declarations into `variables`; gives back those of the constants that have one.
pub fn evaluate(
    tree: &ast::Exprs,
    parts: &Parts,
    scope: &Scope,
    variables: &mut IndexVec<VariableId, Variable>,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> Values {
    let mut owners = IndexVec::with_capacity(variables.len());
    for (index, declaration) in parts.declarations.iter().enumerate() {
        owners.extend(declaration.names.iter().map(|_| index));
    }
    let mut evaluation = Evaluation {
        tree,
        parts,
        scope,
        variables,
        owners,
        states: vec![State::Untouched; parts.declarations.len()],
        values: Values { constants: Constants::default(), complete: true },
        symbols,
        diagnostics,
    };
    for index in 0..parts.declarations.len() {
        evaluation.declaration(index);
    }
    evaluation.values
}

/// What the declarations came to.
pub struct Values {
    /// The values of the constants; none where it is faulty.
    pub constants: Constants,
    /// Whether no value is missing.
    pub complete: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Untouched,
    /// On the stack: who depends on it now depends on itself.
    Open,
    Done,
}

struct Evaluation<'e, 'a> {
    tree: &'a ast::Exprs,
    parts: &'e Parts<'a>,
    scope: &'e Scope<'a>,
    variables: &'e mut IndexVec<VariableId, Variable>,
    /// The declaration of each variable.
    owners: IndexVec<VariableId, usize>,
    states: Vec<State>,
    values: Values,
    symbols: &'e mut Symbols,
    diagnostics: &'e mut Diagnostics,
}

impl Evaluation<'_, '_> {
    /// Evaluates a declaration after all that it depends on.
    fn declaration(&mut self, root: usize) {
        if self.states[root] != State::Untouched {
            return;
        }
        if self.parts.declarations[root].initial.is_none() {
            self.states[root] = State::Done;
            return self.value(root);
        }
        self.states[root] = State::Open;
        let mut open = vec![(root, self.dependencies(root))];
        while let Some((index, dependencies)) = open.last_mut() {
            let index = *index;
            match dependencies.pop() {
                Some((next, _)) if self.states[next] == State::Untouched => {
                    self.states[next] = State::Open;
                    let dependencies = self.dependencies(next);
                    open.push((next, dependencies));
                }
                Some((next, place)) if self.states[next] == State::Open => {
                    let name = &self.parts.declarations[next].names[0].name;
                    let message = format!("the value of `{}` depends on itself", name.text);
                    self.diagnostics.push(
                        Diagnostic::new(Code::E0208, self.tree[place].span, message)
                            .also(name.span, "declared here")
                            .note("the value of a declaration is known before the chart runs")
                            .help("write it as a number"),
                    );
                    // Done without a value: what depends on it keeps silent.
                    self.values.complete = false;
                    self.states[next] = State::Done;
                    if let Some(initial) = self.parts.declarations[next].initial {
                        note_names(self.tree, self.scope, initial, self.symbols);
                    }
                }
                Some(_) => {}
                None => {
                    open.pop();
                    if self.states[index] == State::Open {
                        self.states[index] = State::Done;
                        self.value(index);
                    }
                }
            }
        }
    }

    /// The declarations of constants that the value of this one names, and where.
    fn dependencies(&self, index: usize) -> Vec<(usize, ast::ExprId)> {
        let mut found = Vec::new();
        let mut seen = FxHashSet::default();
        let mut open: Vec<ast::ExprId> = self.parts.declarations[index].initial.into_iter().collect();
        while let Some(id) = open.pop() {
            match &self.tree[id].kind {
                ast::ExprKind::Name(name) => {
                    if let Some(Reference::Variable(variable)) = self.scope.reference(name)
                        && self.variables[variable].kind == VariableKind::Constant
                        && seen.insert(variable)
                    {
                        found.push((self.owners[variable], id));
                    }
                }
                ast::ExprKind::Integer(_)
                | ast::ExprKind::Real(_)
                | ast::ExprKind::Duration(_)
                | ast::ExprKind::Bool(_)
                | ast::ExprKind::Error => {}
                ast::ExprKind::Paren(a)
                | ast::ExprKind::Predicate(a)
                | ast::ExprKind::Not(a)
                | ast::ExprKind::Negate(a)
                | ast::ExprKind::Rise(a)
                | ast::ExprKind::Fall(a) => open.push(*a),
                ast::ExprKind::Binary(_, a, b) => open.extend([*b, *a]),
                ast::ExprKind::Delay(parts) => open.extend(parts),
            }
        }
        found
    }

    /// Evaluates a declaration whose constants are known.
    fn value(&mut self, index: usize) {
        let declaration = self.parts.declarations[index];
        let is_constant = declaration.kind == ast::DeclarationKind::Constant;
        if declaration.initial.is_none() && !is_constant {
            return;
        }
        let ids = self.ids(index);
        let Some(ty) = declaration.ty else {
            // Reported by the parser: whatever the value is, it may be right.
            self.values.complete = false;
            if let Some(initial) = declaration.initial {
                note_names(self.tree, self.scope, initial, self.symbols);
            }
            return;
        };
        let Some(initial) = declaration.initial else {
            for id in ids {
                let variable = &self.variables[id];
                let message = format!("the constant `{}` has no value", variable.name);
                let diagnostic = Diagnostic::new(Code::E0211, variable.span, message);
                let zero = match ty {
                    Type::Bool => "false",
                    Type::Int | Type::Dint | Type::Uint | Type::Udint => "0",
                    Type::Real | Type::Lreal => "0.0",
                    Type::Time => "0s",
                };
                let fix = Fix::maybe(format!("give it the value `{zero}`"))
                    .replace(declaration.ty_span.behind(), format!(" := {zero}"));
                self.diagnostics.push(diagnostic.help(format!("give it one, such as `:= {zero}`")).fix(fix));
            }
            return;
        };
        let context = Context {
            tree: self.tree,
            scope: self.scope,
            variables: self.variables,
            constants: &self.values.constants,
            step: None,
        };
        let mut pool = IndexVec::new();
        let root = context.resolve(
            initial,
            Need::Value(ty),
            &mut pool,
            &mut Scratch::default(),
            self.symbols,
            self.diagnostics,
        );
        let value = root.and_then(|root| {
            let kinds = &*self.variables;
            match fold(&pool, root, &self.values.constants, |id| kinds[id].kind == VariableKind::Constant) {
                Ok(value) => value,
                Err(diagnostic) => {
                    self.diagnostics.push(*diagnostic);
                    None
                }
            }
        });
        let Some(value) = value else {
            self.values.complete = false;
            return;
        };
        for id in ids {
            self.variables[id].set_initial(value);
            if is_constant {
                self.values.constants.insert(id, value);
            }
        }
    }

    /// The variables of a declaration: its names have consecutive ids.
    fn ids(&self, index: usize) -> impl Iterator<Item = VariableId> + use<> {
        let first = self.owners.raw.partition_point(|&owner| owner < index);
        (first..first + self.parts.declarations[index].names.len()).map(VariableId::new)
    }
}

#[cfg(test)]
mod tests {
    use crate::chart::Value;
    use crate::checks::testing::{breaks, chart, passes};

    fn value(declaration: &str) -> Value {
        let chart = chart(&format!("{declaration} initial step 1"));
        chart.variables.last().expect("there is a declaration").initial()
    }

    #[test]
    fn values_are_folded() {
        assert_eq!(value("var v : int := 2 + 3 * 4"), Value::Int(14));
        assert_eq!(value("var v : int := -7 / 2"), Value::Int(-3));
        assert_eq!(value("var v : int := -7 mod 2"), Value::Int(-1));
        assert_eq!(value("var v : real := 1 / 4"), Value::Real(0.25));
        assert_eq!(value("var v : real := 0.1"), Value::Real(f64::from(0.1_f32)));
        assert_eq!(value("var v : lreal := 0.1"), Value::Real(0.1));
        assert_eq!(value("var v : time := 2 * 3s + 500ms"), Value::Time(6500));
        assert_eq!(value("var v : time := 3s / 2"), Value::Time(1500));
        assert_eq!(value("var v : bool := 1"), Value::Bool(true));
        assert_eq!(value("var v : bool := not true or [3 > 2]"), Value::Bool(true));
        assert_eq!(value("const N : int := 3 var v : lreal := N + 1"), Value::Real(4.0));
        assert_eq!(value("var v : int := -32768"), Value::Int(-32768));
        assert_eq!(value("var v : dint"), Value::Int(0));
    }

    #[test]
    fn constants_are_used_above_their_declaration() {
        assert_eq!(value("const B : int := A + 1 const A : int := 2 var v : int := B"), Value::Int(3));
    }

    #[test]
    fn what_is_not_constant() {
        breaks("E0208", "input n : int var v : int := n initial step 1");
        breaks("E0208", "var v : bool := X1 initial step 1");
        breaks("E0208", "var v : int := 1 / 0 initial step 1");
        breaks("E0208", "const A : int := A initial step 1");
        breaks("E0208", "const A : int := B const B : int := C const C : int := A initial step 1");
        breaks("E0211", "const A : int initial step 1");
    }

    #[test]
    fn a_faulty_constant_is_reported_once() {
        breaks("E0208", "const A : time := A initial step 1 transition 1 -> 1 : A/X1 and [T1 > 2 * A]");
        breaks("E0211", "const A : int const B : int := A + 1 initial step 1 transition 1 -> 1 : [B > A]");
    }

    #[test]
    fn values_that_do_not_fit() {
        breaks("E0210", "var v : int := 32768 initial step 1");
        breaks("E0210", "var v : uint := -1 initial step 1");
        breaks("E0210", "var v : int := 200 * 200 initial step 1");
        breaks("E0210", "const t : time := 20h var v : time := 100 * t initial step 1");
        passes("var a : int := -32768 var b : udint := 4294967295 var c : dint := 16#7FFFFFFF initial step 1");
    }
}
