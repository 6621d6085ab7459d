//! Words that are words of the language in some places only, and names in all others, so that a chart that uses them as
//! names stays correct.
//!
//! `allow` begins an item where a name follows it: outside of the braces of steps and transitions no two names follow
//! each other. In these braces two names are two actions, but no string follows a name there, so `allow W0409 "reason"`
//! cannot be anything else.
//!
//! `assume`, `assert`, `reach` and `final` begin a claim where an item can begin: outside of these braces and of the head
//! of a transition, behind what may end an item. In a claim, `at most one of`, `after` and `leads to` are words where two
//! names would follow each other.
//!
//! In the heading, `evolution`, `initial_actions` and `bound` are words behind the name of the chart and its comment. `each
//! scan` is two words behind a value that is assigned in the braces of a step or transition, where no name can stand.
//!
//! `child grafcet NAME of` is recognised as a whole, and so is `start NAME on`, `kill`, `freeze` and `resume` alike, in the
//! braces of a step; in those of a transition such a word before a name that nothing is assigned to. `run NAME` is an order
//! in the braces of a step, in a text that declares no `run`.
//!
//! `scenario` begins an item where a string and a brace follow it. In its braces `until`, and `after` before a time, begin a
//! line, except where a name must stand: behind a comma, `->`, `not`. Behind `until` all is a condition, up to `within`
//! before a time.
//!
//! What `automaton`, `state` and `arc` are, `automaton` says.

use crate::automaton::{self, Automaton};
use crate::scenario::Scenario;
use crate::token::{Lexeme, Token, begins_item, declares, is_claim, may_end_item, opens_block};

/// Finds the words among the names.
pub(crate) fn words(text: &str, lexemes: &mut [Lexeme]) {
    let mut braces = Braces::default();
    let mut scenario = Scenario::default();
    // Asked once, and only where somebody says `run`.
    let mut run_is_declared = None;
    let mut automaton = Automaton::default();
    for at in 0..lexemes.len() {
        if lexemes[at].token == Token::On && at > 0 && lexemes[at - 1].token == Token::InitialActions {
            lexemes[at].token = Token::Name;
        } else if lexemes[at].token == Token::Name {
            let place = Place { text, lexemes: &*lexemes, at, braces: &braces };
            match place.bytes() {
                // Most names are no words, and many are numbered.
                [.., b'0'..=b'9'] if !scenario.is_open() && !automaton.is_open() => continue,
                _ if scenario.is_open() => {
                    let found = scenario.word(place.word(0), place.before(1), place.token(1));
                    found.into_iter().for_each(|token| lexemes[at].token = token);
                }
                b"automaton" if braces.of_items == 0 && automaton::begins(lexemes, at) => {
                    automaton.begin();
                    lexemes[at].token = Token::Grafcet;
                }
                b"scenario" if place.is_scenario() => lexemes[at].token = Token::Scenario,
                b"allow" => place.allow().into_iter().for_each(|token| lexemes[at].token = token),
                b"assume" | b"assert" | b"reach" | b"final" => {
                    place.claim().into_iter().for_each(|token| lexemes[at].token = token);
                }
                b"at" if place.is_at_most_one() => {
                    let words = [Token::AtMost, Token::Most, Token::One, Token::Of];
                    lexemes[at..].iter_mut().zip(words).for_each(|(lexeme, word)| lexeme.token = word);
                }
                b"after" if place.is_after() => lexemes[at].token = Token::After,
                b"leads" if place.is_leads_to() => {
                    (lexemes[at].token, lexemes[at + 1].token) = (Token::Leads, Token::LeadsTo);
                }
                b"evolution" if place.is_option() => lexemes[at].token = Token::Evolution,
                b"initial_actions" if place.is_option() => lexemes[at].token = Token::InitialActions,
                b"bound" if place.is_option() => lexemes[at].token = Token::Bound,
                b"child" if place.is_child() => {
                    (lexemes[at].token, lexemes[at + 3].token) = (Token::Child, Token::Of);
                }
                b"start" if place.is_pulse() => lexemes[at].token = Token::Start,
                b"kill" if place.is_pulse() => lexemes[at].token = Token::Kill,
                b"freeze" if place.is_pulse() => lexemes[at].token = Token::Freeze,
                b"resume" if place.is_pulse() => lexemes[at].token = Token::Resume,
                b"run"
                    if place.is_run() && !*run_is_declared.get_or_insert_with(|| declares_run(text, place.lexemes)) =>
                {
                    lexemes[at].token = Token::Run
                }
                b"each" if place.is_each_scan() => {
                    (lexemes[at].token, lexemes[at + 1].token) = (Token::Each, Token::Scan);
                }
                _ => {
                    let found = automaton.word(place.word(0), lexemes, at);
                    found.into_iter().for_each(|token| lexemes[at].token = token);
                }
            }
        }
        // A name that stays one changes nothing.
        if lexemes[at].token != Token::Name {
            scenario.pass(lexemes[at].token);
            automaton.pass(lexemes[at].token);
            braces.pass(lexemes[at].token);
        }
    }
}

