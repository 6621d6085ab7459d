//! The state of 64 scenarios, and a call.

use crate::Word;
use crate::code::{Body, LANES, Operation, Part};
use crate::compile::{Code, compile};
use crate::operate::{Timer, Values, lanes};
use grafc_formula::Value;
use grafc_logic::scan::{Flag, Program, Role, VarId, Variable};
use grafc_model::chart::StepId;
use grafc_model::reaction::{Flags, Response, Stimulus};
use index_vec::index_vec;

/// Up to 64 scenarios of a program that are being run.
pub struct Lanes<'p> {
    program: &'p Program,
    code: Code,
    values: Values,
    inputs: Vec<VarId>,
    outputs: Vec<VarId>,
}

impl<'p> Lanes<'p> {
    /// All lanes before their first call.
    pub fn new(program: &'p Program) -> Self {
        let code = compile(program);
        let room = &code.room;
        let timer = |preset: i64| Timer { runs: 0, since: [0; LANES], at: [0; LANES], preset };
        let mut values = Values {
            bools: index_vec![0; room.bools],
            wholes: index_vec![[0; LANES]; room.wholes],
            reals: index_vec![[0.0; LANES]; room.reals],
            timers: program.timers.iter().map(|t| timer(t.preset.map_or(i64::MAX, |preset| preset.ms))).collect(),
            now: [0; LANES],
        };
        let constants = room.constants.iter().copied();
        let initial = program.variables.iter_enumerated().map(|(v, variable)| (code.variables[v], variable.initial()));
        constants.chain(initial).for_each(|(at, value)| values.set(at, value, Word::MAX));
        let of = |role: Role| program.of_role(role).map(|(id, _)| id).collect();
        Lanes { program, code, values, inputs: of(Role::Input), outputs: of(Role::Output) }
    }

    /// Gives an input, by its place among the inputs, a value in the lanes of a mask.
    pub fn set_input(&mut self, input: usize, value: Value, mask: Word) {
        self.values.set(self.code.variables[self.inputs[input]], value, mask);
    }

    /// Gives a Boolean input, by its place among the inputs, a value in each lane.
    ///
    /// # Panics
    /// The input is not Boolean.
    pub fn set_bools(&mut self, input: usize, word: Word) {
        let at = self.code.variables[self.inputs[input]].bool();
        self.values.bools[at] = word;
    }

    /// The time of the next call in the lanes of a mask, in milliseconds; never less than at the call before.
    pub fn set_time(&mut self, t_ms: i64, mask: Word) {
        lanes(mask).for_each(|lane| self.values.now[lane] = t_ms);
    }

    /// The controller has restarted in the lanes of a mask: what is retained is kept, all the rest is as before the first
    /// call.
    pub fn restart(&mut self, mask: Word) {
        let goes = |variable: &Variable| !variable.retain && variable.role != Role::Observed;
        for (id, variable) in self.program.variables.iter_enumerated().filter(|(_, variable)| goes(variable)) {
            self.values.set(self.code.variables[id], variable.initial(), mask);
        }
        for timer in &mut self.values.timers {
            timer.runs &= !mask;
        }
    }

    /// One call in the lanes of a mask, with the inputs and at the times that were given; the others rest.
    pub fn call(&mut self, mask: Word) {
        let Lanes { program, code, values, .. } = self;
        values.run(code, &code.first, mask);
        values.run(code, &code.before, mask);
        match program.repeat {
            None => values.run(code, &code.micro_step, mask),
            Some(repeat) => {
                let again = code.variables[repeat.again].bool();
                let (mut left, mut count) = (mask, 0);
                while left != 0 && repeat.limit.is_none_or(|limit| count < limit.bound) {
                    count += 1;
                    values.run(code, &code.micro_step, left);
                    left &= values.bools[again];
                }
                if let Some(limit) = repeat.limit {
                    values.bools[code.variables[limit.flag].bool()] |= left;
                }
            }
        }
        values.run(code, &code.after, mask);
    }

    /// One call in as many lanes as there are stimuli, from the first.
    ///
    /// # Panics
    /// There are more than 64.
    pub fn react(&mut self, stimuli: &[&Stimulus]) {
        assert!(stimuli.len() <= LANES, "{} scenarios in {LANES} lanes", stimuli.len());
        self.react_in(stimuli.iter().copied().enumerate());
    }

