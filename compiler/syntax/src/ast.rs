//! The syntax tree: what the author wrote, losslessly enough to format it.
//!
//! Expressions lie in one arena, children before parents, so that no code walks them by recursion: the depth of
//! nesting is the author's, not ours. Names are as written, without backquotes; nothing is resolved yet. What most
//! elements lack, such as an attached comment, takes a word or two in them; what most have one of lies in them.

use ecow::EcoString;
use grafc_diagnostics::Span;
use index_vec::{IndexVec, define_index_type};
use smallvec::SmallVec;

define_index_type! {
    /// An expression of a [`Chart`].
    pub struct ExprId = u32;
    DISPLAY_FORMAT = "e{}";
    DEBUG_FORMAT = "e{}";
}

/// The arena of expressions.
pub type Exprs = IndexVec<ExprId, Expr>;

/// A whole file.
#[derive(Clone, Debug, Default)]
pub struct Chart {
    /// `chart Name "comment"`, if the file has one.
    pub heading: Option<Heading>,
    /// Declarations, grafcets, and (in a file with a single grafcet) steps and transitions, in source order.
    pub items: Vec<Item>,
    /// All expressions of the file.
    pub exprs: Exprs,
    /// All `//` and `(* *)` comments, in source order.
    pub comments: Vec<Comment>,
    /// The whole text.
    pub span: Span,
    /// Whether nothing was left out, because nothing was wrong.
    pub is_whole: bool,
}

/// `chart Name "comment" evolution scan`.
#[derive(Clone, Debug)]
pub struct Heading {
    /// The chart's name.
    pub name: Name,
    /// The attached comment.
    pub comment: Option<Box<Text>>,
    /// What it chooses of the chart's meaning, each choice once.
    pub options: Vec<ChartOption>,
    /// The whole line.
    pub span: Span,
}

/// `evolution scan`, `initial_actions off`, `bound 400` in the heading.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ChartOption {
    /// What is chosen.
    pub kind: ChartOptionKind,
    /// The choice, its word included.
    pub span: Span,
}

/// What the heading chooses.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ChartOptionKind {
    /// `evolution stable`, `evolution scan`: whether a call is one micro-step.
    Evolution {
        /// Whether it is.
        scan: bool,
    },
    /// `initial_actions on`, `initial_actions off`
    InitialActions(bool),
    /// `bound 400`
    Bound(u32),
}

impl ChartOptionKind {
    /// The word that begins the choice.
    pub fn word(self) -> &'static str {
        match self {
            ChartOptionKind::Evolution { .. } => "evolution",
            ChartOptionKind::InitialActions(_) => "initial_actions",
            ChartOptionKind::Bound(_) => "bound",
        }
    }
}

/// A name, a step label or a designation, without its backquotes.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name; of a numeric label its digits as written.
    pub text: EcoString,
    /// Whether the author put it in backquotes.
    pub quoted: bool,
    /// The place.
    pub span: Span,
}

/// Names in a row: mostly one.
pub type Names = SmallVec<[Name; 1]>;

/// An attached comment (IEC 60848, symbol 30): the string without its quotes and escapes.
#[derive(Clone, Debug)]
pub struct Text {
    /// The text.
    pub text: EcoString,
    /// The place, quotes included.
    pub span: Span,
}

/// A `//` or `(* *)` comment.
#[derive(Clone, Debug)]
pub struct Comment {
    /// The place, delimiters included.
    pub span: Span,
}

/// What stands in a file, a grafcet or an expansion. What there are many of lies in the item itself.
#[derive(Clone, Debug)]
pub enum Item {
    /// `input`, `output`, `var`, `const`.
    Declaration(Declaration),
    /// `grafcet G1 { … }`.
    Grafcet(Box<Grafcet>),
    /// `expansion M3 { … }`.
    Expansion(Box<Expansion>),
    /// Any kind of step.
    Step(Step),
    /// A transition.
    Transition(Transition),
    /// `allow W0409 "reason"`.
    Allow(Box<Allow>),
    /// `assume …`, `assert …`, `reach …`, `final …`.
    Claim(Box<Claim>),
    /// `scenario "one batch" { … }`.
    Scenario(Box<Scenario>),
}

// There are as many as the text has items, and the tree is what takes most room while a text is read.
const _: () = assert!(size_of::<Item>() <= 112);

impl Item {
    /// The whole item.
    pub fn span(&self) -> Span {
        match self {
            Item::Declaration(item) => item.span,
            Item::Grafcet(item) => item.span,
            Item::Expansion(item) => item.span,
            Item::Step(item) => item.span,
            Item::Transition(item) => item.span,
            Item::Allow(item) => item.span,
            Item::Scenario(item) => item.span,
            Item::Claim(item) => item.span,
        }
    }
}