/// Whether a declaration names `run`.
fn declares_run(text: &str, lexemes: &[Lexeme]) -> bool {
    let mut in_names = false;
    lexemes.iter().any(|lexeme| {
        match lexeme.token {
            token if declares(token) => in_names = true,
            Token::Colon => in_names = false,
            _ => {}
        }
        let name = &text[lexeme.start as usize..lexeme.end as usize];
        in_names && lexeme.token == Token::Name && matches!(name, "run" | "`run`")
    })
}

/// A name among the tokens.
#[derive(Clone, Copy)]
struct Place<'t> {
    text: &'t str,
    lexemes: &'t [Lexeme],
    at: usize,
    braces: &'t Braces,
}

impl<'t> Place<'t> {
    /// The token so many behind it.
    fn token(self, behind: usize) -> Option<Token> {
        self.lexemes.get(self.at + behind).map(|lexeme| lexeme.token)
    }

    /// The token so many before it.
    fn before(self, count: usize) -> Option<Token> {
        Some(self.lexemes[self.at.checked_sub(count)?].token)
    }

    /// Its own name.
    fn bytes(self) -> &'t [u8] {
        let lexeme = &self.lexemes[self.at];
        &self.text.as_bytes()[lexeme.start as usize..lexeme.end as usize]
    }

    /// The name so many behind it; empty if that is none.
    fn word(self, behind: usize) -> &'t str {
        match self.lexemes.get(self.at + behind) {
            Some(lexeme) if lexeme.token == Token::Name => &self.text[lexeme.start as usize..lexeme.end as usize],
            _ => "",
        }
    }

    /// Whether an item can begin here, as far as what stands before tells.
    fn may_begin(self) -> bool {
        self.before(1).is_none_or(may_end_item)
    }

    fn allow(self) -> Option<Token> {
        let follows = |n: usize, token: Token| self.token(n) == Some(token);
        let with_reason = follows(1, Token::Name)
            && (follows(2, Token::String) || follows(2, Token::Name) && follows(3, Token::String));
        if self.braces.of_items > 0 {
            return with_reason.then_some(Token::AllowInside);
        }
        (follows(1, Token::Name) && self.may_begin()).then_some(Token::Allow)
    }

    fn is_scenario(self) -> bool {
        let follows = (self.token(1), self.token(2)) == (Some(Token::String), Some(Token::OpenBrace));
        follows && self.braces.of_items == 0 && self.may_begin()
    }

    fn claim(self) -> Option<Token> {
        let claim = match self.word(0) {
            "assume" => Token::Assume,
            "assert" => Token::Assert,
            "reach" => Token::Reach,
            _ => Token::Final,
        };
        let has_text = (self.token(1), self.token(2)) == (Some(Token::String), Some(Token::Colon));
        let begins = if self.braces.of_items > 0 {
            // Nothing else has a string behind a name there: a brace is missing.
            has_text && self.may_begin()
        } else {
            // `allow W0409 assert "reason"` is about a variable of that name.
            let is_allowed = self.before(2) == Some(Token::Allow) && self.token(1) == Some(Token::String) && !has_text;
            !self.braces.in_head_of_transition && !is_allowed && self.may_begin()
        };
        begins.then_some(claim)
    }

    /// Whether what is claimed begins here.
    fn begins_body(self) -> bool {
        let before = self.before(1);
        before.is_some_and(is_claim)
            || before == Some(Token::Colon)
                && self.before(2) == Some(Token::String)
                && self.before(3).is_some_and(is_claim)
    }

    fn is_at_most_one(self) -> bool {
        self.begins_body() && (self.word(1), self.word(2), self.word(3)) == ("most", "one", "of")
    }

    /// `after X5 : …`, and what is wrong with it only in that something else than a name follows.
    fn is_after(self) -> bool {
        let operand = match self.token(1) {
            Some(Token::Name) => self.token(2) == Some(Token::Colon),
            Some(
                Token::OpenParen
                | Token::OpenBracket
                | Token::Not
                | Token::Rise
                | Token::Fall
                | Token::Whole
                | Token::True
                | Token::False,
            ) => true,
            _ => false,
        };
        operand && self.begins_body()
    }

    /// Behind the name of the chart.
    fn is_option(self) -> bool {
        self.braces.in_heading
            && !matches!(self.before(1), Some(Token::Chart | Token::Evolution | Token::InitialActions))
    }

    /// `child grafcet NAME of`.
    fn is_child(self) -> bool {
        let follows = (self.token(1), self.token(2), self.word(3)) == (Some(Token::Grafcet), Some(Token::Name), "of");
        follows && self.may_begin()
    }

    /// Whether an action can begin here, in the braces of an item.
    fn may_begin_action(self) -> bool {
        let ends_action = |token| matches!(token, Token::Activation | Token::Deactivation);
        self.braces.of_items > 0 && (self.may_begin() || self.before(1).is_some_and(ends_action))
    }

    /// `start NAME on` in the braces of a step, `start NAME` in those of a transition.
    fn is_pulse(self) -> bool {
        if self.token(1) != Some(Token::Name) || !self.may_begin_action() {
            return false;
        }
        if self.braces.of_transition { self.token(2) != Some(Token::Assign) } else { self.token(2) == Some(Token::On) }
    }

    /// `run NAME` in the braces of a step.
    fn is_run(self) -> bool {
        // `run P := 1` is two names as well.
        let follows = self.token(1) == Some(Token::Name) && self.token(2) != Some(Token::Assign);
        follows && !self.braces.of_transition && self.may_begin_action()
    }

    /// Behind a value that is assigned, where its event would stand.
    fn is_each_scan(self) -> bool {
        self.braces.in_value && self.word(1) == "scan" && self.before(1).is_some_and(may_end_item)
    }

    fn is_leads_to(self) -> bool {
        self.braces.in_claim && self.word(1) == "to" && self.before(1).is_some_and(may_end_item)
    }
}

