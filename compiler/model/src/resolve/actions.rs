//! The interpretation: transition-conditions, actions and forcing orders, in source order.

use super::expressions::{self, Context, Need, Scratch};
use super::fold::Constants;
use super::habits::{self, Stray};
use super::parts::{Holder, Parts};
use super::scope::{Label, Reference, Scope, kind};
use super::types;
use crate::chart::{
    Continuous, Event, Expr, ExprId, ExprKind, GrafcetId, Mode, Node, Order, Pulse, Run, Situation, StepId, Stored,
    Tables, TransitionId, Type, Value, VariableId, VariableKind,
};
use crate::symbols::{Form, Role, Symbols, Wanted};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix, Span};
use grafc_syntax::ast;

/// Fills in conditions, actions and orders; gives back whether none had to be left out.
pub fn interpret<'a>(
    tree: &'a ast::Exprs,
    parts: &Parts<'a>,
    scope: &Scope<'a>,
    constants: &Constants,
    chart: &mut Tables,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> bool {
    let mut interpretation = Interpretation {
        tree,
        scope,
        constants,
        chart,
        symbols,
        diagnostics,
        scratch: Scratch::default(),
        step: None,
        complete: true,
    };
    for holder in &parts.holders {
        match *holder {
            Holder::Step(index) => {
                let part = &parts.steps[index as usize];
                interpretation.step = Some(&part.ast.label.text);
                let mut actions = part.ast.actions.iter();
                while let Some(action) = actions.next() {
                    if interpretation.stray_word(action, actions.as_slice().first(), &part.ast.label.text) {
                        actions.next();
                        continue;
                    }
                    match part.node {
                        Node::Step(step) => interpretation.action(step, action),
                        Node::Macro(_) => interpretation.action_on_macro_step(action),
                    }
                }
            }
            Holder::Transition(id) => interpretation.transition(id, parts.transitions[id].ast),
        }
    }
    let complete = interpretation.complete;
    // The stages after this one keep them.
    chart.continuous.shrink_to_fit();
    chart.stored.shrink_to_fit();
    set_modes(chart);
    complete
}

struct Interpretation<'i, 'a> {
    tree: &'a ast::Exprs,
    scope: &'i Scope<'a>,
    constants: &'i Constants,
    chart: &'i mut Tables,
    symbols: &'i mut Symbols,
    diagnostics: &'i mut Diagnostics,
    scratch: Scratch,
    /// The step whose actions are read, or the only one before the transition.
    step: Option<&'a str>,
    complete: bool,
}

