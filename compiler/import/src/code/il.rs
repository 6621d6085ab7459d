//! Instruction lists as statements: what an instruction works on is an expression, and a store is an assignment.

use super::builder::{call, operator};
use super::source::Source;
use super::statements::parse;
use super::token::{Lexeme, Token, lex};
use super::tree::{Argument, Code, ExprId, ExprKind, Operator, Statement, StatementKind};
use grafc_diagnostics::Span;

/// What a list does, and what its last instruction leaves behind.
pub struct List {
    pub statements: Vec<Statement>,
    pub result: Option<ExprId>,
}

/// Reads an instruction list.
pub fn read(source: &Source, code: &mut Code) -> List {
    let lexemes = lex(source);
    let mut reader = Reader { source, code, result: None, open: Vec::new(), out: Vec::new() };
    for line in lines(source, &lexemes) {
        reader.instruction(line);
    }
    if !reader.open.is_empty() {
        reader.lost("a parenthesis is not closed", source.whole, source.text.trim());
        reader.result = None;
    }
    List { statements: reader.out, result: reader.result }
}

/// The tokens line by line; a call goes on until its parenthesis is closed.
fn lines<'l>(source: &Source, lexemes: &'l [Lexeme]) -> Vec<&'l [Lexeme]> {
    let mut lines = Vec::new();
    let (mut begin, mut depth) = (0, 0_i32);
    let is_call = |lexeme: &Lexeme| source.text[lexeme.range()].to_ascii_uppercase().starts_with("CAL");
    for (place, lexeme) in lexemes.iter().enumerate() {
        let calls = lexemes.get(begin).is_some_and(is_call);
        match lexeme.token {
            Token::OpenParen if calls => depth += 1,
            Token::CloseParen if calls => depth -= 1,
            _ => {}
        }
        let next = lexemes.get(place + 1).map_or(source.text.len(), |next| next.start);
        let ends = source.text[lexeme.end..next].contains('\n') && depth <= 0 || place + 1 == lexemes.len();
        if ends {
            lines.push(&lexemes[begin..=place]);
            (begin, depth) = (place + 1, 0);
        }
    }
    lines
}

/// An operator that waits for its parenthesis to close.
struct Waiting {
    operator: Operator,
    negated: bool,
    before: Option<ExprId>,
}

struct Reader<'a> {
    source: &'a Source,
    code: &'a mut Code,
    result: Option<ExprId>,
    open: Vec<Waiting>,
    out: Vec<Statement>,
}