/// The braces that are open.
#[derive(Default)]
pub(crate) struct Braces {
    /// The head of a grafcet or an expansion was read, its brace follows.
    in_head_of_block: bool,
    /// The `:` of a transition was not read yet.
    in_head_of_transition: bool,
    in_claim: bool,
    /// The heading of the chart was begun, and no other item since.
    in_heading: bool,
    /// Behind `:=` in the braces of a step or transition; its event has not been read yet.
    in_value: bool,
    /// Whether those of items are a transition's.
    of_transition: bool,
    /// Those of steps, transitions and forced situations.
    pub(crate) of_items: usize,
}

impl Braces {
    pub(crate) fn pass(&mut self, token: Token) {
        match token {
            token if opens_block(token) => *self = Braces { in_head_of_block: true, ..Braces::default() },
            Token::Transition => {
                *self = Braces { in_head_of_transition: true, of_transition: true, ..Braces::default() };
            }
            token if is_claim(token) => *self = Braces { in_claim: true, ..Braces::default() },
            Token::Chart => *self = Braces { in_heading: true, ..Braces::default() },
            Token::Colon => self.in_head_of_transition = false,
            Token::Assign => self.in_value = self.of_items > 0,
            Token::On | Token::Scan | Token::If | Token::Force => self.in_value = false,
            Token::OpenBrace if self.in_head_of_block => self.in_head_of_block = false,
            Token::OpenBrace => self.of_items += 1,
            // That of a block, if no other is open.
            Token::CloseBrace => {
                self.of_items = self.of_items.saturating_sub(1);
                self.in_value = false;
            }
            // No item begins within the braces of another: one is missing.
            token if begins_item(token) => *self = Braces::default(),
            _ => {}
        }
    }
}