impl<'a> Interpretation<'_, 'a> {
    fn transition(&mut self, id: TransitionId, transition: &'a ast::Transition) {
        self.step = match transition.from.as_slice() {
            [only] => Some(&only.text),
            _ => None,
        };
        let condition = self.expression(transition.condition, Need::Condition);
        self.chart.transitions[id].condition = condition;
        for assignment in transition.actions() {
            self.assignment(assignment, Event::Clearing(id), assignment.span);
        }
        for pulse in transition.pulses() {
            let own = self.chart.transitions[id].grafcet;
            if let Some(grafcet) = self.grafcet(&pulse.grafcet, Some(own)) {
                let event = Event::Clearing(id);
                self.chart.pulses.push(Pulse { kind: pulse.kind, event, grafcet, span: pulse.span });
            }
        }
    }

    /// The grafcet that a pulse order of a step is given to.
    fn commanded(&mut self, name: &ast::Name, step: StepId) -> Option<GrafcetId> {
        let own = self.chart.steps.get(step).map(|step| step.grafcet);
        self.grafcet(name, own)
    }

    /// A grafcet that the grafcet `own` commands.
    fn grafcet(&mut self, name: &ast::Name, own: Option<GrafcetId>) -> Option<GrafcetId> {
        let label = self.scope.label(&name.text);
        match label {
            Some(label) => self.symbols.used(name.span, label, Form::Name, Role::Commanded),
            None => self.symbols.missed(name.span, Wanted::Grafcet),
        }
        match label {
            Some(Label::Grafcet(id)) => Some(id),
            Some(Label::Step(_) | Label::Macro(_)) | None => {
                self.fault(self.scope.unknown_grafcet(&name.text, name.span, own));
                None
            }
        }
    }

    fn action(&mut self, step: StepId, action: &ast::Action) {
        match &action.kind {
            ast::ActionKind::Continuous { target, condition } => {
                let target = self.condition_target(target);
                let condition = condition.map(|condition| self.expression(condition, Need::Condition));
                if let Some(target) = target {
                    self.chart.continuous.push(Continuous { step, target, condition, span: action.span });
                }
            }
            ast::ActionKind::Stored { assignment, event } => {
                let event = match *event {
                    ast::Event::Activation => Event::Activation(step),
                    ast::Event::Deactivation => Event::Deactivation(step),
                    ast::Event::Event(condition) => Event::Event(step, self.expression(condition, Need::Condition)),
                    ast::Event::EachScan(condition) => {
                        let condition = condition.map(|condition| self.expression(condition, Need::Condition));
                        Event::EachScan(step, condition)
                    }
                };
                self.assignment(assignment, event, action.span);
            }
            ast::ActionKind::Pulse { kind, grafcet, event } => {
                let event = match *event {
                    ast::Event::Activation => Event::Activation(step),
                    ast::Event::Deactivation => Event::Deactivation(step),
                    ast::Event::Event(condition) => Event::Event(step, self.expression(condition, Need::Condition)),
                    // The grammar has no such order.
                    ast::Event::EachScan(_) => return,
                };
                if let Some(grafcet) = self.commanded(grafcet, step) {
                    self.chart.pulses.push(Pulse { kind: *kind, event, grafcet, span: action.span });
                }
            }
            ast::ActionKind::Run { grafcet } => {
                if let Some(grafcet) = self.commanded(grafcet, step) {
                    self.chart.runs.push(Run { step, grafcet, span: action.span });
                }
            }
            ast::ActionKind::Force { grafcet, situation } => {
                let forced = self.scope.label(&grafcet.text);
                let situation = self.situation(situation);
                match forced {
                    Some(label) => self.symbols.used(grafcet.span, label, Form::Name, Role::Forced),
                    None => self.symbols.missed(grafcet.span, Wanted::Grafcet),
                }
                match forced {
                    Some(Label::Grafcet(id)) => {
                        self.chart.orders.push(Order { step, grafcet: id, situation, span: action.span });
                    }
                    Some(Label::Step(_) | Label::Macro(_)) | None => {
                        let own = self.chart.steps.get(step).map(|step| step.grafcet);
                        self.fault(self.scope.unknown_grafcet(&grafcet.text, grafcet.span, own));
                    }
                }
            }
        }
    }

    /// `N fill`, `K when a`: a word of other languages, and what it was said of, are one mistake. Gives back whether they
    /// are.
    fn stray_word(&mut self, action: &ast::Action, next: Option<&ast::Action>, step: &str) -> bool {
        let ast::ActionKind::Continuous { target: name, condition: None } = &action.kind else { return false };
        let Some(next) = next else { return false };
        if name.quoted || self.scope.reference(&name.text).is_some() {
            return false;
        }
        let Some(stray) = habits::stray(&name.text, next, step) else { return false };
        self.symbols.missed(name.span, Wanted::Target);
        let diagnostic = Diagnostic::new(Code::E0201, name.span, format!("nothing is called `{}`", name.text));
        let whole = name.span.to(next.span);
        self.fault(match stray {
            Stray::If => diagnostic.help("write `if`").fix(Fix::maybe("write `if`").replace(name.span, "if")),
            Stray::Word(Some(right), words) => {
                diagnostic.help(words).fix(Fix::maybe(format!("write `{right}`")).replace(whole, right))
            }
            Stray::Word(None, words) => diagnostic.help(words),
        });
        if let ast::ActionKind::Continuous { target, .. } = &next.kind {
            match self.scope.reference(&target.text).map(Reference::entity) {
                Some((entity, form)) => self.symbols.used(target.span, entity, form, Role::Assigned),
                None => self.symbols.missed(target.span, Wanted::Target),
            }
        }
        true
    }

    /// A macro-step has no actions (E0307); what is in them is resolved all the same, and then forgotten.
    fn action_on_macro_step(&mut self, action: &ast::Action) {
        let before = (self.chart.continuous.len(), self.chart.stored.len(), self.chart.orders.len());
        let commands = (self.chart.pulses.len(), self.chart.runs.len());
        self.action(StepId::new(0), action);
        self.chart.pulses.truncate(commands.0);
        self.chart.runs.truncate(commands.1);
        self.chart.continuous.truncate(before.0);
        self.chart.stored.truncate(before.1);
        self.chart.orders.truncate(before.2);
    }

    fn assignment(&mut self, assignment: &ast::Assignment, event: Event, span: Span) {
        let Some(target) = self.target(&assignment.target).filter(|target| self.scope.is_typed(*target)) else {
            // Nothing is known of the type that the value is to have, so only its names are looked at.
            return expressions::note_names(self.tree, self.scope, assignment.value, self.symbols);
        };
        let value = self.expression(assignment.value, Need::Value(self.chart.variables[target].ty));
        self.chart.stored.push(Stored { event, target, value, span });
    }

    /// The steps of a forced situation, in order of declaration.
    fn situation(&mut self, situation: &ast::Situation) -> Situation {
        let names = match situation {
            ast::Situation::Current => return Situation::Current,
            ast::Situation::Initial => return Situation::Initial,
            ast::Situation::Steps(names) => names,
        };
        let mut steps = Vec::with_capacity(names.len());
        for name in names {
            let node = self.scope.node(&name.text);
            match node {
                Some(node) => self.symbols.used(name.span, node, Form::Name, Role::Forced),
                None => self.symbols.missed(name.span, Wanted::Step),
            }
            match node {
                Some(Node::Step(step)) => steps.push(step),
                Some(Node::Macro(_)) => {} // E0316
                None => self.fault(self.scope.unknown_step(&name.text, name.span)),
            }
        }
        steps.sort_unstable();
        steps.dedup(); // E0303
        Situation::Steps(steps)
    }

    /// A variable that conditions can be assigned to.
    fn condition_target(&mut self, name: &ast::Name) -> Option<VariableId> {
        let target = self.target(name).filter(|target| self.scope.is_typed(*target))?;
        let variable = &self.chart.variables[target];
        if variable.ty == Type::Bool {
            return Some(target);
        }
        let message =
            format!("`{}` is `{}`, and a continuous action assigns a condition", name.text, types::name(variable.ty));
        let diagnostic = Diagnostic::new(Code::E0205, name.span, message)
            .also(variable.span, "declared here")
            .note("IEC 60848, 4.8.2: a continuous action assigns true or false to a Boolean output")
            .help(format!("say what value it gets and when, as in `{} := … on activation`", name.text));
        self.fault(diagnostic);
        None
    }

    /// A variable that can be assigned to.
    fn target(&mut self, name: &ast::Name) -> Option<VariableId> {
        let reference = self.scope.reference(&name.text);
        match reference.map(Reference::entity) {
            Some((entity, form)) => self.symbols.used(name.span, entity, form, Role::Assigned),
            None => self.symbols.missed(name.span, Wanted::Target),
        }
        let diagnostic = match reference {
            Some(Reference::Variable(id)) => {
                let variable = &self.chart.variables[id];
                let what = match variable.kind {
                    VariableKind::Output | VariableKind::Internal => return Some(id),
                    VariableKind::Input => "an input",
                    VariableKind::Constant => "a constant",
                };
                Diagnostic::new(Code::E0207, name.span, format!("`{}` is {what} and cannot be assigned to", name.text))
                    .also(variable.span, "declared here")
                    .help(format!("what the chart sets is declared as `output` or `var`, as in `output {}`", name.text))
            }
            Some(Reference::Activity(label)) => {
                let what = kind(label);
                let message = format!("`{}` is the activity of a {what} and cannot be assigned to", name.text);
                Diagnostic::new(Code::E0207, name.span, message)
                    .note("steps are activated by the clearing of transitions, by forcing and by enclosing steps")
                    .help("an arc to the step is a transition: `transition … -> … : …`")
            }
            Some(Reference::Duration(_)) => {
                let message = format!("`{}` is the duration of a step and cannot be assigned to", name.text);
                Diagnostic::new(Code::E0207, name.span, message)
                    .note("it counts from the activation of the step, and is 0 otherwise")
                    .help("what is to be set is a variable of its own, as in `var … : time`")
            }
            Some(Reference::Frozen(_)) => {
                let message = format!("`{}` says that a grafcet is frozen and cannot be assigned to", name.text);
                Diagnostic::new(Code::E0207, name.span, message)
                    .help("a pulse order freezes it: `freeze … on activation`")
            }
            None => self.scope.unknown_target(&name.text, name.span),
        };
        self.fault(diagnostic);
        None
    }

    /// An expression, or a stand-in if it is faulty.
    fn expression(&mut self, written: ast::ExprId, need: Need) -> ExprId {
        let context = Context {
            tree: self.tree,
            scope: self.scope,
            variables: &self.chart.variables,
            constants: self.constants,
            step: self.step,
        };
        context
            .resolve(written, need, &mut self.chart.exprs, &mut self.scratch, self.symbols, self.diagnostics)
            .unwrap_or_else(|| {
                self.complete = false;
                let span = self.tree[written].span;
                self.chart.exprs.push(Expr { kind: ExprKind::Literal(Value::Bool(false)), ty: Type::Bool, span })
            })
    }

    fn fault(&mut self, diagnostic: Diagnostic) {
        self.complete = false;
        self.diagnostics.push(diagnostic);
    }
}