/// `assert "never both valves" : not (VA and VB)`: what is said of a chart and changes nothing in it.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Which keyword.
    pub kind: ClaimKind,
    /// What the author calls it.
    pub text: Option<Box<Text>>,
    /// What is claimed.
    pub body: ClaimBody,
    /// The body as written, on one line and without comments: what a claim without a text is called.
    pub written: EcoString,
    /// The keyword.
    pub keyword: Span,
    /// The whole item.
    pub span: Span,
}

/// The keyword of a claim.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum ClaimKind {
    /// `assume`: true of the inputs of every reaction.
    Assume,
    /// `assert`: true in every state.
    Assert,
    /// `reach`: true in some state.
    Reach,
    /// `final`: a state in which the chart may end.
    Final,
}

impl ClaimKind {
    /// The keyword.
    pub fn keyword(self) -> &'static str {
        match self {
            ClaimKind::Assume => "assume",
            ClaimKind::Assert => "assert",
            ClaimKind::Reach => "reach",
            ClaimKind::Final => "final",
        }
    }
}

/// The forms of what is claimed.
#[derive(Clone, PartialEq, Debug)]
pub enum ClaimBody {
    /// `not (x1 and x2)`
    Condition(ExprId),
    /// `at most one of a, b, c`
    AtMostOne(Vec<ExprId>),
    /// `after X5 : VB`
    After(ExprId, ExprId),
    /// `X6 leads to X11`
    Leads(ExprId, ExprId),
}

/// `scenario "one batch" { 0s : a = 1 -> V  until X5 within 60s }`: a test of the chart, in words of time.
#[derive(Clone, Debug)]
pub struct Scenario {
    /// What it is called.
    pub name: Text,
    /// Its lines, in order.
    pub lines: Vec<ScenarioLine>,
    /// The whole item.
    pub span: Span,
}

/// One line of a scenario.
#[derive(Clone, Debug)]
pub struct ScenarioLine {
    /// When it is, and what is given.
    pub kind: ScenarioLineKind,
    /// What is expected after that, behind `->`.
    pub expected: Vec<Expectation>,
    /// The whole line.
    pub span: Span,
}

/// The forms of lines.
#[derive(Clone, Debug)]
pub enum ScenarioLineKind {
    /// `1s : CS = 1`, `after 8s : TD = 1 ↑`
    At {
        /// The time.
        time: ExprId,
        /// Whether it counts from the line before.
        is_after: bool,
        /// What inputs are given.
        given: Vec<Given>,
    },
    /// `until X11 within 60s`
    Until {
        /// What is waited for.
        condition: ExprId,
        /// How long at most.
        within: ExprId,
    },
}

/// `TD = 1 ↑`
#[derive(Clone, Debug)]
pub struct Given {
    /// The input.
    pub name: Name,
    /// Its value.
    pub value: ExprId,
    /// Where `↑` stands, if it does: in the next scan the input is 0 again.
    pub pulse: Option<Span>,
    /// The whole of it.
    pub span: Span,
}

/// `X2`, `not BM`, `n = 3`
#[derive(Clone, Debug)]
pub struct Expectation {
    /// The variable, also an implicit one.
    pub name: Name,
    /// What it is to be.
    pub value: Expected,
    /// The whole of it.
    pub span: Span,
}

/// What a variable is to be.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Expected {
    /// True.
    True,
    /// False.
    False,
    /// This value.
    Value(ExprId),
}

/// `allow W0409 V "interlocked by hardware"`: a warning that the author has looked at.
#[derive(Clone, Debug)]
pub struct Allow {
    /// The code of the warning.
    pub code: Name,
    /// The declaration that it is about; none if it is meant wherever the item stands.
    pub about: Option<Name>,
    /// Why it is allowed.
    pub reason: Text,
    /// The whole item.
    pub span: Span,
}

/// `input a "comment", b : bool := 0 at %IX0.0`, `retain var n : int`.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Where `retain` is written, if it is: the value is kept over a restart.
    pub retain: Option<Span>,
    /// Which keyword.
    pub kind: DeclarationKind,
    /// The names, each with its attached comment.
    pub names: DeclaredNames,
    /// The type; none if what is written there is none, and has been reported.
    pub ty: Option<Type>,
    /// Where the type is written.
    pub ty_span: Span,
    /// `:= value`.
    pub initial: Option<ExprId>,
    /// `at %IX0.0`; several names count on from it.
    pub address: Option<Box<Text>>,
    /// The whole declaration.
    pub span: Span,
}

