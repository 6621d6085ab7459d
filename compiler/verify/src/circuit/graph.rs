//! And-inverter graphs: conjunctions of two, and negations for nothing.

use rustc_hash::FxHashMap;

/// A node, or its negation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Literal(u32);

impl Literal {
    /// What never holds.
    pub const FALSE: Literal = Literal(0);
    /// What always does.
    pub const TRUE: Literal = Literal(1);

    /// The node that it is of.
    pub fn node(self) -> usize {
        (self.0 >> 1) as usize
    }

    /// Whether it is its negation.
    pub fn is_negated(self) -> bool {
        self.0 & 1 == 1
    }

    /// A truth value.
    pub fn of(value: bool) -> Literal {
        if value { Literal::TRUE } else { Literal::FALSE }
    }
}

impl std::ops::Not for Literal {
    type Output = Literal;

    fn not(self) -> Literal {
        Literal(self.0 ^ 1)
    }
}

/// A node.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Node {
    /// The constant false; the first node, and no other.
    False,
    /// What is given: an input, or what a latch holds.
    Given,
    /// A conjunction.
    And(Literal, Literal),
}

/// A graph: each conjunction once, operands before what they are operands of.
#[derive(Clone, Debug)]
pub struct Graph {
    nodes: Vec<Node>,
    known: FxHashMap<(Literal, Literal), Literal>,
}

impl Default for Graph {
    fn default() -> Self {
        Graph { nodes: vec![Node::False], known: FxHashMap::default() }
    }
}

impl Graph {
    /// The nodes, the constant first.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// A new input, or latch.
    pub fn given(&mut self) -> Literal {
        self.push(Node::Given)
    }

    fn push(&mut self, node: Node) -> Literal {
        self.nodes.push(node);
        Literal((self.nodes.len() as u32 - 1) << 1)
    }

    /// `a and b`.
    pub fn and(&mut self, a: Literal, b: Literal) -> Literal {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        if a == Literal::FALSE || a == !b {
            return Literal::FALSE;
        }
        if a == Literal::TRUE || a == b {
            return b;
        }
        if let Some(known) = self.known.get(&(a, b)) {
            return *known;
        }
        let made = self.push(Node::And(a, b));
        self.known.insert((a, b), made);
        made
    }

    /// `a or b`.
    pub fn or(&mut self, a: Literal, b: Literal) -> Literal {
        !self.and(!a, !b)
    }

    /// `a xor b`.
    pub fn xor(&mut self, a: Literal, b: Literal) -> Literal {
        let (only_a, only_b) = (self.and(a, !b), self.and(!a, b));
        self.or(only_a, only_b)
    }

    /// `then` where the condition holds, else the other.
    pub fn choose(&mut self, condition: Literal, then: Literal, otherwise: Literal) -> Literal {
        if then == otherwise {
            return then;
        }
        let (then, otherwise) = (self.and(condition, then), self.and(!condition, otherwise));
        self.or(then, otherwise)
    }

    /// All of them.
    pub fn all(&mut self, operands: impl IntoIterator<Item = Literal>) -> Literal {
        operands.into_iter().fold(Literal::TRUE, |all, one| self.and(all, one))
    }

    /// One of them or more.
    pub fn any(&mut self, operands: impl IntoIterator<Item = Literal>) -> Literal {
        operands.into_iter().fold(Literal::FALSE, |any, one| self.or(any, one))
    }

    /// The truth of all nodes, where what is given has the words of `given`, in order: a bit a case.
    pub fn evaluate(&self, given: impl IntoIterator<Item = u64>) -> Vec<u64> {
        let mut given = given.into_iter();
        let mut found: Vec<u64> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let word = match node {
                Node::False => 0,
                Node::Given => given.next().unwrap_or_default(),
                Node::And(a, b) => of(&found, *a) & of(&found, *b),
            };
            found.push(word);
        }
        found
    }
}

/// The truth of a literal, where that of nodes is known.
pub fn of(nodes: &[u64], literal: Literal) -> u64 {
    nodes[literal.node()] ^ if literal.is_negated() { u64::MAX } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_laws_of_two_and_three() {
        let mut graph = Graph::default();
        let [a, b, c] = [graph.given(), graph.given(), graph.given()];
        let (and, or, xor) = (graph.and(a, b), graph.or(a, b), graph.xor(a, b));
        let choice = graph.choose(a, b, c);
        // Each of the eight cases is a bit.
        let words = [0b1111_0000, 0b1100_1100, 0b1010_1010];
        let found = graph.evaluate(words);
        let low = |literal| of(&found, literal) & 0xFF;
        assert_eq!(low(and), 0b1100_0000);
        assert_eq!(low(or), 0b1111_1100);
        assert_eq!(low(xor), 0b0011_1100);
        assert_eq!(low(choice), 0b1100_1010);
        assert_eq!((graph.and(a, !a), graph.or(b, !b)), (Literal::FALSE, Literal::TRUE));
        assert_eq!((graph.and(b, a), graph.and(a, Literal::TRUE)), (and, a));
    }
}
