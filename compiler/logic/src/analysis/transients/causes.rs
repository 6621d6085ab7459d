//! The graph of causes: what can happen in a micro-step, and what can have brought it about.

use grafc_model::chart::{Event, ExprId, GrafcetId, MacroId, Mode, StepId, Stored, TransitionId, VariableId};
use grafc_net::Net;
use grafc_net::net::Grafcet;
use index_vec::IndexVec;

/// Something that can happen in a micro-step k, said of k > 1; in the first micro-step anything counts that is so at
/// all.
///
/// Values of expressions, wires, macro-steps and grafcets are compared with those of the context before: what a
/// micro-step does to a step or a stored variable shows in them in the next one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Change {
    /// The transition clears and did not in the micro-step before; if it waits for an edge, just that it clears.
    Clears(TransitionId),
    /// The transition does not clear and did in the micro-step before, although its grafcet is neither frozen nor
    /// within an inactive step.
    Stops(TransitionId),
    /// The step is active after the micro-step and was not before.
    Activated(StepId),
    /// The same, and an activation link or an order did it.
    Placed(StepId),
    /// The step is not active after the micro-step and was before.
    Deactivated(StepId),
    /// The order of that rank comes into force, or its grafcet comes within an active step while it is in force.
    Obeyed(GrafcetId, usize),
    /// The step of an order that wins over the one of that rank is deactivated.
    Overruled(GrafcetId, usize),
    /// An order that forces certain steps of the grafcet comes into force.
    Forced(GrafcetId),
    /// The step of an order on the grafcet, or on one that it is frozen with, is activated.
    Frozen(GrafcetId),
    /// An order on the grafcet that forced certain steps ends.
    Released(GrafcetId),
    /// Another order that froze the grafcet ends.
    Thawed(GrafcetId),
    /// The value of an expression.
    Expr(ExprId, Way),
    /// A stored variable is given another value; or the value of a wire.
    Variable(VariableId, Way),
    /// The activity of a macro-step.
    Macro(MacroId, Way),
    /// The activity of a grafcet.
    Grafcet(GrafcetId, Way),
    /// The event of a stored action, the one of that number, occurs.
    Occurs(usize),
    /// A stored action on clearing, done in the micro-step before, is done again with another outcome.
    Differs(usize),
    /// A stored action on the variable, done in the micro-step before, is not done any more.
    Subsides(VariableId),
}

/// Which way a value changes. Numbers that may change at all may change either way.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Way {
    Up,
    Down,
}

impl Way {
    pub(super) const BOTH: [Way; 2] = [Way::Up, Way::Down];

    pub(super) fn other(self) -> Way {
        match self {
            Way::Up => Way::Down,
            Way::Down => Way::Up,
        }
    }
}

/// Changes by number, and which can cause which.
pub(super) struct Causes {
    numbers: Numbers,
    /// Causes and effects.
    edges: Vec<(u32, Effect)>,
    /// Changes that need no cause in the first micro-step.
    pub(super) at_start: Vec<u32>,
}

impl Causes {
    /// With room for what a net of this size usually has.
    pub(super) fn new(net: &Net) -> Causes {
        let size = 4 * (net.places.len() + net.transitions.len());
        Causes { numbers: Numbers::new(net), edges: Vec::with_capacity(size), at_start: Vec::new() }
    }

    /// `cause` can cause `effect` in the same micro-step.
    pub(super) fn at_once(&mut self, cause: Change, effect: Change) {
        self.edge(cause, effect, false);
    }

    /// `cause` can cause `effect` in the next micro-step.
    pub(super) fn next(&mut self, cause: Change, effect: Change) {
        self.edge(cause, effect, true);
    }

    /// What is new at the start of the reaction can cause it in the first micro-step.
    pub(super) fn start(&mut self, change: Change) {
        self.at_start.push(self.number(change));
    }

    /// How many changes there are.
    pub(super) fn len(&self) -> usize {
        self.numbers.all as usize
    }

    /// Whether anything but a clearing activates steps.
    pub(super) fn places_steps(&self) -> bool {
        self.numbers.placed < self.numbers.deactivated
    }

    /// The number of a change.
    pub(super) fn number(&self, change: Change) -> u32 {
        self.numbers.of(change)
    }

    /// The transition that clears with the change of a number, whether it cleared before or not.
    pub(super) fn transition(&self, net: &Net, number: u32) -> Option<TransitionId> {
        let within = |begin: u32, size: usize| number.checked_sub(begin).map(|n| n as usize).filter(|n| *n < size);
        if let Some(t) = within(self.numbers.clears, net.transitions.len()) {
            return Some(TransitionId::from_usize(t));
        }
        match net.stored[within(self.numbers.differs, net.stored.len())?].event {
            Event::Clearing(t) => Some(t),
            Event::Event(..) | Event::Deactivation(_) | Event::Activation(_) | Event::EachScan(..) => None,
        }
    }

    /// The effects of each change, once all are known.
    pub(super) fn take_effects(&mut self) -> Effects {
        Effects::new(self.len(), &std::mem::take(&mut self.edges))
    }

    fn edge(&mut self, cause: Change, effect: Change, next: bool) {
        self.edges.push((self.number(cause), Effect::new(self.number(effect), next)));
    }
}

/// What a change can cause: another change, in the next micro-step or in the same one. There are many, so both are one
/// number.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Effect(u32);

impl Effect {
    fn new(change: u32, next: bool) -> Effect {
        Effect(change << 1 | u32::from(next))
    }