/// The keyword of a declaration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DeclarationKind {
    /// `input`
    Input,
    /// `output`
    Output,
    /// `var`
    Variable,
    /// `const`
    Constant,
}

/// One name of a declaration.
#[derive(Clone, Debug)]
pub struct DeclaredName {
    /// The name.
    pub name: Name,
    /// The attached comment.
    pub comment: Option<Box<Text>>,
}

/// The names of a declaration: mostly one.
pub type DeclaredNames = SmallVec<[DeclaredName; 1]>;

/// The elementary types of IEC 61131-3 that charts use.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Type {
    /// `bool`
    Bool,
    /// `int`: 16 bits, signed
    Int,
    /// `dint`: 32 bits, signed
    Dint,
    /// `uint`: 16 bits
    Uint,
    /// `udint`: 32 bits
    Udint,
    /// `real`: IEEE 754 single
    Real,
    /// `lreal`: IEEE 754 double
    Lreal,
    /// `time`: milliseconds
    Time,
}

impl Type {
    /// The keyword.
    pub fn keyword(self) -> &'static str {
        match self {
            Type::Bool => "bool",
            Type::Int => "int",
            Type::Dint => "dint",
            Type::Uint => "uint",
            Type::Udint => "udint",
            Type::Real => "real",
            Type::Lreal => "lreal",
            Type::Time => "time",
        }
    }

    /// Whether it is one of the four types of whole numbers.
    pub fn is_whole(self) -> bool {
        self.whole_range().is_some()
    }

    /// The smallest and the greatest value of a type of whole numbers.
    pub fn whole_range(self) -> Option<(i64, i64)> {
        match self {
            Type::Int => Some((i64::from(i16::MIN), i64::from(i16::MAX))),
            Type::Dint => Some((i64::from(i32::MIN), i64::from(i32::MAX))),
            Type::Uint => Some((0, i64::from(u16::MAX))),
            Type::Udint => Some((0, i64::from(u32::MAX))),
            Type::Bool | Type::Real | Type::Lreal | Type::Time => None,
        }
    }

    /// Whether every value of it is a value of another type.
    pub fn widens_to(self, to: Type) -> bool {
        let wider: &[Type] = match self {
            Type::Int => &[Type::Dint, Type::Real, Type::Lreal],
            Type::Uint => &[Type::Dint, Type::Udint, Type::Real, Type::Lreal],
            Type::Dint | Type::Udint | Type::Real => &[Type::Lreal],
            Type::Bool | Type::Lreal | Type::Time => &[],
        };
        self == to || wider.contains(&to)
    }
}

/// `grafcet X9/G4 "comment" { … }`, `child grafcet P of MAIN { … }`, `automaton A0 { … }`.
#[derive(Clone, Debug)]
pub struct Grafcet {
    /// Whether it is an automaton: its steps are states, of which one is active, and its transitions are arcs in the order in
    /// which they go before each other.
    pub automaton: bool,
    /// What stands before the name: `X9` in `X9/G4`; usually empty or one name. Each still begins with its `X`.
    pub path: Vec<Name>,
    /// The grafcet's name.
    pub name: Name,
    /// Behind `of`, in `child grafcet P of MAIN`: the grafcet whose steps start it.
    pub parent: Option<Name>,
    /// The attached comment.
    pub comment: Option<Box<Text>>,
    /// What is in the braces: steps, transitions, expansions.
    pub items: Vec<Item>,
    /// The whole block.
    pub span: Span,
}

/// `expansion M3 "comment" { … }` (symbol 42).
#[derive(Clone, Debug)]
pub struct Expansion {
    /// The macro-step that it expands.
    pub macro_step: Name,
    /// The attached comment.
    pub comment: Option<Box<Text>>,
    /// What is in the braces: steps, transitions, expansions.
    pub items: Vec<Item>,
    /// The whole block.
    pub span: Span,
}

/// A step of any kind.
#[derive(Clone, Debug)]
pub struct Step {
    /// Plain, enclosing or macro.
    pub kind: StepKind,
    /// What stands before `step`, each word once.
    pub words: Box<[StepWord]>,
    /// The label.
    pub label: Name,
    /// The attached comment.
    pub comment: Option<Box<Text>>,
    /// The actions in its braces.
    pub actions: Box<[Action]>,
    /// The warnings that are allowed in its braces.
    pub allows: Box<[Allow]>,
    /// The whole item.
    pub span: Span,
}

impl Step {
    /// `initial`.
    pub fn is_initial(&self) -> bool {
        self.word(StepMark::Initial).is_some()
    }

