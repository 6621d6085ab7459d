//! Blocks of Structured Text that were pasted into a chart: each is one mistake, whatever is in it.
//!
//! ```text
//! IF b THEN K := TRUE; ELSE K := FALSE; END_IF;      one message, and the tokens are left out
//! VAR_INPUT a : BOOL; b : BOOL; END_VAR              one message, and the names are declared
//! ```
//!
//! What the block would cost besides is covered: see [`Lexed::covered`].

use crate::context::Braces;
use crate::habits::words::{ITEMS, TYPES, ours};
use crate::lexer::Lexed;
use crate::shown::shorten;
use crate::token::{Lexeme, Token, begins_item};
use grafc_diagnostics::{Code, Diagnostic, FileId, Fix, Span};

/// Words that begin a block, one that stands in it, and those that end it.
const BLOCKS: &[(&str, &str, &str)] = &[
    ("if", "then", "end_if"),
    ("case", "of", "end_case"),
    ("for", "do", "end_for"),
    ("while", "do", "end_while"),
    ("repeat", "until", "end_repeat"),
    ("var", ":", "end_var"),
    ("var_input", ":", "end_var"),
    ("var_output", ":", "end_var"),
    ("var_in_out", ":", "end_var"),
    ("var_temp", ":", "end_var"),
    ("var_global", ":", "end_var"),
    ("var_external", ":", "end_var"),
];

/// A block under way or found.
#[derive(Clone, Copy)]
struct Block {
    /// Its first token, and the one behind its last.
    first: usize,
    end: usize,
    /// Which of [`BLOCKS`].
    kind: usize,
    in_braces: bool,
}

/// Finds pasted blocks, and gives each its message.
pub(crate) fn blocks(file: FileId, text: &str, lexed: &mut Lexed) {
    if !text.contains("END_") && !text.contains("end_") {
        return;
    }
    let found = find(text, &lexed.lexemes);
    if found.is_empty() {
        return;
    }
    let mut kept: Vec<Lexeme> = Vec::with_capacity(lexed.lexemes.len());
    let mut from = 0;
    for block in found {
        let pasted = Pasted { file, text, lexemes: &lexed.lexemes[block.first..block.end], in_braces: block.in_braces };
        kept.extend(&lexed.lexemes[from..block.first]);
        let fault = if BLOCKS[block.kind].2 == "end_var" {
            pasted.declarations(&lexed.comments, &mut kept)
        } else {
            pasted.statement()
        };
        lexed.covered.push((pasted.whole(), fault));
        from = block.end;
    }
    kept.extend(&lexed.lexemes[from..]);
    lexed.lexemes = kept;
    // Within a block nothing is reported a second time, neither by the lexer nor by the parser.
    let covered: Vec<(u32, u32)> = lexed.covered.iter().map(|(span, _)| (span.start, span.end)).collect();
    let is_outside = |start: u32| !is_in(&covered, start);
    lexed.faults.retain(|fault| is_outside(fault.primary.span.start));
    lexed.bad.retain(|(start, _)| is_outside(*start));
    lexed.bad.extend(&covered);
    lexed.bad.sort_unstable();
}

/// Whether a place lies in one of the ranges, which are in order.
pub(crate) fn is_in(ranges: &[(u32, u32)], place: u32) -> bool {
    let before = ranges.partition_point(|(start, _)| *start <= place);
    before.checked_sub(1).is_some_and(|at| place < ranges[at].1)
}

/// The outermost blocks that have an end, in order. An item of ours and a brace end all that is open, and without the
/// words and signs that a block has, its first and last are names.
fn find(text: &str, lexemes: &[Lexeme]) -> Vec<Block> {
    let (mut open, mut found): (Vec<Block>, Vec<Block>) = (Vec::new(), Vec::new());
    // How many blocks of each kind are open: an end without a beginning is not looked for. Where its word was last.
    let (mut begun, mut inner) = ([0usize; BLOCKS.len()], [0usize; BLOCKS.len()]);
    let (mut braces, mut assignment) = (Braces::default(), 0);
    for (at, lexeme) in lexemes.iter().enumerate() {
        braces.pass(lexeme.token);
        match lexeme.token {
            Token::Assign => assignment = at,
            token if begins_item(token) || matches!(token, Token::OpenBrace | Token::CloseBrace) => {
                open.clear();
                begun.fill(0);
            }
            _ => {}
        }
        if !matches!(lexeme.token, Token::Name | Token::If | Token::Var | Token::Colon) {
            continue;
        }
        let word = text[lexeme.start as usize..lexeme.end as usize].to_lowercase();
        for (kind, _) in BLOCKS.iter().enumerate().filter(|(_, (_, within, _))| *within == word) {
            inner[kind] = at;
        }
        if let Some(kind) = BLOCKS.iter().position(|(first, ..)| *first == word) {
            begun[kind] += 1;
            open.push(Block { first: at, end: at, kind, in_braces: braces.of_items > 0 });
        } else if word.starts_with("end_") && (0..BLOCKS.len()).any(|kind| BLOCKS[kind].2 == word && begun[kind] > 0) {
            while let Some(block) = open.pop() {
                begun[block.kind] -= 1;
                if BLOCKS[block.kind].2 != word {
                    continue;
                }
                let has = |place: usize| place > block.first;
                if has(inner[block.kind]) && (word == "end_var" || has(assignment)) {
                    while found.last().is_some_and(|inner| inner.first > block.first) {
                        found.pop();
                    }
                    found.push(Block { end: at + 1, ..block });
                }
                break;
            }
        }
    }
    found
}

