//! What is declared where, and which names refer to it.
//!
//! Definition, references, renaming, hover and completion of an editor are questions to these lists. They are filled
//! while names are resolved, so they say what the compiler takes a name for, also in a chart with errors.

use crate::chart::{GrafcetId, MacroId, Node, StepId, TransitionId, VariableId};
use grafc_diagnostics::Span;
use index_vec::{IndexVec, index_vec};

/// Something that a text declares; the [`Tables`](crate::chart::Tables) say more of it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Entity {
    /// The chart itself, by its heading.
    Chart,
    /// An input, an output, an internal variable or a constant.
    Variable(VariableId),
    /// A partial grafcet.
    Grafcet(GrafcetId),
    /// A step.
    Step(StepId),
    /// A macro-step.
    Macro(MacroId),
    /// A transition.
    Transition(TransitionId),
}

impl From<Node> for Entity {
    fn from(node: Node) -> Self {
        match node {
            Node::Step(id) => Entity::Step(id),
            Node::Macro(id) => Entity::Macro(id),
        }
    }
}

/// Where something is declared.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Definition {
    /// What.
    pub entity: Entity,
    /// Its name, label or designation; none of a transition without one, and of a grafcet that no block declares.
    pub name: Option<Span>,
    /// The whole item; of a variable its whole declaration, which may declare others too.
    pub whole: Span,
}

/// How a name is made of what it refers to.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Form {
    /// It is the name itself.
    Name,
    /// `X` before the label: the activity.
    Activity,
    /// `T` before the label: the duration.
    Duration,
    /// `F` before the name of a grafcet: whether it is frozen.
    Frozen,
}

impl Form {
    /// What stands before the name or label.
    pub fn prefix(self) -> &'static str {
        match self {
            Form::Name => "",
            Form::Activity => "X",
            Form::Duration => "T",
            Form::Frozen => "F",
        }
    }
}

/// What a name is used for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Role {
    /// Its value is read, in a condition, a value or a delay.
    Read,
    /// An action assigns to it.
    Assigned,
    /// The step is before a transition.
    Before,
    /// The step is after a transition.
    After,
    /// An order forces the grafcet, or to a situation with the step.
    Forced,
    /// A pulse order is given to the grafcet.
    Commanded,
    /// The grafcet has the child.
    Parent,
    /// The step encloses a grafcet.
    Enclosing,
    /// An `expansion` block expands the macro-step.
    Expanded,
    /// A warning about it is allowed.
    Allowed,
}

/// A name that refers to something.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Use {
    /// The name as written, backquotes and all.
    pub span: Span,
    /// What it refers to.
    pub entity: Entity,
    /// How it is written.
    pub form: Form,
    /// What for.
    pub role: Role,
}

/// What a name would have to be in its place.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Wanted {
    /// A variable, an activity or a duration.
    Value,
    /// A variable that can be assigned to.
    Target,
    /// A step or macro-step.
    Step,
    /// A step, by its activity `X9`.
    EnclosingStep,
    /// A macro-step.
    MacroStep,
    /// A grafcet.
    Grafcet,
    /// Any declared variable.
    Declaration,
}

impl Wanted {
    /// Whether a name of it could stand there.
    pub fn admits(self, entity: Entity) -> bool {
        match self {
            Wanted::Value => !matches!(entity, Entity::Chart | Entity::Transition(_)),
            Wanted::Target | Wanted::Declaration => matches!(entity, Entity::Variable(_)),
            Wanted::Step => matches!(entity, Entity::Step(_) | Entity::Macro(_)),
            Wanted::EnclosingStep => matches!(entity, Entity::Step(_)),
            Wanted::MacroStep => matches!(entity, Entity::Macro(_)),
            Wanted::Grafcet => matches!(entity, Entity::Grafcet(_)),
        }
    }
}

/// Where a variable is used first; none where it is not.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Usage {
    /// Where it is read, in a condition, a value, a delay, another declaration.
    pub(crate) read: Option<Span>,
    /// Where an action sets it.
    pub(crate) set: Option<Span>,
}

impl Usage {
    fn add(&mut self, span: Span, role: Role) {
        let place = match role {
            Role::Read => &mut self.read,
            Role::Assigned => &mut self.set,
            Role::Before
            | Role::After
            | Role::Forced
            | Role::Commanded
            | Role::Parent
            | Role::Enclosing
            | Role::Expanded
            | Role::Allowed => return,
        };
        let first = place.get_or_insert(span);
        *first = (*first).min(span);
    }
}

/// A name that refers to nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Unresolved {
    /// The name as written.
    pub span: Span,
    /// What it would have to be.
    pub wanted: Wanted,
}