    /// `activated`: the step has an activation link (symbol 41).
    pub fn is_activated(&self) -> bool {
        self.word(StepMark::Activated).is_some()
    }

    /// Where a word stands before `step`, if it does.
    pub fn word(&self, mark: StepMark) -> Option<Span> {
        self.words.iter().find(|word| word.meaning == mark).map(|word| word.span)
    }
}

/// A word before `step`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StepWord {
    /// Which.
    pub meaning: StepMark,
    /// Where.
    pub span: Span,
}

/// The words before `step`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StepMark {
    /// `initial`
    Initial,
    /// `activated`
    Activated,
    /// `enclosing`
    Enclosing,
    /// `macro`
    Macro,
}

/// The kinds of step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StepKind {
    /// `step` (symbols 1 and 3)
    Plain,
    /// `enclosing step` (symbols 4 and 5)
    Enclosing,
    /// `macro step` (symbol 6)
    Macro,
}

/// `transition (5) "comment" 1, 2 -> 3 : condition { C := C + 1 }`.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The immediately preceding steps; none for a source transition.
    pub from: Names,
    /// The immediately succeeding steps; none for a sink transition.
    pub to: Names,
    /// The transition-condition.
    pub condition: ExprId,
    /// What it has beside them, if anything.
    more: Option<Box<More>>,
    /// The whole item.
    pub span: Span,
}

/// What many transitions lack.
#[derive(Clone, Debug)]
struct More {
    designation: Option<Box<Name>>,
    comment: Option<Box<Text>>,
    clearing: Clearing,
}

/// What stands in the braces of a transition or an arc.
#[derive(Clone, Debug, Default)]
pub struct Clearing {
    /// Assignments on clearing.
    pub actions: Vec<Assignment>,
    /// Of an arc, the outputs that are published on it.
    pub outputs: Vec<Name>,
    /// Pulse orders on clearing.
    pub pulses: Vec<Pulse>,
    /// The warnings that are allowed there.
    pub allows: Vec<Allow>,
}

impl Transition {
    /// With nothing but what every transition has.
    pub fn new(from: Names, to: Names, condition: ExprId, span: Span) -> Self {
        Transition { from, to, condition, more: None, span }
    }

    /// And what stands before its arcs and behind its condition.
    pub fn with(self, designation: Option<Box<Name>>, comment: Option<Box<Text>>, clearing: Clearing) -> Self {
        let Clearing { actions, outputs, pulses, allows } = &clearing;
        let is_clear = actions.is_empty() && outputs.is_empty() && pulses.is_empty() && allows.is_empty();
        let is_bare = designation.is_none() && comment.is_none() && is_clear;
        Transition { more: (!is_bare).then(|| Box::new(More { designation, comment, clearing })), ..self }
    }

    /// The same with another condition and other assignments, and without outputs of an arc.
    pub fn cleared_by(&self, condition: ExprId, actions: Vec<Assignment>) -> Self {
        let more = self.more.as_deref().cloned();
        let More { designation, comment, clearing } =
            more.unwrap_or(More { designation: None, comment: None, clearing: Clearing::default() });
        let plain = Transition { condition, more: None, ..self.clone() };
        plain.with(designation, comment, Clearing { actions, outputs: Vec::new(), ..clearing })
    }

    /// What is in the parentheses (symbol 8).
    pub fn designation(&self) -> Option<&Name> {
        self.more.as_ref()?.designation.as_deref()
    }

    /// The attached comment.
    pub fn comment(&self) -> &Option<Box<Text>> {
        self.more.as_ref().map_or(&None, |more| &more.comment)
    }

    /// Assignments on clearing.
    pub fn actions(&self) -> &[Assignment] {
        self.more.as_ref().map_or(&[], |more| &more.clearing.actions)
    }

    /// Of an arc of an automaton, the outputs that are published on it.
    pub fn outputs(&self) -> &[Name] {
        self.more.as_ref().map_or(&[], |more| &more.clearing.outputs)
    }

    /// Pulse orders on clearing.
    pub fn pulses(&self) -> &[Pulse] {
        self.more.as_ref().map_or(&[], |more| &more.clearing.pulses)
    }

    /// The warnings that are allowed in its braces.
    pub fn allows(&self) -> &[Allow] {
        self.more.as_ref().map_or(&[], |more| &more.clearing.allows)
    }
}

/// `C := C + 1`.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// What is assigned.
    pub target: Name,
    /// The value; arithmetic (`+` adds).
    pub value: ExprId,
    /// The whole assignment.
    pub span: Span,
}

