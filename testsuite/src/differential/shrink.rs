//! Makes a chart and its trace smaller while a fault persists.
//!
//! Pieces of the text are deleted or replaced by the places in its syntax tree, the largest first; what is left must
//! still show the fault, which the caller decides. Nothing else is asked of a step, so any fault can be shrunk.

use grafc_diagnostics::{FileId, Span};
use grafc_model::chart::{Chart, Value, VariableKind};
use grafc_model::reaction::Stimulus;
use grafc_syntax::ast::{ActionKind, Event, ExprId, ExprKind, Item, Situation};

/// A trace by the names of inputs, so that it survives the deletion of one.
#[derive(Clone, Debug)]
pub struct NamedTrace {
    names: Vec<String>,
    rows: Vec<Stimulus>,
}

impl NamedTrace {
    /// The stimuli of a chart.
    pub fn of(chart: &Chart, rows: &[Stimulus]) -> Self {
        let inputs = chart.variables.iter().filter(|v| v.kind == VariableKind::Input);
        NamedTrace { names: inputs.map(|v| v.name.clone()).collect(), rows: rows.to_vec() }
    }

    /// The stimuli for a chart that may have fewer inputs.
    pub fn stimuli(&self, chart: &Chart) -> Vec<Stimulus> {
        let inputs: Vec<_> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
        let column = |name: &str| self.names.iter().position(|n| n == name);
        let value = |row: &Stimulus, name: &str, initial: Value| column(name).map_or(initial, |i| row.inputs[i]);
        let inputs_of = |row: &Stimulus| inputs.iter().map(|v| value(row, &v.name, v.initial)).collect();
        self.rows.iter().map(|row| Stimulus { t_ms: row.t_ms, inputs: inputs_of(row) }).collect()
    }

    /// The trace as a file of it would read.
    pub fn to_csv(&self) -> String {
        let cell = |value: &Value| match value {
            Value::Bool(b) => u8::from(*b).to_string(),
            Value::Int(n) | Value::Time(n) => n.to_string(),
            Value::Real(x) => x.to_string(),
        };
        let mut out = format!("t_ms,{}\n", self.names.join(","));
        for row in &self.rows {
            let cells: Vec<String> = row.inputs.iter().map(cell).collect();
            out.push_str(&format!("{},{}\n", row.t_ms, cells.join(",")));
        }
        out
    }
}

/// The smallest chart and trace found that still show the fault, after at most `tries` runs.
pub fn shrink(
    text: &str,
    trace: &NamedTrace,
    mut tries: u32,
    mut faulty: impl FnMut(&str, &NamedTrace) -> bool,
) -> (String, NamedTrace) {
    let (mut text, mut trace) = (text.to_string(), trace.clone());
    loop {
        let mut smaller = false;
        // Rows: halves first, then one by one.
        let mut size = (trace.rows.len() / 2).max(1);
        loop {
            let mut at = trace.rows.len();
            while at > 0 && tries > 0 {
                let from = at.saturating_sub(size);
                let mut shorter = trace.clone();
                shorter.rows.drain(from..at);
                tries -= 1;
                if faulty(&text, &shorter) {
                    trace = shorter;
                    smaller = true;
                }
                at = from;
            }
            if size == 1 {
                break;
            }
            size /= 2;
        }
        // Text: one edit at a time; places move with each, so the tree is read again.
        'edits: loop {
            for (span, with) in edits(&text) {
                if tries == 0 {
                    return (text, trace);
                }
                let mut shorter = text.clone();
                shorter.replace_range(span.range(), &with);
                tries -= 1;
                if faulty(&shorter, &trace) {
                    text = shorter;
                    smaller = true;
                    continue 'edits;
                }
            }
            break;
        }
        if !smaller {
            return (text, trace);
        }
    }
}