    /// The number of the other change.
    pub(super) fn change(self) -> u32 {
        self.0 >> 1
    }

    /// Whether in the next micro-step.
    pub(super) fn is_next(self) -> bool {
        self.0 & 1 == 1
    }
}

/// The effects of all changes, one list behind the other.
pub(super) struct Effects {
    /// Where the list of each change begins, and at the end where the last one ends.
    begins: Vec<u32>,
    all: Vec<Effect>,
}

impl Effects {
    fn new(changes: usize, edges: &[(u32, Effect)]) -> Effects {
        let mut begins = vec![0_u32; changes + 1];
        edges.iter().for_each(|(cause, _)| begins[*cause as usize] += 1);
        // Where each list ends; it is filled from there.
        let mut end = 0;
        for begin in &mut begins {
            end += *begin;
            *begin = end;
        }
        let mut all = vec![Effect::default(); edges.len()];
        for (cause, effect) in edges.iter().rev() {
            let place = &mut begins[*cause as usize];
            *place -= 1;
            all[*place as usize] = *effect;
        }
        Effects { begins, all }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// Those of a change.
    pub(super) fn of(&self, change: u32) -> &[Effect] {
        let change = change as usize;
        &self.all[self.begins[change] as usize..self.begins[change + 1] as usize]
    }
}

/// Where the numbers of the changes of each kind begin. Whatever can be thought of has a number, whether or not anything
/// causes it; but variables that nothing assigns, as inputs, have none, and neither has what the whole net lacks.
struct Numbers {
    clears: u32,
    stops: u32,
    activated: u32,
    placed: u32,
    deactivated: u32,
    obeyed: u32,
    overruled: u32,
    forced: u32,
    frozen: u32,
    released: u32,
    thawed: u32,
    expr: u32,
    variable: u32,
    macro_step: u32,
    grafcet: u32,
    occurs: u32,
    differs: u32,
    subsides: u32,
    all: u32,
    /// How many orders there are on the grafcets before each.
    orders_before: IndexVec<GrafcetId, u32>,
    /// How many of the variables before each are assigned.
    assigned_before: IndexVec<VariableId, u32>,
}

impl Numbers {
    fn new(net: &Net) -> Numbers {
        let mut all = 0;
        let mut some = |size: usize| {
            let begin = all;
            all += size as u32;
            begin
        };
        let (steps, transitions, grafcets) = (net.places.len(), net.transitions.len(), net.grafcets.len());
        let before = |sum: &mut u32, g: &Grafcet| Some(std::mem::replace(sum, *sum + g.orders.len() as u32));
        let orders_before = net.grafcets.iter().scan(0, before).collect();
        let orders: usize = net.grafcets.iter().map(|g| g.orders.len()).sum();
        let mut assigned = 0;
        let mut assigned_before = IndexVec::with_capacity(net.variables.len());
        for variable in &net.variables {
            assigned_before.push(assigned as u32);
            assigned += usize::from(variable.mode != Mode::Given);
        }
        // By an activation link or an order.
        let is_placed = net.places.iter().any(|place| place.activated) || orders > 0;
        let placing = if is_placed { steps } else { 0 };
        let clears = |action: &Stored| matches!(action.event, Event::Clearing(_));
        let subsiding = if net.stored.iter().any(clears) { assigned } else { 0 };
        let mut numbers = Numbers {
            clears: some(transitions),
            stops: some(transitions),
            activated: some(steps),
            placed: some(placing),
            deactivated: some(steps),
            obeyed: some(orders),
            // Ranks up to the one after the last order.
            overruled: some(orders + grafcets),
            forced: some(grafcets),
            frozen: some(grafcets),
            released: some(grafcets),
            thawed: some(grafcets),
            expr: some(2 * net.exprs.len()),
            variable: some(2 * assigned),
            macro_step: some(2 * net.macro_steps.len()),
            grafcet: some(2 * grafcets),
            occurs: some(net.stored.len()),
            differs: some(net.stored.len()),
            subsides: some(subsiding),
            all: 0,
            orders_before,
            assigned_before,
        };
        numbers.all = all;
        numbers
    }

    fn of(&self, change: Change) -> u32 {
        let both = |place: usize, way: Way| 2 * place + usize::from(way == Way::Down);
        let (begin, place) = match change {
            Change::Clears(t) => (self.clears, t.index()),
            Change::Stops(t) => (self.stops, t.index()),
            Change::Activated(s) => (self.activated, s.index()),
            Change::Placed(s) => (self.placed, s.index()),
            Change::Deactivated(s) => (self.deactivated, s.index()),
            Change::Obeyed(g, rank) => (self.obeyed, self.orders_before[g] as usize + rank),
            Change::Overruled(g, rank) => (self.overruled, self.orders_before[g] as usize + g.index() + rank),
            Change::Forced(g) => (self.forced, g.index()),
            Change::Frozen(g) => (self.frozen, g.index()),
            Change::Released(g) => (self.released, g.index()),
            Change::Thawed(g) => (self.thawed, g.index()),
            Change::Expr(e, way) => (self.expr, both(e.index(), way)),
            Change::Variable(v, way) => (self.variable, both(self.assigned_before[v] as usize, way)),
            Change::Macro(m, way) => (self.macro_step, both(m.index(), way)),
            Change::Grafcet(g, way) => (self.grafcet, both(g.index(), way)),
            Change::Occurs(action) => (self.occurs, action),
            Change::Differs(action) => (self.differs, action),
            Change::Subsides(v) => (self.subsides, self.assigned_before[v] as usize),
        };
        begin + place as u32
    }
}