/// The tokens of a block.
struct Pasted<'t> {
    file: FileId,
    text: &'t str,
    lexemes: &'t [Lexeme],
    in_braces: bool,
}

impl<'t> Pasted<'t> {
    fn span(&self, from: Lexeme, to: Lexeme) -> Span {
        Span { file: self.file, start: from.start, end: to.end }
    }

    fn word(&self, lexeme: Lexeme) -> &'t str {
        &self.text[lexeme.start as usize..lexeme.end as usize]
    }

    fn is(&self, at: usize, word: &str) -> bool {
        self.lexemes.get(at).is_some_and(|lexeme| self.word(*lexeme).eq_ignore_ascii_case(word))
    }

    /// The block with the semicolon behind it.
    fn whole(&self) -> Span {
        let (first, last) = (self.lexemes[0], self.lexemes[self.lexemes.len() - 1]);
        let span = self.span(first, last);
        let behind = &self.text[span.end as usize..];
        let gap = behind.len() - behind.trim_start().len();
        match behind.trim_start().starts_with(';') {
            true => Span { end: span.end + gap as u32 + 1, ..span },
            false => span,
        }
    }

    fn fault(&self, expected: &str) -> Diagnostic {
        let first = self.lexemes[0];
        let message = format!("expected {expected}, found `{}`", shorten(self.word(first)));
        Diagnostic::new(Code::E0107, self.span(first, first), message)
    }

    fn statement(&self) -> Diagnostic {
        if !self.in_braces {
            return self
                .fault("an item such as `input`, `step` or `transition`")
                .note(
                    "what a program asks in each cycle, a chart says by its steps: what is done stands in their braces",
                )
                .help("say it by steps with actions, `step … { … }`, and by transitions, `transition … -> … : …`");
        }
        let fault = self.fault("an action").note("a step has no statements: its actions hold while it is active");
        match self.in_our_words() {
            Some(right) => fault
                .help(format!("write `{right}`"))
                .fix(Fix::maybe(format!("write `{right}`")).replace(self.whole(), right)),
            None => fault.help(
                "write `K if …` for an output with a condition, `K := … on activation` for what is done once; \
                 where to go on is said by transitions",
            ),
        }
    }

    /// `IF a THEN K := v; END_IF` and `IF a THEN K := TRUE; ELSE K := FALSE; END_IF` as actions.
    fn in_our_words(&self) -> Option<String> {
        let then =
            (1..self.lexemes.len()).find(|at| self.is(*at, "then")).filter(|then| *then > 1 && self.is(0, "if"))?;
        let asked = &self.lexemes[1..then];
        let condition = &self.text[self.span(asked[0], asked[asked.len() - 1]).range()];
        let is_number = |lexeme: &Lexeme| {
            use Token::*;
            matches!(lexeme.token, Equal | NotEqual | Less | LessEqual | Greater | GreaterEqual)
        };
        let condition = match asked.iter().any(is_number) {
            true => format!("[{condition}]"),
            false => condition.to_owned(),
        };
        let set = |at: usize| {
            let [name, sign, value] = self.lexemes.get(at..at + 3)? else { return None };
            let is_set = name.token == Token::Name && sign.token == Token::Assign;
            is_set.then(|| (self.word(*name), value))
        };
        let (target, value) = set(then + 1)?;
        if self.is(then + 4, "end_if") {
            return Some(format!("{target} := {} on event ↑({condition})", self.word(*value)));
        }
        let (other, otherwise) = set(then + 5).filter(|_| self.is(then + 4, "else") && self.is(then + 8, "end_if"))?;
        let is_condition = value.token == Token::True && otherwise.token == Token::False && target == other;
        is_condition.then(|| format!("{target} if {condition}"))
    }

    /// The declarations of a `VAR … END_VAR`; their tokens go into `kept` as those of declarations of ours.
    fn declarations(&self, comments: &[Lexeme], kept: &mut Vec<Lexeme>) -> Diagnostic {
        let mut word = match self.word(self.lexemes[0]).to_lowercase().as_str() {
            "var" | "var_in_out" | "var_external" => "var",
            word => ours(ITEMS, word).unwrap_or("var"),
        };
        let (mut retain, mut from) = (false, 1);
        while let Some(mark) =
            ["retain", "constant", "persistent", "non_retain"].iter().find(|mark| self.is(from, mark))
        {
            match *mark {
                "retain" => retain = true,
                "constant" => word = "const",
                _ => {}
            }
            from += 1;
        }
        let token = match word {
            "input" => Token::Input,
            "output" => Token::Output,
            "const" => Token::Const,
            _ => Token::Var,
        };
        let head = if retain { format!("retain {word}") } else { word.to_owned() };
        let body = &self.lexemes[from..self.lexemes.len() - 1];
        let mut rights = Vec::new();
        let mut start = 0;
        for at in 0..body.len() {
            let next = body.get(at + 1);
            let gap = next.map_or(";", |next| &self.text[body[at].end as usize..next.start as usize]);
            if !gap.contains(';') {
                continue;
            }
            let declaration = &body[start..=at];
            let place = declaration[0].start;
            let synthetic = |token| Lexeme { token, start: place, end: place };
            kept.extend(retain.then(|| synthetic(Token::Retain)));
            kept.push(synthetic(token));
            kept.extend(declaration);
            rights.push(format!("{head} {}", self.declaration(declaration)));
            start = at + 1;
        }
        let whole = self.whole();
        let fault = self.fault("an item such as `input`, `step` or `transition`");
        let example = rights.first().cloned().unwrap_or_else(|| format!("{head} … : …"));
        let fault = fault.help(format!("each declaration begins with its word, and nothing ends it: `{example}`"));
        let has_comments = comments.iter().any(|comment| whole.start <= comment.start && comment.start < whole.end);
        match rights.is_empty() || has_comments {
            true => fault,
            false => fault.fix(Fix::maybe(format!("write `{head}` before each")).replace(whole, rights.join("\n"))),
        }
    }

    /// A declaration with its type as it is written here.
    fn declaration(&self, tokens: &[Lexeme]) -> String {
        let written = self.span(tokens[0], tokens[tokens.len() - 1]);
        let text = &self.text[written.range()];
        let colon = tokens.iter().position(|lexeme| lexeme.token == Token::Colon);
        let Some(ty) = colon.and_then(|at| tokens.get(at + 1)) else { return text.to_owned() };
        let lower = self.word(*ty).to_lowercase();
        let known = TYPES.iter().map(|(known, _)| *known).find(|known| *known == lower);
        let Some(known) = known.or_else(|| ours(TYPES, self.word(*ty))) else { return text.to_owned() };
        let (start, end) = ((ty.start - written.start) as usize, (ty.end - written.start) as usize);
        format!("{}{known}{}", &text[..start], &text[end..])
    }
}

