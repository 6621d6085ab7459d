//! The syntax tree as text, to look at and to compare: one item a line, what belongs to it indented below.
//!
//! Expressions are written operator first, so that the tree shows; `( … )` and `[ … ]` of the author stay visible.
//! Places are left out: a tree is compared by what it says, as by [`same`](crate::same).

use crate::ast::*;
use crate::spelling;

/// The tree of a whole file.
pub fn dump(chart: &Chart) -> String {
    let mut dump = Dump { exprs: &chart.exprs, out: String::new(), level: 0 };
    dump.line("chart");
    dump.level += 1;
    if let Some(heading) = &chart.heading {
        let options = heading.options.iter().map(|option| match option.kind {
            ChartOptionKind::Evolution { scan } => format!(" evolution {}", if scan { "scan" } else { "stable" }),
            ChartOptionKind::InitialActions(on) => format!(" initial_actions {}", if on { "on" } else { "off" }),
            ChartOptionKind::Bound(number) => format!(" bound {number}"),
        });
        let options: String = options.collect();
        dump.line(&format!("heading {}{}{options}", name(&heading.name), comment(&heading.comment)));
    }
    dump.items(&chart.items);
    if !chart.comments.is_empty() {
        dump.line(&format!("comments {}", chart.comments.len()));
    }
    dump.out
}

struct Dump<'c> {
    exprs: &'c Exprs,
    out: String,
    level: usize,
}