/// What stands at a place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mention {
    /// The name of something, where it is declared.
    Definition(Definition),
    /// A name that refers to something.
    Use(Use),
    /// A name that refers to nothing.
    Unresolved(Unresolved),
}

/// The declarations of a text and the names in it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Symbols {
    /// Whether anybody asks for what follows: who compiles asks for the first uses of variables alone.
    are_asked_for: bool,
    /// How each variable is used.
    pub(crate) usage: IndexVec<VariableId, Usage>,
    /// In order of their entities: the chart, variables, grafcets, steps, macro-steps, transitions.
    pub(crate) definitions: Vec<Definition>,
    /// In order of place, once the text has been read.
    pub(crate) uses: Vec<Use>,
    /// In order of place, once the text has been read.
    pub(crate) unresolved: Vec<Unresolved>,
}

impl Symbols {
    /// None yet.
    pub(crate) fn new() -> Self {
        Symbols { are_asked_for: true, ..Symbols::unasked() }
    }

    /// None ever, but for the first uses of variables.
    pub(crate) fn unasked() -> Self {
        let (usage, definitions, uses, unresolved) = (IndexVec::new(), Vec::new(), Vec::new(), Vec::new());
        Symbols { are_asked_for: false, usage, definitions, uses, unresolved }
    }

    /// There are so many variables, and so many names may refer to something.
    pub(crate) fn expect(&mut self, variables: usize, uses: usize) {
        self.usage = index_vec![Usage::default(); variables];
        self.uses.reserve(if self.are_asked_for { uses } else { 0 });
    }

    /// All declarations: the chart, variables, grafcets, steps, macro-steps, transitions, each kind in order of the text.
    pub fn definitions(&self) -> &[Definition] {
        &self.definitions
    }

    /// All names that refer to something, in order of place.
    pub fn uses(&self) -> &[Use] {
        &self.uses
    }

    /// All names that refer to nothing, in order of place.
    pub fn unresolved(&self) -> &[Unresolved] {
        &self.unresolved
    }

    /// Where something is declared. Of two declarations with one name each has its own.
    pub fn definition(&self, entity: Entity) -> Option<&Definition> {
        let at = self.definitions.binary_search_by_key(&entity, |definition| definition.entity).ok()?;
        Some(&self.definitions[at])
    }

    /// The names that refer to something, in order of place.
    pub fn uses_of(&self, entity: Entity) -> impl Iterator<Item = &Use> {
        self.uses.iter().filter(move |found| found.entity == entity)
    }

    /// What is named at a byte, or right before it.
    pub fn at(&self, byte: u32) -> Option<Mention> {
        let touches = |span: Span| span.start <= byte && byte <= span.end;
        let last = |before: usize| before.checked_sub(1);
        // Names do not overlap, so only the last that starts before the byte can touch it.
        let found = last(self.uses.partition_point(|found| found.span.start <= byte)).map(|at| self.uses[at]);
        if let Some(found) = found.filter(|found| touches(found.span)) {
            return Some(Mention::Use(found));
        }
        let missing = last(self.unresolved.partition_point(|missing| missing.span.start <= byte));
        if let Some(missing) = missing.map(|at| self.unresolved[at]).filter(|missing| touches(missing.span)) {
            return Some(Mention::Unresolved(missing));
        }
        let definition = self.definitions.iter().find(|definition| definition.name.is_some_and(touches));
        definition.copied().map(Mention::Definition)
    }

    /// What a name in such a place could refer to, in order of declaration.
    pub fn candidates(&self, wanted: Wanted) -> impl Iterator<Item = &Definition> {
        self.definitions.iter().filter(move |definition| wanted.admits(definition.entity))
    }

    /// A name was resolved.
    pub(crate) fn used(&mut self, span: Span, entity: impl Into<Entity>, form: Form, role: Role) {
        let entity = entity.into();
        if let Entity::Variable(id) = entity {
            self.usage[id].add(span, role);
        }
        if self.are_asked_for {
            self.uses.push(Use { span, entity, form, role });
        }
    }

    /// A name could not be resolved.
    pub(crate) fn missed(&mut self, span: Span, wanted: Wanted) {
        if self.are_asked_for {
            self.unresolved.push(Unresolved { span, wanted });
        }
    }

    /// Brings the names into order, once all have been resolved.
    pub(crate) fn sort(&mut self) {
        // Names are resolved kind by kind: what is read in declarations, then arcs, then what is in conditions and actions.
        self.uses.sort_by_key(|found| found.span);
        self.unresolved.sort_by_key(|missing| missing.span);
    }
}
