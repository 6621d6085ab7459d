//! The checked chart as text, to look at and to compare: what names stand for, and the types of literals.
//!
//! Things are called by their labels, and transitions without a designation by their number, so that a line changes only
//! where what it says does. Later stages keep expressions, actions and labels, and write them like here.

use crate::chart::{
    Chart, Claim, ClaimBody, Claims, Continuous, DelayTime, Event, Expr, ExprId, ExprKind, GrafcetId, MacroId, Mode,
    Node, Note, Situation, StepId, Stored, TransitionId, Type, Value, Variable, VariableId, VariableKind,
};
pub use crate::resolve::types::name as type_name;
use crate::resolve::types::zero;
pub use grafc_syntax::dump::plain_or_quoted as name;
use index_vec::IndexVec;

/// The whole chart.
pub fn dump(chart: &Chart) -> String {
    let mut out = format!("chart {}{}\n", name(&chart.name), comment(&chart.comment));
    section(&mut out, "variables", chart.variables.iter().map(variable));
    section(&mut out, "grafcets", chart.grafcets.indices().flat_map(|g| grafcet(chart, g)));
    section(&mut out, "hierarchy", chart.hierarchy.iter().map(|g| chart.grafcet(*g)));
    let macro_steps = chart.macro_steps.iter_enumerated().map(|(id, m)| {
        let (entry, exit) = (chart.step(chart.entry(id)), chart.step(chart.exit(id)));
        let of = expansion(chart, m.expansion_of);
        format!("{} in {}{of}: {entry} to {exit}{}", name(&m.label), chart.grafcet(m.grafcet), comment(&m.comment))
    });
    section(&mut out, "macro-steps", macro_steps);
    let transitions = chart.transitions.iter_enumerated().map(|(id, t)| {
        let nodes = |nodes: &[Node]| list(nodes.iter().map(|node| chart.node(*node)));
        let condition = expression(&chart.exprs, chart, t.condition);
        let arcs = arcs(&nodes(&t.pre), &nodes(&t.post));
        format!("{}: {arcs} when {condition}{}", chart.transition(id), comment(&t.comment))
    });
    section(&mut out, "transitions", transitions);
    actions(&mut out, chart, &chart.continuous, &chart.stored, &chart.exprs);
    let orders = chart.orders.iter().map(|order| {
        let situation = match &order.situation {
            Situation::Steps(steps) => list(steps.iter().map(|s| chart.step(*s))),
            Situation::Current => "*".to_owned(),
            Situation::Initial => "INIT".to_owned(),
        };
        format!("{} forces {}{{{situation}}}", chart.step(order.step), chart.grafcet(order.grafcet))
    });
    section(&mut out, "orders", orders);
    section(&mut out, "claims", claims(&chart.claims, chart));
    out
}

/// What is said of a chart, one claim a line.
pub fn claims(claims: &Claims, labels: &impl Labels) -> Vec<String> {
    let line = |claim: &Claim| {
        let condition = |id| expression(&claims.exprs, labels, id);
        let body = match claim.body {
            ClaimBody::Condition(id) => condition(id),
            ClaimBody::Leads(from, to) => format!("{} leads to {}", condition(from), condition(to)),
        };
        format!("{} {:?}: {body}", claim.kind.keyword(), claim.name())
    };
    claims.list.iter().map(line).collect()
}

fn grafcet(chart: &Chart, id: GrafcetId) -> Vec<String> {
    let grafcet = &chart.grafcets[id];
    let within = grafcet.enclosing_step.map(|e| format!(" in {}", chart.step(e))).unwrap_or_default();
    let mut lines =
        vec![format!("{}{within}, level {}{}", chart.grafcet(id), grafcet.level, comment(&grafcet.comment))];
    lines.extend(grafcet.steps.iter().map(|s| {
        let step = &chart.steps[*s];
        let flags = [(step.initial, "initial "), (step.activated, "activated "), (step.enclosing, "enclosing ")];
        let flags: String = flags.iter().filter(|(set, _)| *set).map(|(_, word)| *word).collect();
        format!("  {flags}step {}{}{}", chart.step(*s), expansion(chart, step.expansion_of), comment(&step.comment))
    }));
    lines
}

fn expansion(chart: &Chart, of: Option<MacroId>) -> String {
    of.map(|m| format!(" of {}", chart.macro_step(m))).unwrap_or_default()
}

