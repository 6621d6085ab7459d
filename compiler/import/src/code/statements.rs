//! A text of statements, cut into pieces that the grammar takes one by one.
//!
//! `IF` and `CASE` become marks around what they hold, so nothing here is nested. A statement that is not understood is
//! lost alone, up to its semicolon or to the next word that begins or ends one; a loop is lost whole.

use super::builder::Builder;
use super::grammar;
use super::source::Source;
use super::token::{Keyword, Lexeme, Token, lex};
use super::tree::{Code, ExprId, ExprKind, Statement, StatementKind};
use std::ops::Range;

/// How much of what is lost is kept as text.
const KEPT: usize = 2_000;

/// The statements of a text.
pub fn read(source: &Source, code: &mut Code) -> Vec<Statement> {
    let lexemes: Vec<Lexeme> = lex(source).into_iter().map(in_statements).collect();
    let mut reader = Reader { source, code, lexemes, at: 0, open: Vec::new(), out: Vec::new() };
    while reader.at < reader.lexemes.len() {
        reader.statement();
    }
    while let Some(open) = reader.open.pop() {
        let end = source.text.len();
        reader.push(if open == Open::If { StatementKind::EndIf } else { StatementKind::EndCase }, end..end);
    }
    reader.out
}

/// The expression of a text; as transitions have it, there may be `:=` or `NAME :=` before and `;` behind it.
pub fn expression(source: &Source, code: &mut Code) -> ExprId {
    let lexemes: Vec<Lexeme> = lex(source).into_iter().map(in_statements).collect();
    let mut rest = lexemes.as_slice();
    if let [one, two, behind @ ..] = rest
        && one.token == Token::Name
        && two.token == Token::Assign
    {
        rest = behind;
    } else if let [one, behind @ ..] = rest
        && one.token == Token::Assign
    {
        rest = behind;
    }
    while let [before @ .., last] = rest
        && last.token == Token::Semicolon
    {
        rest = before;
    }
    parse(source, code, rest)
}

/// The expression that some tokens are.
pub fn parse(source: &Source, code: &mut Code, lexemes: &[Lexeme]) -> ExprId {
    let range = range_of(lexemes).unwrap_or(0..source.text.len());
    if lexemes.is_empty() {
        let span = source.span(range);
        return code.add(ExprKind::Unknown("there is no expression".into()), span);
    }
    let mut builder = Builder { source, code };
    let tokens = lexemes.iter().map(|lexeme| Ok((lexeme.start, lexeme.token, lexeme.end)));
    match grammar::ExpressionParser::new().parse(&mut builder, tokens) {
        Ok(id) => id,
        Err(error) => {
            let at = place(&error, range.end);
            let why =
                format!("it is not understood from `{}` on", excerpt(&source.text[at.min(range.end)..range.end], 40));
            builder.add(range.start, range.end, ExprKind::Unknown(why))
        }
    }
}

/// Words that mean something in declarations and charts only are names among statements.
fn in_statements(lexeme: Lexeme) -> Lexeme {
    let Token::Keyword(keyword) = lexeme.token else { return lexeme };
    if is_of_statements(keyword) { lexeme } else { Lexeme { token: Token::Name, ..lexeme } }
}

fn is_of_statements(keyword: Keyword) -> bool {
    use Keyword::{
        Case, Else, Elsif, EndCase, EndFor, EndIf, EndRepeat, EndWhile, Exit, For, If, Of, Repeat, Return, Then, While,
    };
    matches!(
        keyword,
        If | Then
            | Elsif
            | Else
            | EndIf
            | Case
            | Of
            | EndCase
            | For
            | While
            | Repeat
            | EndFor
            | EndWhile
            | EndRepeat
            | Return
            | Exit
    )
}

/// The range of some tokens.
fn range_of(lexemes: &[Lexeme]) -> Option<Range<usize>> {
    Some(lexemes.first()?.start..lexemes.last()?.end)
}

/// Where an error is.
fn place<E>(error: &lalrpop_util::ParseError<usize, Token, E>, end: usize) -> usize {
    use lalrpop_util::ParseError::{ExtraToken, InvalidToken, UnrecognizedEof, UnrecognizedToken, User};
    match error {
        InvalidToken { location } => *location,
        UnrecognizedEof { .. } | User { .. } => end,
        UnrecognizedToken { token, .. } | ExtraToken { token } => token.0,
    }
}