/// A variable is a wire or stored by the actions on it; where it is both (E0412), the chart goes no further.
fn set_modes(chart: &mut Tables) {
    for action in &chart.stored {
        chart.variables[action.target].mode = Mode::Stored;
    }
    for action in &chart.continuous {
        chart.variables[action.target].mode = Mode::Wire;
    }
}

#[cfg(test)]
mod tests {
    use crate::chart::{Event, Mode, Situation, StepId, TransitionId};
    use crate::checks::testing::{breaks, breaks_all, chart};

    #[test]
    fn what_cannot_be_assigned_to() {
        breaks("E0207", "input a : bool initial step 1 { a }");
        breaks("E0207", "const a : bool := 1 initial step 1 { a := 0 on activation }");
        breaks("E0207", "initial step 1 { X1 := 0 on activation }");
        breaks("E0207", "input a : bool initial step 1 transition 1 -> 1 : ↑a { T1 := 0s }");
    }

    #[test]
    fn types_of_assignments() {
        breaks("E0205", "var n : int initial step 1 { n }");
        breaks("E0205", "var n : int var k : dint initial step 1 { n := k on activation }");
        breaks("E0205", "var n : int initial step 1 { n := 8.5 on activation }");
        breaks("E0205", "var n : int input a : bool initial step 1 { n := a on activation }");
        breaks("E0205", "var b : bool initial step 1 { b := 2 on activation }");
        breaks("E0206", "var n : int initial step 1 { n := 1 on event n }");
        breaks("E0210", "var n : int initial step 1 { n := 70000 on activation }");
    }