#[cfg(test)]
mod tests {
    use grafc_diagnostics::FileId;

    fn messages(text: &str) -> usize {
        crate::parse(FileId::new(0), text).1.iter().count()
    }

    #[test]
    fn blocks_within_blocks_are_one() {
        let inner = "IF a THEN K := 1; ELSIF b THEN K := 2; END_IF;";
        assert_eq!(messages(&format!("step 1 {{ IF c THEN {inner} FOR i := 1 TO 3 DO {inner} END_FOR; END_IF; }}")), 1);
        assert_eq!(messages(&format!("step 1 {{ {inner} {inner} }}")), 2);
        assert_eq!(messages(&format!("step 1 {{ {inner} }}\nstep 2 {{ V + }}")), 2);
    }

    #[test]
    fn what_does_not_end_is_no_block() {
        // Names are names: only with an end they are a block.
        assert_eq!(messages("step 1 { IF CASE FOR }"), 0);
        assert_eq!(messages("step 1 { IF END_CASE END_IF }"), 0);
        assert_eq!(messages("step 1 { V if a }\ninput end_if, END_VAR : bool\nvar `if` : bool\nvar b : bool"), 0);
        let named = "step 1 { V if a  n := 1 on activation  then  end_if }";
        assert_eq!(messages(named), 1, "the words of a block, in its order");
        assert_eq!(messages("step 1 { V if a  n := 1 on activation  end_if }"), 0);
        assert_eq!(messages("step 1 { V if a  n := 1 on activation }\ntransition 1 -> 2 : end_if and then"), 0);
    }

    /// Neither many beginnings nor many ends take more than a look each.
    #[test]
    fn many_blocks_take_no_longer_than_their_text() {
        let begins = "IF ".repeat(50_000);
        for ends in ["END_CASE ".repeat(50_000), "END_IF ".repeat(50_000)] {
            assert!(messages(&format!("step 1 {{ {begins}{ends} }}")) <= 201);
        }
    }
}