/// One action in a step's braces.
#[derive(Clone, Debug)]
pub struct Action {
    /// Which form.
    pub kind: ActionKind,
    /// The whole action.
    pub span: Span,
}

/// The forms of action.
#[derive(Clone, Debug)]
pub enum ActionKind {
    /// `V2`, `V2 if d` (symbols 20 to 25).
    Continuous {
        /// The output.
        target: Name,
        /// The assignment condition.
        condition: Option<ExprId>,
    },
    /// `C := C + 1 on activation` (symbols 26 to 29).
    Stored {
        /// What is assigned.
        assignment: Box<Assignment>,
        /// When.
        event: Event,
    },
    /// `start P on activation`
    Pulse {
        /// What is ordered.
        kind: PulseKind,
        /// Of which grafcet.
        grafcet: Box<Name>,
        /// When.
        event: Event,
    },
    /// `run P`: it is started with the step and killed with it.
    Run {
        /// Which grafcet.
        grafcet: Box<Name>,
    },
    /// `force G12{8, 9, 11}` (symbol 37).
    Force {
        /// The forced grafcet.
        grafcet: Box<Name>,
        /// The forced situation.
        situation: Situation,
    },
}

/// `start P`, in the braces of a transition.
#[derive(Clone, Debug)]
pub struct Pulse {
    /// What is ordered.
    pub kind: PulseKind,
    /// Of which grafcet.
    pub grafcet: Name,
    /// The whole order.
    pub span: Span,
}

/// What a pulse order does to its grafcet; in the order in which they take effect.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum PulseKind {
    /// `kill`: nothing of it is active.
    Kill,
    /// `resume`: what was active when it was frozen is so again.
    Resume,
    /// `start`: its initial steps become active.
    Start,
    /// `freeze`: nothing of it is active, until it is resumed.
    Freeze,
}

impl PulseKind {
    /// All of them.
    pub const ALL: [PulseKind; 4] = [PulseKind::Kill, PulseKind::Resume, PulseKind::Start, PulseKind::Freeze];

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            PulseKind::Kill => "kill",
            PulseKind::Resume => "resume",
            PulseKind::Start => "start",
            PulseKind::Freeze => "freeze",
        }
    }
}

/// When a stored action of a step is done.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Event {
    /// `on activation` (symbol 27)
    Activation,
    /// `on deactivation` (symbol 28)
    Deactivation,
    /// `on event ↑a` (symbol 29)
    Event(ExprId),
    /// `each scan`, `each scan if c`: once a scan while the step is active.
    EachScan(Option<ExprId>),
}

/// A forced situation.
#[derive(Clone, Debug)]
pub enum Situation {
    /// `{8, 9, 11}`; `{}` empties the grafcet.
    Steps(Vec<Name>),
    /// `{*}`: the current situation, frozen.
    Current,
    /// `{INIT}`: the initial situation.
    Initial,
}

/// An expression and its place.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it is.
    pub span: Span,
}

/// The forms of expression, of conditions and of arithmetic alike.
#[derive(Clone, PartialEq, Debug)]
pub enum ExprKind {
    /// A variable or an implicit variable.
    Name(EcoString),
    /// `3`, `16#FF`: a whole number; `1` and `0` are also Boolean constants.
    Integer(i64),
    /// `8.5`
    Real(f64),
    /// `3s`, `T#1m30s`, in milliseconds.
    Duration(i64),
    /// `true`, `false`
    Bool(bool),
    /// `( … )`: kept, for the formatter.
    Paren(ExprId),
    /// `[ … ]`: a predicate (symbol 19).
    Predicate(ExprId),
    /// `not a`
    Not(ExprId),
    /// `-a`
    Negate(ExprId),
    /// `↑a` (symbol 15)
    Rise(ExprId),
    /// `↓a` (symbol 16)
    Fall(ExprId),
    /// `a and b`, `C + 1`, `C < N`.
    Binary(BinaryOp, ExprId, ExprId),
    /// `3s/a/7s`, `4s/X27`, `X2/5s`: two or three parts, as written (symbols 17 and 18).
    Delay(Box<[ExprId]>),
    /// A part that could not be read; an error has been reported.
    Error,
}

/// The operators between two operands.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum BinaryOp {
    /// `and`, `·`, `&`
    And,
    /// `or`, `|`, and `+` outside brackets
    Or,
    /// `xor`
    Xor,
    /// `=`
    Equal,
    /// `<>`, `≠`
    NotEqual,
    /// `<`
    Less,
    /// `<=`, `≤`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`, `≥`
    GreaterEqual,
    /// `+` inside brackets and in assignments
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/` inside brackets and in assignments
    Divide,
    /// `mod`
    Modulo,
}