impl Reader<'_> {
    fn instruction(&mut self, line: &[Lexeme]) {
        let mut line = line;
        // A label.
        if let [_, colon, behind @ ..] = line
            && colon.token == Token::Colon
        {
            line = behind;
        }
        while let [before @ .., last] = line
            && last.token == Token::Semicolon
        {
            line = before;
        }
        let Some((first, rest)) = line.split_first() else { return };
        let range = first.start..line.last().map_or(first.end, |last| last.end);
        let (span, text) = (self.source.span(range.clone()), self.source.text[range].to_string());
        if first.token == Token::CloseParen {
            return self.close(span, &text);
        }
        let word = self.source.text[first.range()].to_ascii_uppercase();
        let (word, negated) = match word.strip_suffix('N') {
            Some(stem) if !stem.is_empty() && (operator(stem).is_some() || matches!(stem, "LD" | "ST")) => {
                (stem.to_string(), true)
            }
            _ => (word, false),
        };
        let (word, rest, negated) = match (word.as_str(), rest) {
            // `&N`.
            ("&", [n, behind @ ..])
                if self.source.text[n.range()].eq_ignore_ascii_case("N") && n.start == first.end =>
            {
                ("AND".to_string(), behind, true)
            }
            ("&", _) => ("AND".to_string(), rest, negated),
            _ => (word, rest, negated),
        };
        match word.as_str() {
            "LD" => {
                let operand = self.operand(rest, negated);
                self.result = Some(operand);
            }
            "NOT" if rest.is_empty() => {
                if let Some(result) = self.result {
                    self.result = Some(self.code.not(result));
                }
            }
            "ST" => self.store(rest, negated, span, &text),
            "S" | "R" => self.set(rest, word == "S", span, &text),
            "CAL" if rest.len() >= 2 => {
                let lexemes = rest.to_vec();
                let id = parse(self.source, self.code, &lexemes);
                match self.code.exprs[id].kind.clone() {
                    ExprKind::Call(name, arguments) => self.push(StatementKind::Call(name, arguments), span),
                    _ => self.lost("it is not understood", span, &text),
                }
            }
            "CAL" | "CALC" | "CALCN" if !rest.is_empty() => {
                let name = self.source.text[rest[0].range()].to_string();
                if word == "CAL" {
                    self.push(StatementKind::Call(name, Vec::new()), span);
                } else {
                    self.lost("charts cannot call a block under a condition", span, &text);
                }
            }
            "JMP" | "JMPC" | "JMPCN" | "RET" | "RETC" | "RETCN" => {
                self.lost("what follows is then not done", span, &text);
                self.result = None;
            }
            _ => match operator(&word) {
                Some(operator) => self.operate(operator, negated, rest, span, &text),
                None => self.function(&word, rest, span),
            },
        }
    }

    /// The expression of some tokens.
    fn operand(&mut self, lexemes: &[Lexeme], negated: bool) -> ExprId {
        let id = parse(self.source, self.code, lexemes);
        if negated { self.code.not(id) } else { id }
    }

    fn operate(&mut self, operator: Operator, negated: bool, rest: &[Lexeme], span: Span, text: &str) {
        if let [open, behind @ ..] = rest
            && open.token == Token::OpenParen
            && !behind.iter().any(|lexeme| lexeme.token == Token::CloseParen)
        {
            self.open.push(Waiting { operator, negated, before: self.result });
            self.result = (!behind.is_empty()).then(|| self.operand(behind, false));
            return;
        }
        let Some(before) = self.result else { return self.lost("nothing was loaded", span, text) };
        let operand = self.operand(rest, negated);
        self.result = Some(self.code.binary(operator, before, operand));
    }

    fn close(&mut self, span: Span, text: &str) {
        let Some(waiting) = self.open.pop() else { return self.lost("no parenthesis was opened", span, text) };
        self.result = match (waiting.before, self.result) {
            (Some(before), Some(inner)) => {
                let inner = if waiting.negated { self.code.not(inner) } else { inner };
                Some(self.code.binary(waiting.operator, before, inner))
            }
            _ => None,
        };
    }

    fn store(&mut self, rest: &[Lexeme], negated: bool, span: Span, text: &str) {
        match (self.target(rest), self.result) {
            (Some(target), Some(result)) => {
                let value = if negated { self.code.not(result) } else { result };
                self.push(StatementKind::Assign { target, value }, span);
            }
            _ => self.lost("nothing was loaded, or there is no variable", span, text),
        }
    }

    fn set(&mut self, rest: &[Lexeme], to: bool, span: Span, text: &str) {
        match (self.target(rest), self.result) {
            (Some(target), Some(result)) => {
                let value = self.code.add(ExprKind::Bool(to), span);
                self.push(StatementKind::If(result), span);
                self.push(StatementKind::Assign { target, value }, span);
                self.push(StatementKind::EndIf, span);
            }
            _ => self.lost("nothing was loaded, or there is no variable", span, text),
        }
    }

    fn target(&mut self, lexemes: &[Lexeme]) -> Option<String> {
        let id = parse(self.source, self.code, lexemes);
        match &self.code.exprs[id].kind {
            ExprKind::Path(path) => Some(path.clone()),
            _ => None,
        }
    }

    /// A function: its first argument is what was loaded.
    fn function(&mut self, name: &str, rest: &[Lexeme], span: Span) {
        let mut values: Vec<ExprId> = self.result.into_iter().collect();
        for argument in rest.split(|lexeme| lexeme.token == Token::Comma).filter(|argument| !argument.is_empty()) {
            values.push(self.operand(argument, false));
        }
        let arguments = values.into_iter().map(|value| Argument { name: None, value, gives: false }).collect();
        self.result = Some(call(self.code, span, name.to_string(), arguments));
    }

    fn push(&mut self, kind: StatementKind, span: Span) {
        self.out.push(Statement { kind, span });
    }

    fn lost(&mut self, why: &str, span: Span, text: &str) {
        self.push(StatementKind::Lost { why: why.into(), text: text.chars().take(2_000).collect() }, span);
    }
}
