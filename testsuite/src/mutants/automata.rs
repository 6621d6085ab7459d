//! Faults of automata, as blocks of the language and as what charts are, and of the evaluation of 64 scenarios at once.

use super::{At, Fault, Part};

const AUTOMATA: At = At::anywhere(Part::Automata);
const LANES: At = At::anywhere(Part::Lanes);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "arcs-go-together",
        at: AUTOMATA.within("arc"),
        breaks: "a later arc does not wait for those before it",
        text: "self.made(ExprKind::Not(taken), place)",
        instead: "self.made(ExprKind::Bool(true), place)",
    },
    Fault {
        name: "arc-outputs-stay",
        at: AUTOMATA,
        breaks: "outputs on arcs are not over with the reaction that takes the arc",
        text: "self.momentary.extend(outputs.iter().map(|output| output.text.clone()))",
        instead: "()",
    },
    Fault {
        name: "arc-outputs-stay-in-a-state",
        at: AUTOMATA.within("rest"),
        breaks: "a call that takes no arc leaves outputs on arcs as they were",
        text: "self.publish(&output, false, place)",
        instead: "self.publish(&output, true, place)",
    },
    Fault {
        name: "a-partition-is-refined-once",
        at: AUTOMATA,
        breaks: "states are taken for equivalent that lead to states told apart late",
        text: "self.waiting.push(new);",
        instead: "",
    },
    Fault {
        name: "equivalent-states-stay-apart",
        at: AUTOMATA.within("minimal"),
        breaks: "the smallest automaton has states that do the same",
        text: "vec![0; machine.states.len()]",
        instead: "(0..machine.states.len()).collect()",
    },
    Fault {
        name: "a-machine-takes-one-micro-step",
        at: AUTOMATA,
        breaks: "a call of the machine does not go on to stability",
        text: "left.and(&self.values[repeat.again])",
        instead: "self.alphabet.none.clone()",
    },
    Fault {
        name: "graphs-wait-for-nobody",
        at: AUTOMATA,
        breaks: "an arc does not bear the states of other graphs that it waits for",
        text: "self.of[**step] != graph",
        instead: "false",
    },
    Fault {
        name: "lanes-take-every-branch",
        at: LANES,
        breaks: "a lane does what is chosen in others",
        text: "left & self.bools[branch.when]",
        instead: "left",
    },
    Fault {
        name: "lanes-rest-too-early",
        at: LANES,
        breaks: "lanes do not go on to stability",
        text: "left &= values.bools[again];",
        instead: "left = 0;",
    },
    Fault {
        name: "lanes-do-not-rest",
        at: LANES,
        breaks: "what is kept is kept in lanes that rest, too",
        text: "*to & !mask | from & mask",
        instead: "from",
    },
    Fault {
        name: "lanes-share-a-timer",
        at: LANES,
        breaks: "delays of all lanes are those of the first",
        text: "at[lane] - since[lane] >= *preset",
        instead: "at[0] - since[0] >= *preset",
    },
    Fault {
        name: "lanes-know-what-was",
        at: LANES,
        breaks: "a formula keeps its value when a variable in it is written",
        text: "self.variable_written[variable] = self.moment;",
        instead: "",
    },
    Fault {
        name: "lanes-share-an-arm",
        at: LANES,
        breaks: "a lane does what its state has no arm for",
        text: "of[*lane] == number",
        instead: "true",
    },
];
