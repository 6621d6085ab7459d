//! The productions of the language that a text uses, each with the spellings that it has.
//!
//! The list follows `docs/language.md` from top to bottom. What a name stands for is no production: activities,
//! durations and the like are counted on the checked chart.

use grafc_syntax::ast::{
    Action, ActionKind, BinaryOp, Chart, Declaration, DeclarationKind, Event, ExprId, ExprKind, Item, Name, Situation,
    Step, StepKind, Transition, Type,
};
use std::collections::BTreeSet;

/// All of them.
pub const ALL: &[&str] = &[
    "comment //",
    "comment (* *)",
    "comment (* nested *)",
    "heading",
    "no heading",
    "allow",
    "allow of a declaration",
    "allow in a step",
    "allow in a transition",
    "heading with comment",
    "evolution",
    "initial_actions",
    "bound",
    "input",
    "output",
    "var",
    "const",
    "retain",
    "type bool",
    "type int",
    "type dint",
    "type uint",
    "type udint",
    "type real",
    "type lreal",
    "type time",
    "several names of a declaration",
    "declared name with comment",
    "name in backquotes",
    "initial value",
    "address",
    "initial value, then address",
    "address, then initial value",
    "grafcet",
    "steps without grafcet",
    "grafcet with comment",
    "enclosed grafcet",
    "expansion",
    "expansion with comment",
    "expansion in an expansion",
    "step",
    "initial step",
    "macro step",
    "enclosing step",
    "initial enclosing step",
    "activated step",
    "initial activated step",
    "activated enclosing step",
    "label of digits",
    "label of letters",
    "step with comment",
    "empty braces",
    "several actions",
    "V",
    "V if c",
    "on activation",
    "on deactivation",
    "start",
    "kill",
    "freeze",
    "resume",
    "run",
    "child grafcet",
    "pulse on clearing",
    "each scan",
    "each scan if c",
    "on event",
    "force G{n}",
    "force G{n, m}",
    "force G{}",
    "force G{*}",
    "force G{INIT}",
    "transition",
    "transition with →",
    "transition (n)",
    "transition (name)",
    "transition with comment",
    "source transition",
    "sink transition",
    "n, m -> o",
    "n -> m, o",
    "assignment on clearing",
    "assignments on clearing",
    "and",
    "·",
    "⋅",
    "&",
    "or",
    "+ as or",
    "|",
    "xor",
    "not",
    "!",
    "¬",
    "rise",
    "↑",
    "fall",
    "↓",
    "( )",
    "[ ]",
    "and in arithmetic",
    "or in arithmetic",
    "xor in arithmetic",
    "not in arithmetic",
    "edge in arithmetic",
    "edge of a name",
    "edge of ( )",
    "edge of [ ]",
    "t/e",
    "e/t",
    "t/e/t",
    "delay of a name",
    "delay of ( )",
    "delay of [ ]",
    "delay by a constant",
    "=",
    "<>",
    "≠",
    "<",
    "<=",
    "≤",
    ">",
    ">=",
    "≥",
    "+",
    "-",
    "*",
    "/",
    "mod",
    "-e",
    "0 or 1",
    "true or false",
    "whole number",
    "whole number with _",
    "2#",
    "8#",
    "16#",
    "real",
    "real with exponent",
    "duration",
    "T#",
];

/// Those of a text, which has been read as this tree.
pub fn of(text: &str, chart: &Chart) -> BTreeSet<&'static str> {
    let mut found = FoundProductions { text, chart, seen: BTreeSet::new() };
    found.all();
    found.seen
}

struct FoundProductions<'a> {
    text: &'a str,
    chart: &'a Chart,
    seen: BTreeSet<&'static str>,
}

