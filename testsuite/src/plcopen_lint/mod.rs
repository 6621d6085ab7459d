//! What must hold of PLCopen XML (TC6, version 2.01) beyond what its schema says: the rules that readers of PLC tools
//! were found to need.
//!
//! A rule is an entry of [`Rule`]. `frame` checks the project around the bodies, `graph` what is drawn in any dialect,
//! `ladder` what is drawn as a ladder, `neutral` what Beremiz needs, `codesys` the form that all exports of CODESYS have. The schema is a check of its own;
//! the order of children is checked here too, since the schema may not be available.

mod codesys;
pub mod document;
mod frame;
mod graph;
mod ladder;
mod neutral;
mod order;

use document::{Document, Id};
use grafc_backends::plcopen::Dialect;

macro_rules! rules {
    ($($(#[doc = $what:literal])* $rule:ident;)*) => {
        /// What must hold.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
        pub enum Rule { $($(#[doc = $what])* $rule,)* }

        impl Rule {
            /// All rules.
            pub const ALL: &'static [Rule] = &[$(Rule::$rule,)*];
        }
    };
}

rules! {
    /// It is XML.
    WellFormed;
    /// Children stand in the order of the schema, and none is unknown.
    Order;
    /// The attributes that the schema demands are there.
    Attributes;
    /// The namespace is that of the dialect.
    Namespace;
    /// A formatted text is one element, in the form of the dialect.
    Text;
    /// A program organisation unit has one body, in one language.
    OneBody;
    /// Names are identifiers of IEC 61131-3.
    Identifier;
    /// Names are unique without regard to case: units, and in each unit variables, steps and actions.
    UniqueName;
    /// A global id is a name of XML, and unique.
    GlobalId;
    /// A derived type is a standard function block or a unit of the file.
    KnownType;
    /// An instance is of a program of the file; intervals are written as the dialect wants them.
    Instance;
    /// A local id is unique in its body.
    LocalId;
    /// A connection comes from an object that is there.
    Reference;
    /// A connection from a block names the pin.
    BlockPin;
    /// A chart begins with an initial step.
    InitialStep;
    /// A jump leads to a step that is there.
    JumpTarget;
    /// A transition has a condition.
    Condition;
    /// A timed qualifier has a duration.
    Duration;
    /// An action names a Boolean variable or an action of the unit.
    ActionReference;
    /// A contact or coil is of a Boolean variable, a block of an instance of its type.
    LadderVariable;
    /// Power comes from a left rail or a block, flows to the right, and gets to every input.
    LadderPower;
    /// A unit has variables.
    NeutralVariables;
    /// There is a configuration with a task.
    NeutralConfiguration;
    /// A pin has one connection; only in LD do several mean `OR`.
    NeutralConnection;
    /// Divergences and convergences are fed as the generator expects it.
    NeutralFeeding;
    /// Branches of a ladder that meet have one contact each, or several each.
    NeutralBranches;
    /// A ladder has no jumps.
    NeutralJump;
    /// Objects have a size, pins a place; what is empty is left out.
    NeutralGeometry;
    /// Local ids count from 0 in document order, and references lead back.
    CodesysNumbering;
    /// Nothing has a place or a size: the tool draws.
    CodesysPlaces;
    /// A condition is wired from the expression right before its transition.
    CodesysCondition;
    /// Pins have the names that the tool gives them.
    CodesysPins;
    /// Divergences are closed by convergences of their kind and width, from the inside out.
    CodesysNesting;
    /// One step, the first, has no input; the chart ends with a jump; each object follows what the tool lets it follow.
    CodesysFlow;
    /// Actions have the attributes and the qualifiers that the tool knows.
    CodesysAction;
    /// Steps, transitions, divergences, jumps and actions have their data.
    CodesysData;
}

/// What is wrong.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Finding {
    /// The rule that is broken.
    pub rule: Rule,
    /// Where and how.
    pub what: String,
}

/// All that is wrong in a document.
pub fn lint(text: &str, dialect: Dialect) -> Vec<Finding> {
    let document = match Document::read(text) {
        Ok(document) => document,
        Err(what) => return vec![Finding { rule: Rule::WellFormed, what }],
    };
    let mut lint = Lint { document: &document, dialect, findings: Vec::new() };
    order::check(&mut lint);
    frame::check(&mut lint);
    graph::check(&mut lint);
    ladder::check(&mut lint);
    match dialect {
        Dialect::Neutral => neutral::check(&mut lint),
        Dialect::Codesys => codesys::check(&mut lint),
    }
    lint.findings
}

/// A document under examination.
struct Lint<'d> {
    document: &'d Document,
    dialect: Dialect,
    findings: Vec<Finding>,
}

impl<'d> Lint<'d> {
    fn find(&mut self, rule: Rule, at: Id, what: &str) {
        let element = self.document.get(at);
        let named = ["name", "localId"].iter().find_map(|key| self.document.attribute(at, key));
        let named = named.map(|name| format!(" `{name}`")).unwrap_or_default();
        self.findings.push(Finding { rule, what: format!("{}{named}: {what}", element.name) });
    }

    /// Reports unless it holds.
    fn demand(&mut self, holds: bool, rule: Rule, at: Id, what: &str) {
        if !holds {
            self.find(rule, at, what);
        }
    }

    /// The graphical bodies.
    fn graphs(&self) -> Vec<Id> {
        let document = self.document;
        ["SFC", "LD", "FBD"].iter().flat_map(|language| document.all(language)).collect()
    }

    /// The value of an attribute, empty if there is none.
    fn value(&self, id: Id, key: &str) -> &'d str {
        self.document.attribute(id, key).unwrap_or_default()
    }
}