/// What things are called, in a chart or in what was made of it.
pub trait Labels {
    /// The name of a variable.
    fn variable(&self, id: VariableId) -> String;
    /// The label of a step.
    fn step(&self, id: StepId) -> String;
    /// The label of a macro-step.
    fn macro_step(&self, id: MacroId) -> String;
    /// The name of a grafcet.
    fn grafcet(&self, id: GrafcetId) -> String;
    /// The designation of a transition in parentheses, or its number.
    fn transition(&self, id: TransitionId) -> String;
}

impl Labels for Chart {
    fn variable(&self, id: VariableId) -> String {
        name(&self.variables[id].name)
    }

    fn step(&self, id: StepId) -> String {
        name(&self.steps[id].label)
    }

    fn macro_step(&self, id: MacroId) -> String {
        name(&self.macro_steps[id].label)
    }

    fn grafcet(&self, id: GrafcetId) -> String {
        name(&self.grafcets[id].name)
    }

    fn transition(&self, id: TransitionId) -> String {
        designation(self.transitions[id].designation.as_deref(), id)
    }
}

impl Chart {
    fn node(&self, node: Node) -> String {
        match node {
            Node::Step(s) => self.step(s),
            Node::Macro(m) => self.macro_step(m),
        }
    }
}

/// What a transition is called: `(5)`, or `#5` if it has no designation and is the fifth.
pub fn designation(given: Option<&str>, id: TransitionId) -> String {
    given.map_or_else(|| format!("#{}", id.index() + 1), |given| format!("({})", name(given)))
}

/// The steps before and after a transition.
pub fn arcs(pre: &str, post: &str) -> String {
    format!("{pre} -> {post}").trim().to_owned()
}

/// Lines under a heading; nothing if there are none.
pub fn section(out: &mut String, heading: &str, lines: impl IntoIterator<Item = String>) {
    let mut lines = lines.into_iter().peekable();
    if lines.peek().is_none() {
        return;
    }
    out.push('\n');
    out.push_str(heading);
    out.push('\n');
    for line in lines {
        out.push_str("  ");
        out.push_str(&line);
        out.push('\n');
    }
}

/// Names with commas between them.
pub fn list(names: impl IntoIterator<Item = String>) -> String {
    names.into_iter().collect::<Vec<_>>().join(", ")
}

/// An attached comment, behind what it belongs to.
pub fn comment(comment: &Option<Note>) -> String {
    comment.as_ref().map(|text| format!(" {text:?}")).unwrap_or_default()
}

/// A declared variable.
pub fn variable(variable: &Variable) -> String {
    let kind = match variable.kind {
        VariableKind::Input => "input",
        VariableKind::Output => "output",
        VariableKind::Internal => "var",
        VariableKind::Constant => "const",
    };
    let is_shown = variable.kind == VariableKind::Constant || variable.initial() != zero(variable.ty);
    let initial = is_shown.then(|| format!(" := {}", value(variable.initial())));
    let address = variable.address.as_ref().map(|address| format!(" at {address:?}"));
    let mode = match variable.mode {
        Mode::Given => "",
        Mode::Wire => ", by continuous actions",
        Mode::Stored if variable.momentary => ", by stored actions, anew in each reaction",
        Mode::Stored => ", by stored actions",
    };
    let retain = if variable.retain { "retain " } else { "" };
    let head = format!("{retain}{kind} {} : {}", name(&variable.name), type_name(variable.ty));
    format!("{head}{}{}{mode}{}", initial.unwrap_or_default(), address.unwrap_or_default(), comment(&variable.comment))
}

/// Continuous and stored actions.
pub fn actions(
    out: &mut String,
    labels: &impl Labels,
    continuous: &[Continuous],
    stored: &[Stored],
    exprs: &IndexVec<ExprId, Expr>,
) {
    let lines = continuous.iter().map(|action| {
        let condition = action.condition.map(|id| format!(" if {}", expression(exprs, labels, id)));
        format!("{}: {}{}", labels.step(action.step), labels.variable(action.target), condition.unwrap_or_default())
    });
    section(out, "continuous actions", lines);
    let lines = stored.iter().map(|action| {
        let event = match action.event {
            Event::Event(s, id) => format!("{} on event {}", labels.step(s), expression(exprs, labels, id)),
            Event::Deactivation(s) => format!("{} on deactivation", labels.step(s)),
            Event::Clearing(t) => format!("{} on clearing", labels.transition(t)),
            Event::Activation(s) => format!("{} on activation", labels.step(s)),
            Event::EachScan(s, None) => format!("{} each scan", labels.step(s)),
            Event::EachScan(s, Some(id)) => {
                format!("{} each scan if {}", labels.step(s), expression(exprs, labels, id))
            }
        };
        format!("{event}: {} := {}", labels.variable(action.target), expression(exprs, labels, action.value))
    });
    section(out, "stored actions", lines);
}