impl FoundProductions<'_> {
    fn see(&mut self, holds: bool, what: &'static str) {
        if holds {
            self.seen.insert(what);
        }
    }

    fn all(&mut self) {
        for comment in &self.chart.comments {
            let text = &self.text[comment.span.range()];
            self.see(text.starts_with("//"), "comment //");
            self.see(text.starts_with("(*"), "comment (* *)");
            self.see(text.starts_with("(*") && text.matches("(*").count() > 1, "comment (* nested *)");
        }
        match &self.chart.heading {
            None => self.see(true, "no heading"),
            Some(heading) => {
                self.see(true, if heading.comment.is_some() { "heading with comment" } else { "heading" });
                heading.options.iter().for_each(|option| self.see(true, option.kind.word()));
            }
        }
        let mut open: Vec<(&Item, bool)> = self.chart.items.iter().map(|item| (item, false)).collect();
        while let Some((item, in_expansion)) = open.pop() {
            match item {
                Item::Declaration(declaration) => self.declaration(declaration),
                Item::Grafcet(grafcet) => {
                    self.see(grafcet.parent.is_some(), "child grafcet");
                    self.see(true, if grafcet.path.is_empty() { "grafcet" } else { "enclosed grafcet" });
                    self.see(grafcet.comment.is_some(), "grafcet with comment");
                    open.extend(grafcet.items.iter().map(|item| (item, false)));
                }
                Item::Expansion(expansion) => {
                    self.see(true, if in_expansion { "expansion in an expansion" } else { "expansion" });
                    self.see(expansion.comment.is_some(), "expansion with comment");
                    open.extend(expansion.items.iter().map(|item| (item, true)));
                }
                Item::Step(step) => self.step(step),
                Item::Transition(transition) => self.transition(transition),
                Item::Allow(allow) => {
                    self.see(true, if allow.about.is_some() { "allow of a declaration" } else { "allow" });
                }
                Item::Claim(_) => {}
                // What a chart is tested with changes nothing of what it does.
                Item::Scenario(_) => {}
            }
        }
        let implied = self.chart.items.iter().any(|item| matches!(item, Item::Step(_)));
        self.see(implied, "steps without grafcet");
    }

    fn declaration(&mut self, declaration: &Declaration) {
        self.see(declaration.retain.is_some(), "retain");
        self.see(
            true,
            match declaration.kind {
                DeclarationKind::Input => "input",
                DeclarationKind::Output => "output",
                DeclarationKind::Variable => "var",
                DeclarationKind::Constant => "const",
            },
        );
        self.see(
            true,
            match declaration.ty.expect("the chart is whole") {
                Type::Bool => "type bool",
                Type::Int => "type int",
                Type::Dint => "type dint",
                Type::Uint => "type uint",
                Type::Udint => "type udint",
                Type::Real => "type real",
                Type::Lreal => "type lreal",
                Type::Time => "type time",
            },
        );
        self.see(declaration.names.len() > 1, "several names of a declaration");
        self.see(declaration.names.iter().any(|n| n.comment.is_some()), "declared name with comment");
        self.see(declaration.names.iter().any(|n| n.name.quoted), "name in backquotes");
        let initial = declaration.initial.map(|id| self.chart.exprs[id].span.start);
        match (initial, declaration.address.as_ref().map(|text| text.span.start)) {
            (Some(initial), Some(address)) if initial < address => self.see(true, "initial value, then address"),
            (Some(_), Some(_)) => self.see(true, "address, then initial value"),
            (Some(_), None) => self.see(true, "initial value"),
            (None, Some(_)) => self.see(true, "address"),
            (None, None) => {}
        }
        if let Some(id) = declaration.initial {
            self.expression(id, true);
        }
    }

    fn step(&mut self, step: &Step) {
        self.see(
            true,
            match (step.kind, step.is_initial(), step.is_activated()) {
                (StepKind::Plain, false, false) => "step",
                (StepKind::Plain, true, false) => "initial step",
                (StepKind::Plain, false, true) => "activated step",
                (StepKind::Plain, true, true) => "initial activated step",
                (StepKind::Enclosing, _, true) => "activated enclosing step",
                (StepKind::Enclosing, false, false) => "enclosing step",
                (StepKind::Enclosing, true, false) => "initial enclosing step",
                (StepKind::Macro, _, _) => "macro step",
            },
        );
        let digits = is_digits(&step.label);
        self.see(true, if digits { "label of digits" } else { "label of letters" });
        self.see(step.comment.is_some(), "step with comment");
        let braces = self.text[step.span.range()].ends_with('}');
        self.see(braces && step.actions.is_empty() && step.allows.is_empty(), "empty braces");
        self.see(!step.allows.is_empty(), "allow in a step");
        self.see(step.actions.len() > 1, "several actions");
        for action in &step.actions {
            self.action(action);
        }
    }

    fn action(&mut self, action: &Action) {
        match &action.kind {
            ActionKind::Continuous { condition: None, .. } => self.see(true, "V"),
            ActionKind::Continuous { condition: Some(condition), .. } => {
                self.see(true, "V if c");
                self.expression(*condition, false);
            }
            ActionKind::Stored { assignment, event } => {
                self.expression(assignment.value, true);
                match event {
                    Event::Activation => self.see(true, "on activation"),
                    Event::Deactivation => self.see(true, "on deactivation"),
                    Event::EachScan(None) => self.see(true, "each scan"),
                    Event::EachScan(Some(condition)) => {
                        self.see(true, "each scan if c");
                        self.expression(*condition, false);
                    }
                    Event::Event(condition) => {
                        self.see(true, "on event");
                        self.expression(*condition, false);
                    }
                }
            }
            ActionKind::Pulse { kind, event, .. } => {
                self.see(true, kind.word());
                if let Event::Event(condition) = event {
                    self.expression(*condition, false);
                }
            }
            ActionKind::Run { .. } => self.see(true, "run"),
            ActionKind::Force { situation, .. } => self.see(
                true,
                match situation {
                    Situation::Steps(steps) => ["force G{}", "force G{n}", "force G{n, m}"][steps.len().min(2)],
                    Situation::Current => "force G{*}",
                    Situation::Initial => "force G{INIT}",
                },
            ),
        }
    }

    fn transition(&mut self, transition: &Transition) {
        let arrow = self.text[transition.span.range()].contains('→');
        self.see(true, if arrow { "transition with →" } else { "transition" });
        if let Some(designation) = transition.designation() {
            self.see(true, if is_digits(designation) { "transition (n)" } else { "transition (name)" });
        }
        self.see(transition.comment().is_some(), "transition with comment");
        self.see(transition.from.is_empty(), "source transition");
        self.see(transition.to.is_empty(), "sink transition");
        self.see(transition.from.len() > 1, "n, m -> o");
        self.see(transition.to.len() > 1, "n -> m, o");
        self.expression(transition.condition, false);
        self.see(!transition.allows().is_empty(), "allow in a transition");
        self.see(!transition.pulses().is_empty(), "pulse on clearing");
        self.see(transition.actions().len() == 1, "assignment on clearing");
        self.see(transition.actions().len() > 1, "assignments on clearing");
        for assignment in transition.actions() {
            self.expression(assignment.value, true);
        }
    }

    /// An expression and all within; in arithmetic `+` adds.
    fn expression(&mut self, id: ExprId, arithmetic: bool) {
        let mut open = vec![(id, arithmetic)];
        while let Some((id, arithmetic)) = open.pop() {
            let expr = &self.chart.exprs[id];
            let own = &self.text[expr.span.range()];
            match &expr.kind {
                ExprKind::Name(_) | ExprKind::Error => {}
                ExprKind::Integer(_) => {
                    let spelling = if own.contains('_') { "whole number with _" } else { "whole number" };
                    let based = spelt(own, &["2#", "8#", "16#"]);
                    self.see(true, if !arithmetic { "0 or 1" } else { based.unwrap_or(spelling) });
                }
                ExprKind::Real(_) => {
                    self.see(true, if own.contains(['e', 'E']) { "real with exponent" } else { "real" })
                }
                ExprKind::Duration(_) => self.see(true, if own.contains('#') { "T#" } else { "duration" }),
                ExprKind::Bool(_) => self.see(true, "true or false"),
                ExprKind::Paren(e) => {
                    self.see(true, "( )");
                    open.push((*e, arithmetic));
                }
                ExprKind::Predicate(e) => {
                    self.see(true, "[ ]");
                    open.push((*e, true));
                }
                ExprKind::Not(e) => {
                    self.seen.extend(spelt(own, &["not", "!", "¬"]));
                    self.see(arithmetic, "not in arithmetic");
                    open.push((*e, arithmetic));
                }
                ExprKind::Negate(e) => {
                    self.see(true, "-e");
                    open.push((*e, arithmetic));
                }
                ExprKind::Rise(e) | ExprKind::Fall(e) => {
                    self.seen.extend(spelt(own, &["rise", "↑", "fall", "↓"]));
                    self.see(arithmetic, "edge in arithmetic");
                    let forms = ["edge of a name", "edge of ( )", "edge of [ ]"];
                    self.see(true, forms[self.form(*e)]);
                    open.push((*e, arithmetic));
                }
                ExprKind::Binary(op, left, right) => {
                    let (l, r) = (self.chart.exprs[*left].span, self.chart.exprs[*right].span);
                    let between = self.text[l.end as usize..r.start as usize].trim();
                    self.operator(*op, between, arithmetic);
                    open.extend([(*left, arithmetic), (*right, arithmetic)]);
                }
                ExprKind::Delay(parts) => {
                    self.delay(parts);
                    open.extend(parts.iter().map(|part| (*part, arithmetic)));
                }
            }
        }
    }

    fn operator(&mut self, op: BinaryOp, between: &str, arithmetic: bool) {
        match op {
            BinaryOp::And if arithmetic => self.see(true, "and in arithmetic"),
            BinaryOp::Or if arithmetic => self.see(true, "or in arithmetic"),
            BinaryOp::Xor if arithmetic => self.see(true, "xor in arithmetic"),
            BinaryOp::Or if between == "+" => self.see(true, "+ as or"),
            BinaryOp::Or => self.seen.extend(spelt(between, &["or", "|"])),
            BinaryOp::And => self.seen.extend(spelt(between, &["and", "·", "⋅", "&"])),
            BinaryOp::Xor => self.see(true, "xor"),
            BinaryOp::Equal => self.see(true, "="),
            BinaryOp::NotEqual => self.seen.extend(spelt(between, &["<>", "≠"])),
            BinaryOp::Less => self.see(true, "<"),
            BinaryOp::LessEqual => self.seen.extend(spelt(between, &["<=", "≤"])),
            BinaryOp::Greater => self.see(true, ">"),
            BinaryOp::GreaterEqual => self.seen.extend(spelt(between, &[">=", "≥"])),
            BinaryOp::Add => self.see(true, "+"),
            BinaryOp::Subtract => self.see(true, "-"),
            BinaryOp::Multiply => self.see(true, "*"),
            BinaryOp::Divide => self.see(true, "/"),
            BinaryOp::Modulo => self.see(true, "mod"),
        }
    }

    fn delay(&mut self, parts: &[ExprId]) {
        let is_time = |id: &ExprId| matches!(self.chart.exprs[*id].kind, ExprKind::Duration(_));
        let (what, operand) = match parts {
            [_, operand, _] => ("t/e/t", *operand),
            [first, second] if is_time(second) && !is_time(first) => ("e/t", *first),
            [_, second] => ("t/e", *second),
            _ => return,
        };
        let by_name = |id: &&ExprId| matches!(self.chart.exprs[**id].kind, ExprKind::Name(_));
        let named = parts.iter().filter(|id| **id != operand).any(|id| by_name(&id));
        self.see(named, "delay by a constant");
        self.see(true, what);
        let forms = ["delay of a name", "delay of ( )", "delay of [ ]"];
        self.see(true, forms[self.form(operand)]);
    }

    /// A name, something in parentheses, a predicate.
    fn form(&self, id: ExprId) -> usize {
        match self.chart.exprs[id].kind {
            ExprKind::Paren(_) => 1,
            ExprKind::Predicate(_) => 2,
            ExprKind::Name(_)
            | ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Not(_)
            | ExprKind::Negate(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Binary(..)
            | ExprKind::Delay(_)
            | ExprKind::Error => 0,
        }
    }
}

fn is_digits(name: &Name) -> bool {
    name.text.bytes().all(|b| b.is_ascii_digit())
}

/// The one of these that a text begins with.
fn spelt(own: &str, spellings: &[&'static str]) -> Option<&'static str> {
    spellings.iter().copied().find(|spelling| own.starts_with(spelling))
}