    #[test]
    fn actions_keep_the_order_of_the_text() {
        let chart = chart(
            "input a : bool output V, W : bool var C : int
             transition (1) 1 -> 2 : ↑a { C := 1 }
             initial step 1 { C := 2 on deactivation V W if a }
             step 2 { C := 3 on activation C := 4 on event ↑a }",
        );
        let events: Vec<bool> = chart.stored.iter().map(|action| matches!(action.event, Event::Clearing(_))).collect();
        assert_eq!(events, [true, false, false, false]);
        assert_eq!(chart.stored[0].event, Event::Clearing(TransitionId::new(0)));
        assert_eq!(chart.stored[1].event, Event::Deactivation(StepId::new(0)));
        assert_eq!(chart.stored[2].event, Event::Activation(StepId::new(1)));
        assert_eq!(chart.continuous.len(), 2);
        let modes: Vec<Mode> = chart.variables.iter().map(|variable| variable.mode).collect();
        assert_eq!(modes, [Mode::Given, Mode::Wire, Mode::Wire, Mode::Stored]);
    }

    #[test]
    fn forced_situations() {
        let chart = chart(
            "grafcet G1 { initial step 1 { force G2{22, 21} force G3{*} } step 2 { force G2{} force G3{INIT} } }
             grafcet G2 { step 21 step 22 } grafcet G3 { initial step 31 }",
        );
        let situations: Vec<&Situation> = chart.orders.iter().map(|order| &order.situation).collect();
        let in_order = Situation::Steps(vec![StepId::new(2), StepId::new(3)]);
        assert_eq!(situations, [&in_order, &Situation::Current, &Situation::Steps(vec![]), &Situation::Initial]);
        let levels: Vec<u32> = chart.grafcets.iter().map(|grafcet| grafcet.level).collect();
        assert_eq!(levels, [0, 1, 1]);
    }

    #[test]
    fn the_faults_of_one_action_do_not_hide_those_of_another() {
        breaks_all(
            &["E0207", "E0201", "E0301", "E0206"],
            "input a : bool output V : bool var n : int initial step 1 { a V if b } transition 1 -> 2 : n",
        );
    }
}
