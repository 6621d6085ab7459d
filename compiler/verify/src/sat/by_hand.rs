//! Small circuits for tests, made by hand.

use crate::circuit::{Circuit, Given, Graph, Latch, Literal, Watched};
use crate::facts::Fact;

/// A circuit of inputs and latches with what latches hold at first, what they hold next, and what is seen.
pub(super) fn circuit(
    inputs: usize,
    initial: &[bool],
    of: impl FnOnce(&mut Graph, &[Literal], &[Literal]) -> (Vec<Literal>, Vec<Literal>),
) -> Watched {
    let mut graph = Graph::default();
    let inputs: Vec<Literal> = (0..inputs).map(|_| graph.given()).collect();
    let now: Vec<Literal> = initial.iter().map(|_| graph.given()).collect();
    let (next, seen) = of(&mut graph, &inputs, &now);
    let latches = initial.iter().zip(&now).zip(next);
    let latches =
        latches.map(|((initial, now), next)| Latch { name: String::new(), initial: *initial, now: *now, next });
    let given = inputs.iter().map(|input| Given { name: String::new(), literal: *input });
    let circuit = Circuit {
        name: String::new(),
        inputs: given.collect(),
        latches: latches.collect(),
        rests: Literal::TRUE,
        situation: Vec::new(),
        outputs: Vec::new(),
        assumed: Literal::TRUE,
        bad: Vec::new(),
        graph,
    };
    Watched {
        circuit,
        begins: Literal::TRUE,
        begun: Literal::TRUE,
        facts: seen.into_iter().enumerate().map(|(place, seen)| (Fact::Wanted(place), seen)).collect(),
        atoms: Vec::new(),
        standing: Vec::new(),
        timers: Vec::new(),
        truths: now,
    }
}

/// Two bits that count from 0 to 3 and on to 0 while the input holds; seen is the 3.
pub(super) fn counter() -> Watched {
    circuit(1, &[false, false], |graph, inputs, now| {
        let carry = graph.and(now[0], inputs[0]);
        let next = vec![graph.xor(now[0], inputs[0]), graph.xor(now[1], carry)];
        (next, vec![graph.and(now[0], now[1])])
    })
}

/// From 0 to 1 and back; from 2 to 3 and back, where it never comes. Seen is the 3.
pub(super) fn apart() -> Watched {
    circuit(0, &[false, false], |graph, _, now| (vec![!now[0], now[1]], vec![graph.and(now[0], now[1])]))
}

/// A token in one of three places, which the input moves on. Seen are tokens in two places at once, and in the last one.
pub(super) fn ring() -> Watched {
    circuit(1, &[true, false, false], |graph, inputs, now| {
        let next = (0..3).map(|place| graph.choose(inputs[0], now[(place + 2) % 3], now[place])).collect();
        let pairs = [(0, 1), (1, 2), (0, 2)].map(|(a, b)| graph.and(now[a], now[b]));
        (next, [pairs.to_vec(), vec![now[2]]].concat())
    })
}
