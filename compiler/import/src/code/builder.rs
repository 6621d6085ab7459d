//! What the grammar makes expressions with.

use super::literal;
use super::source::Source;
use super::tree::{Argument, Code, ExprId, ExprKind, Operator};

/// Makes expressions of a text.
pub struct Builder<'text> {
    pub source: &'text Source,
    pub code: &'text mut Code,
}

/// How long the name of a member may become.
const LONGEST: usize = 400;

impl<'text> Builder<'text> {
    /// A part of the text.
    pub fn text(&self, start: usize, end: usize) -> &'text str {
        &self.source.text[start..end]
    }

    /// Adds what stands in a range.
    pub fn add(&mut self, start: usize, end: usize, kind: ExprKind) -> ExprId {
        let span = self.source.span(start..end);
        self.code.add(kind, span)
    }

    /// What no chart can say.
    pub fn unknown(&mut self, start: usize, end: usize, what: &str) -> ExprId {
        self.add(start, end, ExprKind::Unknown(format!("charts cannot express {what}")))
    }

    /// A number.
    pub fn integer(&mut self, start: usize, end: usize) -> ExprId {
        self.add(start, end, literal::integer(self.text(start, end)))
    }

    /// A number with a fraction.
    pub fn real(&mut self, start: usize, end: usize) -> ExprId {
        self.add(start, end, literal::real(self.text(start, end)))
    }

    /// A literal with its type.
    pub fn typed(&mut self, start: usize, end: usize) -> ExprId {
        self.add(start, end, literal::typed(self.text(start, end)))
    }

    /// The negative of something; that of a literal is one.
    pub fn negate(&mut self, start: usize, end: usize, operand: ExprId) -> ExprId {
        let kind = match &self.code.exprs[operand].kind {
            ExprKind::Integer(number) => ExprKind::Integer(-number),
            ExprKind::Real(number) if !number.starts_with('-') => ExprKind::Real(format!("-{number}")),
            _ => ExprKind::Negate(operand),
        };
        self.add(start, end, kind)
    }

    /// A member of something.
    pub fn member(&self, path: String, start: usize, end: usize) -> String {
        if path.len() > LONGEST { path } else { path + "." + self.text(start, end) }
    }

    /// An element of an array: a name, if its place is a constant.
    pub fn element(&self, path: String, indexes: Vec<ExprId>) -> String {
        if path.len() > LONGEST {
            return path;
        }
        let places: Vec<String> = indexes
            .iter()
            .map(|&index| match &self.code.exprs[index].kind {
                ExprKind::Integer(place) => place.to_string(),
                _ => "?".to_string(),
            })
            .collect();
        format!("{path}[{}]", places.join(","))
    }

    /// An argument without a value, which does nothing.
    pub fn unwanted(&mut self, start: usize, end: usize, gives: bool) -> Argument {
        let name = Some(self.text(start, end).to_string());
        Argument { name, value: self.add(start, end, ExprKind::Unknown(String::new())), gives }
    }

    /// A call; an operator in its form as a function is that operator.
    pub fn call(&mut self, start: usize, end: usize, name: String, arguments: Vec<Argument>) -> ExprId {
        let span = self.source.span(start..end);
        call(self.code, span, name, arguments)
    }
}

/// A call; an operator in its form as a function is that operator.
pub fn call(code: &mut Code, span: grafc_diagnostics::Span, name: String, arguments: Vec<Argument>) -> ExprId {
    let values: Vec<ExprId> = arguments.iter().filter(|argument| !argument.gives).map(|a| a.value).collect();
    let upper = name.to_ascii_uppercase();
    if let ("NOT", [operand]) = (upper.as_str(), values.as_slice()) {
        return code.not(*operand);
    }
    if let ("MOVE" | "BOOL_TO_BOOL", [operand]) = (upper.as_str(), values.as_slice()) {
        return *operand;
    }
    if let ("SEL", [choice, no, yes]) = (upper.as_str(), values.as_slice()) {
        // Of Booleans; of others the check of types says that charts have no choice of values.
        let taken = code.and(*choice, *yes);
        let not = code.not(*choice);
        let other = code.and(not, *no);
        return code.or(other, taken);
    }
    match operator(&upper) {
        Some(operator) if values.len() >= 2 && (values.len() == 2 || !operator.compares()) => {
            values.into_iter().reduce(|left, right| code.binary(operator, left, right)).expect("two operands")
        }
        Some(_) | None => code.add(ExprKind::Call(name, arguments), span),
    }
}

/// The operator that a function stands for.
pub fn operator(name: &str) -> Option<Operator> {
    Some(match name {
        "AND" => Operator::And,
        "OR" => Operator::Or,
        "XOR" => Operator::Xor,
        "ADD" => Operator::Add,
        "SUB" => Operator::Subtract,
        "MUL" => Operator::Multiply,
        "DIV" => Operator::Divide,
        "MOD" => Operator::Modulo,
        "EQ" => Operator::Equal,
        "NE" => Operator::NotEqual,
        "LT" => Operator::Less,
        "LE" => Operator::LessEqual,
        "GT" => Operator::Greater,
        "GE" => Operator::GreaterEqual,
        _ => return None,
    })
}