/// All edits that make a text shorter, the largest first.
fn edits(text: &str) -> Vec<(Span, String)> {
    let (chart, said) = grafc_syntax::parse(FileId::default(), text);
    if said.has_errors() {
        return Vec::new();
    }
    let mut list: Vec<(Span, String)> = Vec::new();
    let mut exprs: Vec<ExprId> = Vec::new();
    let mut open: Vec<&Item> = chart.items.iter().collect();
    while let Some(item) = open.pop() {
        match item {
            Item::Declaration(declaration) => list.push((declaration.span, String::new())),
            Item::Grafcet(grafcet) => {
                list.push((grafcet.span, String::new()));
                open.extend(&grafcet.items);
            }
            Item::Expansion(expansion) => {
                list.push((expansion.span, String::new()));
                open.extend(&expansion.items);
            }
            Item::Step(step) => {
                list.push((step.span, String::new()));
                if step.initial
                    && let Some(at) = text[step.span.range()].find("initial")
                {
                    let start = step.span.start as usize + at;
                    list.push((Span::new(step.span.file, start, start + "initial".len()), String::new()));
                }
                let head = step.comment.as_ref().map_or(step.label.span, |c| c.span);
                list.push((Span::new(head.file, head.end as usize, step.span.end as usize), String::new()));
                for action in &step.actions {
                    list.push((action.span, String::new()));
                    match &action.kind {
                        ActionKind::Continuous { target, condition } => {
                            let rest = Span::new(target.span.file, target.span.end as usize, action.span.end as usize);
                            list.push((rest, String::new()));
                            exprs.extend(condition);
                        }
                        ActionKind::Stored { assignment, event } => {
                            exprs.push(assignment.value);
                            match event {
                                Event::Activation | Event::Deactivation => {}
                                Event::Event(condition) => exprs.push(*condition),
                            }
                        }
                        ActionKind::Force { situation, .. } => match situation {
                            Situation::Steps(_) | Situation::Current | Situation::Initial => {}
                        },
                    }
                }
            }
            Item::Transition(transition) => {
                list.push((transition.span, String::new()));
                let condition = chart.exprs[transition.condition].span;
                let rest = Span::new(condition.file, condition.end as usize, transition.span.end as usize);
                list.push((rest, String::new()));
                exprs.push(transition.condition);
                exprs.extend(transition.actions.iter().map(|a| a.value));
                for names in [&transition.from, &transition.to] {
                    for (index, name) in names.iter().enumerate().skip(1) {
                        let from = names[index - 1].span.end as usize;
                        list.push((Span::new(name.span.file, from, name.span.end as usize), String::new()));
                    }
                }
            }
        }
    }
    while let Some(id) = exprs.pop() {
        let expr = &chart.exprs[id];
        let mut children: Vec<ExprId> = Vec::new();
        match &expr.kind {
            ExprKind::Name(_)
            | ExprKind::Integer(_)
            | ExprKind::Real(_)
            | ExprKind::Duration(_)
            | ExprKind::Bool(_)
            | ExprKind::Error => {}
            ExprKind::Paren(e) | ExprKind::Not(e) | ExprKind::Negate(e) | ExprKind::Rise(e) | ExprKind::Fall(e) => {
                children.push(*e);
            }
            ExprKind::Predicate(e) => {
                exprs.push(*e);
                list.push((expr.span, "1".into()));
            }
            ExprKind::Binary(_, l, r) => children.extend([*l, *r]),
            ExprKind::Delay(parts) => {
                children.extend(parts.iter().copied());
                if let [on, operand, off] = parts[..] {
                    let part = |from: ExprId, to: ExprId| {
                        text[chart.exprs[from].span.to(chart.exprs[to].span).range()].to_string()
                    };
                    list.push((expr.span, part(on, operand)));
                    list.push((expr.span, part(operand, off)));
                }
            }
        }
        for child in children {
            list.push((expr.span, text[chart.exprs[child].span.range()].to_string()));
            exprs.push(child);
        }
    }
    list.retain(|(span, with)| span.range().len() > with.len());
    list.sort_by_key(|(span, with)| (std::cmp::Reverse(span.range().len() - with.len()), span.start));
    list
}