    /// One call in the lanes that are given a stimulus; the others rest.
    ///
    /// # Panics
    /// A lane is beyond the last one.
    pub fn react_in<'s>(&mut self, stimuli: impl IntoIterator<Item = (usize, &'s Stimulus)> + Clone) {
        let (mut mask, mut restarts): (Word, Word) = (0, 0);
        for (lane, stimulus) in stimuli.clone() {
            self.values.now[lane] = stimulus.t_ms;
            mask |= 1 << lane;
            restarts |= Word::from(stimulus.restart) << lane;
        }
        if restarts != 0 {
            self.restart(restarts);
        }
        for (lane, stimulus) in stimuli {
            for (v, value) in self.inputs.iter().zip(&stimulus.inputs) {
                self.values.set_lane(self.code.variables[*v], *value, lane);
            }
        }
        self.call(mask);
    }

    /// What the latest call gave in each of so many lanes, from the first.
    pub fn responses(&mut self, count: usize) -> Vec<Response> {
        let active = self.situation();
        let flags = self.flags();
        let at = |lane: usize| {
            let holds = |word: &Word| word >> lane & 1 == 1;
            let outputs = self.outputs.iter().map(|v| self.value_of(*v, lane)).collect();
            let situation = active.iter().enumerate().filter(|(_, word)| holds(word));
            let situation = situation.map(|(step, _)| StepId::from_usize(step)).collect();
            let [livelock, alloc_conflict, force_conflict, div0] = flags.each_ref().map(holds);
            let flags = Flags { livelock, alloc_conflict, force_conflict, div0 };
            Response { outputs, situation, flags }
        };
        (0..count).map(at).collect()
    }

    /// The lanes in which the latest call gave something else than that of another program of the same chart.
    ///
    /// # Panics
    /// The other program has other outputs.
    pub fn differing(&mut self, other: &mut Lanes) -> Word {
        assert_eq!(self.outputs.len(), other.outputs.len(), "outputs of one chart");
        let words = |mine: &[Word], theirs: &[Word]| mine.iter().zip(theirs).fold(0, |found, (a, b)| found | (a ^ b));
        let situation = words(&self.situation(), &other.situation());
        let outputs = self.outputs.iter().zip(&other.outputs).map(|(mine, theirs)| {
            let (mine, theirs) = (self.code.variables[*mine], other.code.variables[*theirs]);
            self.values.differing(mine, &other.values, theirs)
        });
        situation | words(&self.flags(), &other.flags()) | outputs.fold(0, |found, word| found | word)
    }

    /// Where each step is active, in order of declaration.
    pub fn situation(&mut self) -> Vec<Word> {
        let Lanes { code, values, .. } = self;
        values.run(code, &code.situation, Word::MAX);
        code.active.iter().map(|at| values.bools[*at]).collect()
    }

    /// The value of a variable in a lane.
    pub fn value_of(&self, variable: VarId, lane: usize) -> Value {
        self.values.value(self.code.variables[variable], self.program.variables[variable].ty, lane)
    }

    /// Where a Boolean variable is true.
    ///
    /// # Panics
    /// The variable is not Boolean.
    pub fn bools_of(&self, variable: VarId) -> Word {
        self.values.bools[self.code.variables[variable].bool()]
    }

    /// Where each flag is raised: LIVELOCK, ALLOC_CONFLICT, FORCE_CONFLICT, DIV0.
    fn flags(&self) -> [Word; 4] {
        [Flag::Livelock, Flag::AllocConflict, Flag::ForceConflict, Flag::Div0].map(|flag| {
            let of_flag = self.program.of_role(Role::Flag(flag));
            of_flag.fold(0, |word, (id, _)| word | self.bools_of(id))
        })
    }
}

impl Values {
    /// Does what is to be done, and keeps it in the lanes of a mask. Bodies nest no deeper than lowering nests them, whatever
    /// the chart.
    fn run(&mut self, code: &Code, body: &Body, mask: Word) {
        for part in body {
            match part {
                Part::Operations(range) => self.operate_all(&code.operations[range.clone()], mask),
                Part::Case { of, bodies } => {
                    let mut left = mask;
                    while left != 0 {
                        let of = &self.wholes[*of];
                        let number = of[left.trailing_zeros() as usize];
                        let here =
                            lanes(left).filter(|lane| of[*lane] == number).fold(0, |word, lane| word | 1 << lane);
                        if let Ok(place) = bodies.binary_search_by_key(&number, |(value, _)| *value) {
                            self.run(code, &bodies[place].1, here);
                        }
                        left &= !here;
                    }
                }
                Part::If { branches, otherwise } => {
                    let mut left = mask;
                    for branch in branches {
                        self.operate_all(&code.operations[branch.operations.clone()], left);
                        let taken = left & self.bools[branch.when];
                        if taken != 0 {
                            self.run(code, &branch.body, taken);
                        }
                        left &= !taken;
                        if left == 0 {
                            break;
                        }
                    }
                    if left != 0 {
                        self.run(code, otherwise, left);
                    }
                }
            }
        }
    }

    fn operate_all(&mut self, operations: &[Operation], mask: Word) {
        operations.iter().for_each(|operation| self.operate(operation, mask));
    }
}