/// The beginning of a text, in one line.
fn excerpt(text: &str, most: usize) -> String {
    let line: Vec<&str> = text.split_whitespace().collect();
    let line = line.join(" ");
    match line.char_indices().nth(most) {
        Some((at, _)) => format!("{} …", &line[..at]),
        None => line,
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Open {
    If,
    Case,
}

struct Reader<'a> {
    source: &'a Source,
    code: &'a mut Code,
    lexemes: Vec<Lexeme>,
    at: usize,
    /// What has begun and not ended.
    open: Vec<Open>,
    out: Vec<Statement>,
}

impl Reader<'_> {
    fn statement(&mut self) {
        let start = self.at;
        let lexeme = self.lexemes[start];
        match lexeme.token {
            Token::Semicolon => self.at += 1,
            Token::Keyword(Keyword::If) => {
                let condition = self.up_to(Keyword::Then);
                self.open.push(Open::If);
                self.push(StatementKind::If(condition), lexeme.range());
            }
            Token::Keyword(Keyword::Elsif) => {
                let condition = self.up_to(Keyword::Then);
                self.within(Open::If, StatementKind::Elsif(condition), lexeme);
            }
            Token::Keyword(Keyword::Case) => {
                let selector = self.up_to(Keyword::Of);
                self.open.push(Open::Case);
                self.push(StatementKind::Case(selector), lexeme.range());
            }
            Token::Keyword(Keyword::Else) => {
                self.at += 1;
                match self.open.last() {
                    Some(_) => self.push(StatementKind::Else, lexeme.range()),
                    None => self.lost("there is no `IF` to this `ELSE`", lexeme.range()),
                }
            }
            Token::Keyword(Keyword::EndIf) => {
                self.at += 1;
                self.end(Open::If, StatementKind::EndIf, lexeme);
            }
            Token::Keyword(Keyword::EndCase) => {
                self.at += 1;
                self.end(Open::Case, StatementKind::EndCase, lexeme);
            }
            Token::Keyword(Keyword::For | Keyword::While | Keyword::Repeat) => self.skip_loop(),
            Token::Keyword(Keyword::Return | Keyword::Exit) => {
                self.at += 1;
                self.lost("what follows is then not done", lexeme.range());
            }
            Token::Keyword(_) => {
                self.at += 1;
                self.lost("nothing has begun that it ends", lexeme.range());
            }
            _ if self.open.last() == Some(&Open::Case) && self.is_label() => self.label(),
            _ => self.simple(),
        }
    }

    /// The expression between the word here and another one.
    fn up_to(&mut self, word: Keyword) -> ExprId {
        let begin = self.at + 1;
        let rest = &self.lexemes[begin..];
        let length =
            rest.iter().position(|l| matches!(l.token, Token::Keyword(_) | Token::Semicolon)).unwrap_or(rest.len());
        let found = rest.get(length).is_some_and(|l| l.token == Token::Keyword(word));
        let id = if length == 0 {
            let span = self.source.span(self.lexemes[self.at].range());
            self.code.add(ExprKind::Unknown("there is no condition".into()), span)
        } else {
            let lexemes = self.lexemes[begin..begin + length].to_vec();
            parse(self.source, self.code, &lexemes)
        };
        self.at = begin + length + usize::from(found);
        id
    }

    fn within(&mut self, open: Open, kind: StatementKind, lexeme: Lexeme) {
        if self.open.last() == Some(&open) {
            self.push(kind, lexeme.range());
        } else {
            self.lost("nothing has begun that it belongs to", lexeme.range());
        }
    }

    /// The end of what is open; what is open within it ends, too.
    fn end(&mut self, open: Open, kind: StatementKind, lexeme: Lexeme) {
        if !self.open.contains(&open) {
            return self.lost("nothing has begun that it ends", lexeme.range());
        }
        while let Some(inner) = self.open.pop() {
            if inner == open {
                break;
            }
            let mark = if inner == Open::If { StatementKind::EndIf } else { StatementKind::EndCase };
            self.push(mark, lexeme.range());
        }
        self.push(kind, lexeme.range());
    }

    fn skip_loop(&mut self) {
        let start = self.lexemes[self.at].start;
        let mut depth = 0_usize;
        while let Some(lexeme) = self.lexemes.get(self.at) {
            self.at += 1;
            match lexeme.token {
                Token::Keyword(Keyword::For | Keyword::While | Keyword::Repeat) => depth += 1,
                Token::Keyword(Keyword::EndFor | Keyword::EndWhile | Keyword::EndRepeat) => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
        let end = self.lexemes[self.at - 1].end;
        self.lost("it is a loop", start..end);
    }

    /// Whether values and a colon come next.
    fn is_label(&self) -> bool {
        let signs = self.lexemes[self.at..].iter().map(|lexeme| lexeme.token);
        let mut end = signs.skip_while(|token| {
            matches!(
                token,
                Token::Name
                    | Token::Integer
                    | Token::Typed
                    | Token::Point
                    | Token::Range
                    | Token::Comma
                    | Token::Minus
                    | Token::True
                    | Token::False
            )
        });
        end.next() == Some(Token::Colon)
    }

    fn label(&mut self) {
        let start = self.at;
        let length = self.lexemes[start..].iter().position(|l| l.token == Token::Colon).unwrap_or_default();
        let lexemes = self.lexemes[start..start + length].to_vec();
        let mut values = Vec::new();
        for value in lexemes.split(|lexeme| lexeme.token == Token::Comma) {
            let mut ends = value.splitn(2, |lexeme| lexeme.token == Token::Range);
            let from = parse(self.source, self.code, ends.next().unwrap_or_default());
            let to = ends.next().map_or(from, |to| parse(self.source, self.code, to));
            values.push((from, to));
        }
        self.at = start + length + 1;
        let range = range_of(&lexemes).unwrap_or(self.lexemes[start].range());
        self.push(StatementKind::Label(values), range);
    }

    /// An assignment or a call, or what is understood as neither.
    fn simple(&mut self) {
        let start = self.at;
        let rest = &self.lexemes[start..];
        let length =
            rest.iter().position(|l| matches!(l.token, Token::Semicolon | Token::Keyword(_))).unwrap_or(rest.len());
        let lexemes = rest[..length].to_vec();
        self.at = start + length;
        let Some(range) = range_of(&lexemes) else { return };
        let mut builder = Builder { source: self.source, code: &mut *self.code };
        let tokens = lexemes.iter().map(|lexeme| Ok((lexeme.start, lexeme.token, lexeme.end)));
        match grammar::SimpleParser::new().parse(&mut builder, tokens) {
            Ok(kind) => self.push(kind, range),
            Err(_) => self.lost("it is not understood", range),
        }
    }

    fn push(&mut self, kind: StatementKind, range: Range<usize>) {
        let span = self.source.span(range);
        self.out.push(Statement { kind, span });
    }

    fn lost(&mut self, why: &str, range: Range<usize>) {
        let text: String = self.source.text[range.clone()].chars().take(KEPT).collect();
        self.push(StatementKind::Lost { why: why.into(), text }, range);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use grafc_diagnostics::FileId;

    /// The kinds of the statements, in short.
    fn kinds(text: &str) -> String {
        let mut code = Code::default();
        let source = Source::of_range(FileId::default(), text, 0..text.len());
        let kinds = read(&source, &mut code).into_iter().map(|statement| match statement.kind {
            StatementKind::Assign { target, .. } => format!("{target}:="),
            StatementKind::Call(name, arguments) => format!("{name}({})", arguments.len()),
            StatementKind::If(_) => "if".into(),
            StatementKind::Elsif(_) => "elsif".into(),
            StatementKind::Else => "else".into(),
            StatementKind::EndIf => "end".into(),
            StatementKind::Case(_) => "case".into(),
            StatementKind::Label(values) => format!("{}:", values.len()),
            StatementKind::EndCase => "endcase".into(),
            StatementKind::Lost { text, .. } => format!("lost<{text}>"),
        });
        kinds.collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn statements_are_read_one_by_one() {
        assert_eq!(kinds("a := 1; b.c := a AND NOT d; T1(IN := a, PT := T#2s, Q => q);"), "a:= b.c:= T1(3)");
        assert_eq!(
            kinds("IF a THEN b := 1; ELSIF c > 3 THEN b := 2; ELSE b := 3; END_IF;"),
            "if b:= elsif b:= else b:= end"
        );
        assert_eq!(
            kinds("CASE n OF 1: a := 1; 2, 4..6: a := 2; ELSE a := 3; END_CASE"),
            "case 1: a:= 2: a:= else a:= endcase"
        );
        assert_eq!(kinds("Step := 110; CASE Step OF Red: x := 1; END_CASE"), "Step:= case 1: x:= endcase");
    }

    #[test]
    fn what_is_not_understood_is_lost_alone() {
        assert_eq!(kinds("a := ; b := 2;"), "lost<a :=> b:=");
        assert_eq!(kinds("a S= b; c := d"), "lost<a S= b> c:=");
        assert_eq!(
            kinds("FOR i := 1 TO 3 DO WHILE x DO y := 1; END_WHILE END_FOR; b := 2;"),
            "lost<FOR i := 1 TO 3 DO WHILE x DO y := 1; END_WHILE END_FOR> b:="
        );
        assert_eq!(kinds("a := 1 IF b THEN c := 2;"), "a:= if c:= end");
        assert_eq!(kinds("END_IF; a := 1; ELSE"), "lost<END_IF> a:= lost<ELSE>");
        assert_eq!(kinds("FOR i := 1 TO"), "lost<FOR i := 1 TO>");
    }

    #[test]
    fn deep_nesting_is_read() {
        let deep = format!("a := {}b{};", "(".repeat(100_000), ")".repeat(100_000));
        assert_eq!(kinds(&deep), "a:=");
    }
}