/// A value, without its type.
pub fn value(value: Value) -> String {
    match value {
        Value::Bool(b) => b.to_string(),
        Value::Int(n) => n.to_string(),
        Value::Real(x) => format!("{x:?}"),
        Value::Time(ms) => format!("{ms}ms"),
    }
}

/// A literal, with its type where its form does not tell it.
pub fn literal(of: Value, ty: Type) -> String {
    match ty {
        Type::Bool | Type::Time => value(of),
        Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Real | Type::Lreal => {
            format!("{}#{}", type_name(ty), value(of))
        }
    }
}

/// An expression. Its depth is the author's, so this does not recurse.
pub fn expression(exprs: &IndexVec<ExprId, Expr>, labels: &impl Labels, root: ExprId) -> String {
    let mut out = String::new();
    let mut open = vec![Piece::Expr(root)];
    while let Some(piece) = open.pop() {
        let id = match piece {
            Piece::Text(text) => {
                out.push_str(&text);
                continue;
            }
            Piece::Expr(id) => id,
        };
        let operand = |operand: ExprId, place: usize| match needs_parentheses(exprs, id, operand, place) {
            true => vec![Piece::Text("(".into()), Piece::Expr(operand), Piece::Text(")".into())],
            false => vec![Piece::Expr(operand)],
        };
        let prefix = |word: &str, a: ExprId| [vec![Piece::Text(word.into())], operand(a, 0)].concat();
        let infix = |a: ExprId, word: &str, b: ExprId| {
            [operand(a, 0), vec![Piece::Text(format!(" {word} "))], operand(b, 1)].concat()
        };
        let pieces = match &exprs[id].kind {
            ExprKind::Literal(value) => vec![Piece::Text(literal(*value, exprs[id].ty))],
            ExprKind::Variable(v) => vec![Piece::Text(labels.variable(*v))],
            ExprKind::StepActive(s) => vec![Piece::Text(format!("X{}", labels.step(*s)))],
            ExprKind::StepTime(s) => vec![Piece::Text(format!("T{}", labels.step(*s)))],
            ExprKind::MacroActive(m) => vec![Piece::Text(format!("X{}", labels.macro_step(*m)))],
            ExprKind::GrafcetActive(g) => vec![Piece::Text(format!("X{}", labels.grafcet(*g)))],
            ExprKind::GrafcetFrozen(g) => vec![Piece::Text(format!("F{}", labels.grafcet(*g)))],
            ExprKind::Not(a) => prefix("not ", *a),
            ExprKind::Rise(a) => prefix("↑", *a),
            ExprKind::Fall(a) => prefix("↓", *a),
            ExprKind::Negate(a) => prefix("-", *a),
            ExprKind::And(a, b) => infix(*a, "and", *b),
            ExprKind::Or(a, b) => infix(*a, "or", *b),
            ExprKind::Xor(a, b) => infix(*a, "xor", *b),
            ExprKind::Compare(op, a, b) => infix(*a, op.sign(), *b),
            ExprKind::Arithmetic(op, a, b) => infix(*a, op.sign(), *b),
            ExprKind::Delay { on, operand: a, off } => {
                let mut pieces = vec![Piece::Text(format!("{}/", delay(labels, *on)))];
                pieces.extend(operand(*a, 0));
                if off.ms != 0 || off.constant.is_some() {
                    pieces.push(Piece::Text(format!("/{}", delay(labels, *off))));
                }
                pieces
            }
            ExprKind::Widen(a) => {
                let head = Piece::Text(format!("{}(", type_name(exprs[id].ty)));
                vec![head, Piece::Expr(*a), Piece::Text(")".into())]
            }
        };
        open.extend(pieces.into_iter().rev());
    }
    out
}

/// What is still to be written of an expression.
#[derive(Clone)]
enum Piece {
    Text(String),
    Expr(ExprId),
}

/// Whether an operand needs parentheses: where two operators meet, except in a chain of one that is associative.
fn needs_parentheses(exprs: &IndexVec<ExprId, Expr>, parent: ExprId, operand: ExprId, place: usize) -> bool {
    let (parent, operand) = (&exprs[parent].kind, &exprs[operand].kind);
    match operand {
        ExprKind::And(..) | ExprKind::Or(..) | ExprKind::Xor(..) => {
            place > 0 || std::mem::discriminant(parent) != std::mem::discriminant(operand)
        }
        ExprKind::Compare(..) | ExprKind::Arithmetic(..) | ExprKind::Delay { .. } => true,
        ExprKind::Not(_) => !matches!(parent, ExprKind::And(..) | ExprKind::Or(..) | ExprKind::Xor(..)),
        ExprKind::Literal(_)
        | ExprKind::Variable(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_)
        | ExprKind::Rise(_)
        | ExprKind::Fall(_)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => false,
    }
}