impl Dump<'_> {
    fn line(&mut self, text: &str) {
        self.out.extend(std::iter::repeat_n("  ", self.level));
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// A word and an expression.
    fn labelled(&mut self, word: &str, id: ExprId) {
        let mut text = format!("{word} ");
        expression(&mut text, self.exprs, id);
        self.line(&text);
    }

    /// Blocks are nested at most 64 deep (see `items`), so this may recurse.
    fn items(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Declaration(declaration) => self.declaration(declaration),
                Item::Grafcet(grafcet) => {
                    let path: String = grafcet.path.iter().map(|part| name(part) + "/").collect();
                    let (child, of) = match &grafcet.parent {
                        Some(parent) => ("child ", format!(" of {}", name(parent))),
                        None => ("", String::new()),
                    };
                    let word = if grafcet.automaton { "automaton" } else { "grafcet" };
                    let what = format!("{child}{word} {path}{}{of}", name(&grafcet.name));
                    self.line(&format!("{what}{}", comment(&grafcet.comment)));
                    self.block(&grafcet.items);
                }
                Item::Expansion(expansion) => {
                    self.line(&format!("expansion {}{}", name(&expansion.macro_step), comment(&expansion.comment)));
                    self.block(&expansion.items);
                }
                Item::Step(step) => self.step(step),
                Item::Transition(transition) => self.transition(transition),
                Item::Allow(allow) => self.allow(allow),
                Item::Claim(claim) => self.claim(claim),
                Item::Scenario(scenario) => self.scenario(scenario),
            }
        }
    }

    fn claim(&mut self, claim: &Claim) {
        let text = claim.text.as_ref().map(|text| format!(" {:?}", text.text)).unwrap_or_default();
        self.line(&format!("{}{text}", claim.kind.keyword()));
        match &claim.body {
            ClaimBody::Condition(condition) => self.below("holds", *condition),
            ClaimBody::AtMostOne(conditions) => conditions.iter().for_each(|c| self.below("at most one", *c)),
            ClaimBody::After(step, holds) => {
                self.below("after", *step);
                self.below("holds", *holds);
            }
            ClaimBody::Leads(from, to) => {
                self.below("from", *from);
                self.below("leads to", *to);
            }
        }
    }

    fn allow(&mut self, allow: &Allow) {
        let about = allow.about.as_ref().map(|about| format!(" {}", name(about)));
        self.line(&format!("allow {}{} {:?}", name(&allow.code), about.unwrap_or_default(), allow.reason.text));
    }

    fn scenario(&mut self, scenario: &Scenario) {
        self.line(&format!("scenario {:?}", scenario.name.text));
        self.level += 1;
        for line in &scenario.lines {
            match &line.kind {
                ScenarioLineKind::At { time, is_after, given } => {
                    self.labelled(if *is_after { "after" } else { "at" }, *time);
                    self.level += 1;
                    for given in given {
                        let pulse = if given.pulse.is_some() { " ↑" } else { "" };
                        self.labelled(&format!("given {}{pulse}", name(&given.name)), given.value);
                    }
                }
                ScenarioLineKind::Until { condition, within } => {
                    self.labelled("until", *condition);
                    self.level += 1;
                    self.labelled("within", *within);
                }
            }
            for expected in &line.expected {
                let what = name(&expected.name);
                match expected.value {
                    Expected::True => self.line(&format!("expected {what}")),
                    Expected::False => self.line(&format!("expected not {what}")),
                    Expected::Value(value) => self.labelled(&format!("expected {what}"), value),
                }
            }
            self.level -= 1;
        }
        self.level -= 1;
    }

    fn block(&mut self, items: &[Item]) {
        self.level += 1;
        self.items(items);
        self.level -= 1;
    }

    fn declaration(&mut self, declaration: &Declaration) {
        let kind = match declaration.kind {
            DeclarationKind::Input => "input",
            DeclarationKind::Output => "output",
            DeclarationKind::Variable => "var",
            DeclarationKind::Constant => "const",
        };
        let retain = if declaration.retain.is_some() { "retain " } else { "" };
        let ty = declaration.ty.map_or("error".to_owned(), |ty| format!("{ty:?}").to_lowercase());
        self.line(&format!("{retain}{kind} : {ty}"));
        self.level += 1;
        for declared in &declaration.names {
            self.line(&(name(&declared.name) + &comment(&declared.comment)));
        }
        if let Some(initial) = declaration.initial {
            self.labelled(":=", initial);
        }
        if let Some(address) = &declaration.address {
            self.line(&format!("at {:?}", address.text));
        }
        self.level -= 1;
    }

    fn step(&mut self, step: &Step) {
        let initial = if step.is_initial() { "initial " } else { "" };
        let activated = if step.is_activated() { "activated " } else { "" };
        let kind = match step.kind {
            StepKind::Plain => "",
            StepKind::Enclosing => "enclosing ",
            StepKind::Macro => "macro ",
        };
        self.line(&format!("{initial}{activated}{kind}step {}{}", name(&step.label), comment(&step.comment)));
        self.level += 1;
        for action in &step.actions {
            match &action.kind {
                ActionKind::Continuous { target, condition } => {
                    self.line(&format!("continuous {}", name(target)));
                    if let Some(condition) = condition {
                        self.below("if", *condition);
                    }
                }
                ActionKind::Stored { assignment, event } => {
                    self.assignment(assignment);
                    self.event(*event);
                }
                ActionKind::Pulse { kind, grafcet, event } => {
                    self.line(&format!("{} {}", kind.word(), name(grafcet)));
                    self.event(*event);
                }
                ActionKind::Run { grafcet } => self.line(&format!("run {}", name(grafcet))),
                ActionKind::Force { grafcet, situation } => {
                    let situation = match situation {
                        Situation::Steps(steps) => names(steps),
                        Situation::Current => "*".to_owned(),
                        Situation::Initial => "INIT".to_owned(),
                    };
                    self.line(&format!("force {}{{{situation}}}", name(grafcet)));
                }
            }
        }
        step.allows.iter().for_each(|allow| self.allow(allow));
        self.level -= 1;
    }

    fn transition(&mut self, transition: &Transition) {
        let designation = transition.designation().map(|name_| format!(" ({})", name(name_)));
        self.line(&format!("transition{}{}", designation.unwrap_or_default(), comment(transition.comment())));
        self.level += 1;
        self.line(format!("from {}", names(&transition.from)).trim_end());
        self.line(format!("to {}", names(&transition.to)).trim_end());
        self.labelled("when", transition.condition);
        for assignment in transition.actions() {
            self.assignment(assignment);
        }
        for pulse in transition.pulses() {
            self.line(&format!("{} {}", pulse.kind.word(), name(&pulse.grafcet)));
        }
        transition.outputs().iter().for_each(|output| self.line(&format!("publish {}", name(output))));
        transition.allows().iter().for_each(|allow| self.allow(allow));
        self.level -= 1;
    }

    fn event(&mut self, event: Event) {
        match event {
            Event::Activation => self.line("  on activation"),
            Event::Deactivation => self.line("  on deactivation"),
            Event::Event(condition) => self.below("on event", condition),
            Event::EachScan(None) => self.line("  each scan"),
            Event::EachScan(Some(condition)) => self.below("each scan if", condition),
        }
    }

    fn assignment(&mut self, assignment: &Assignment) {
        self.labelled(&format!("stored {} :=", name(&assignment.target)), assignment.value);
    }

    /// [`Dump::labelled`], one level deeper.
    fn below(&mut self, word: &str, id: ExprId) {
        self.level += 1;
        self.labelled(word, id);
        self.level -= 1;
    }
}