fn delay(labels: &impl Labels, delay: DelayTime) -> String {
    delay.constant.map_or_else(|| value(Value::Time(delay.ms)), |constant| labels.variable(constant))
}

#[cfg(test)]
mod tests {
    use super::dump;
    use crate::checks::testing::chart;

    /// The lines below a heading.
    fn below<'t>(text: &'t str, heading: &str) -> Vec<&'t str> {
        let lines = text.lines().skip_while(|line| *line != heading).skip(1);
        lines.take_while(|line| !line.is_empty()).map(|line| &line[2..]).collect()
    }

    #[test]
    fn names_types_and_actions() {
        let text = dump(&chart(
            r#"chart C "about it"
            input `on`, b : bool at %IX0.7  input k : int
            output V "valve" : bool  var n : dint := -3  var r : real  const d : time := 1500ms
            initial step 1 "one" { V if 2s/b/d  n := n + k on activation }
            step 2 { r := -r / 2 on event ↑(`on` or X1) }
            transition 1 -> 2 : `on` and (b or not X1) and [T1 > d]
            transition (back) "again" 2 -> 1 : b xor [n <> 7] { n := 0 }"#,
        ));
        assert!(text.starts_with("chart C \"about it\"\n\nvariables\n"), "{text}");
        assert_eq!(
            below(&text, "variables"),
            [
                "input `on` : bool at \"%IX0.7\"",
                "input b : bool at \"%IX1.0\"",
                "input k : int",
                "output V : bool, by continuous actions \"valve\"",
                "var n : dint := -3, by stored actions",
                "var r : real, by stored actions",
                "const d : time := 1500ms",
            ]
        );
        assert_eq!(below(&text, "grafcets"), ["G1, level 0", "  initial step 1 \"one\"", "  step 2"]);
        assert_eq!(
            below(&text, "transitions"),
            [
                "#1: 1 -> 2 when `on` and (b or not X1) and (T1 > d)",
                "(back): 2 -> 1 when b xor (n <> dint#7) \"again\"",
            ]
        );
        assert_eq!(below(&text, "continuous actions"), ["1: V if 2000ms/b/d"]);
        assert_eq!(
            below(&text, "stored actions"),
            [
                "1 on activation: n := n + dint(k)",
                "2 on event ↑(`on` or X1): r := -r / real#2.0",
                "(back) on clearing: n := dint#0",
            ]
        );
    }

    #[test]
    fn hierarchy() {
        let text = dump(&chart(
            "grafcet G1 { initial step 1 { force G3{INIT} } enclosing step `2 b` { force G3{6} } macro step M3
               transition 1 -> `2 b`, M3 : XG1 and XM3 }
             expansion M3 { step E3 step S3 transition E3 -> S3 : 1 }
             grafcet `X2 b`/G2 { activated step 5 } grafcet G3 { initial step 6 step 7 transition -> 7 : 1 }",
        ));
        assert_eq!(
            below(&text, "grafcets"),
            [
                "G1, level 0",
                "  initial step 1",
                "  enclosing step `2 b`",
                "  step E3 of M3",
                "  step S3 of M3",
                "G2 in `2 b`, level 1",
                "  activated step 5",
                "G3, level 1",
                "  initial step 6",
                "  step 7",
            ]
        );
        assert_eq!(below(&text, "macro-steps"), ["M3 in G1: E3 to S3"]);
        assert_eq!(
            below(&text, "transitions"),
            ["#1: 1 -> `2 b`, M3 when XG1 and XM3", "#2: E3 -> S3 when true", "#3: -> 7 when true"]
        );
        assert_eq!(below(&text, "orders"), ["1 forces G3{INIT}", "`2 b` forces G3{6}"]);
    }

    #[test]
    fn depth_is_no_matter() {
        let deep = "not (a and ".repeat(20_000) + "a" + &")".repeat(20_000);
        let text = dump(&chart(&format!("input a : bool initial step 1 transition 1 -> 1 : {deep}")));
        assert_eq!(below(&text, "transitions"), [format!("#1: 1 -> 1 when {deep}")]);
    }
}