/// Writes an expression, operator first. Its depth is the author's, so this does not recurse.
fn expression(out: &mut String, exprs: &Exprs, root: ExprId) {
    // What is still to be written; none closes a parenthesis.
    let mut open = vec![Some(root)];
    while let Some(next) = open.pop() {
        let Some(id) = next else {
            out.push(')');
            continue;
        };
        if id != root {
            out.push(' ');
        }
        let (word, operands): (&str, &[ExprId]) = match &exprs[id].kind {
            ExprKind::Name(text) => {
                out.push_str(&plain_or_quoted(text));
                continue;
            }
            ExprKind::Integer(n) => {
                out.push_str(&n.to_string());
                continue;
            }
            ExprKind::Real(x) => {
                out.push_str(&format!("{x:?}"));
                continue;
            }
            ExprKind::Duration(ms) => {
                out.push_str(&format!("{ms}ms"));
                continue;
            }
            ExprKind::Bool(value) => {
                out.push_str(&value.to_string());
                continue;
            }
            ExprKind::Error => ("error", &[]),
            ExprKind::Paren(a) => ("paren", &[*a]),
            ExprKind::Predicate(a) => ("predicate", &[*a]),
            ExprKind::Not(a) => ("not", &[*a]),
            ExprKind::Negate(a) => ("negate", &[*a]),
            ExprKind::Rise(a) => ("rise", &[*a]),
            ExprKind::Fall(a) => ("fall", &[*a]),
            ExprKind::Binary(op, a, b) => (operator(*op), &[*a, *b]),
            ExprKind::Delay(parts) => ("delay", parts),
        };
        out.push('(');
        out.push_str(word);
        open.push(None);
        open.extend(operands.iter().rev().map(|operand| Some(*operand)));
    }
}

fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::And => "and",
        BinaryOp::Or => "or",
        BinaryOp::Xor => "xor",
        BinaryOp::Equal => "=",
        BinaryOp::NotEqual => "<>",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Modulo => "mod",
    }
}

fn names(list: &[Name]) -> String {
    list.iter().map(name).collect::<Vec<_>>().join(", ")
}

/// A name as the author wrote it.
fn name(name: &Name) -> String {
    if name.quoted { quoted(&name.text) } else { name.text.to_string() }
}

/// A name, in backquotes if it needs them; what cannot be seen is escaped.
pub fn plain_or_quoted(text: &str) -> String {
    if spelling::written(text) == text { text.to_owned() } else { quoted(text) }
}

fn quoted(text: &str) -> String {
    format!("`{}`", text.escape_debug())
}

fn comment(comment: &Option<Box<Text>>) -> String {
    comment.as_ref().map(|comment| format!(" {:?}", comment.text)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::dump;
    use grafc_diagnostics::FileId;

    fn of(text: &str) -> String {
        let (tree, diagnostics) = crate::parse(FileId::default(), text);
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
        dump(&tree)
    }

    #[test]
    fn every_item() {
        let text = r#"
            chart Line "a line"  // remark
            input `on` "switch", b : bool at %IX0.0
            var n : dint := -3
            const d : time := 1min30s
            grafcet X9/G1 "inner" {
              initial activated enclosing step 1 "one" { V if b  n := n + 1 on event ↑b  n := 0 on deactivation  force G2{1, 2} force G2{*} force G2{INIT} force G2{} }
              macro step M2
              expansion M2 { step E2 }
              transition (a) "go" 1, 2 -> : `on` and not (b or [n > 2.5]) { n := 7 mod 2 }
              transition -> 1 : 3s/b/d
            }
        "#;
        let expected = r#"chart
  heading Line "a line"
  input : bool
    `on` "switch"
    b
    at "%IX0.0"
  var : dint
    n
    := (negate 3)
  const : time
    d
    := 90000ms
  grafcet X9/G1 "inner"
    initial activated enclosing step 1 "one"
      continuous V
        if b
      stored n := (+ n 1)
        on event (rise b)
      stored n := 0
        on deactivation
      force G2{1, 2}
      force G2{*}
      force G2{INIT}
      force G2{}
    macro step M2
    expansion M2
      step E2
    transition (a) "go"
      from 1, 2
      to
      when (and `on` (not (paren (or b (predicate (> n 2.5))))))
      stored n := (mod 7 2)
    transition
      from
      to 1
      when (delay 3000ms b d)
  comments 1
"#;
        assert_eq!(of(text), expected);
    }

    #[test]
    fn depth_is_no_matter_and_places_are_none() {
        let deep = format!("step 1 transition 1 -> 1 : {}a{}", "(not ".repeat(50_000), ")".repeat(50_000));
        let text = of(&deep);
        assert!(text.contains(&format!("(not {}", "(paren (not ".repeat(3))), "{}", &text[..100]);
        assert_eq!(text, of(&deep.replace(' ', "\n")));
    }
}
