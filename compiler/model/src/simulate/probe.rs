//! What can be looked at in a run beside the outputs: variables, steps, durations.

use super::Simulator;
use super::plan::{Memory, Valued};
use crate::chart::{Chart, GrafcetId, MacroId, Mode, StepId, Type, Value, VariableId, VariableKind};
use crate::simulate::flat::{active_grafcets, active_macro_steps};
use ecow::{EcoString, eco_format};

/// Something with a value after each reaction.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Probe {
    /// A declared variable.
    Variable(VariableId),
    /// `Xn`
    Step(StepId),
    /// `Tn`
    Duration(StepId),
    /// `XMn`
    Macro(MacroId),
    /// `XGn`
    Grafcet(GrafcetId),
    /// `FGn`
    Frozen(GrafcetId),
}

impl Probe {
    /// What a name stands for, as in a condition of the chart.
    pub fn of(name: &str, chart: &Chart) -> Option<Probe> {
        let all = chart.variables.iter_enumerated().find(|(_, variable)| variable.name == name);
        if let Some((id, _)) = all {
            return Some(Probe::Variable(id));
        }
        let step = |label: &str| chart.steps.iter_enumerated().find(|(_, step)| step.label == label).map(|(id, _)| id);
        if let Some(label) = name.strip_prefix('X') {
            let of_macro = chart.macro_steps.iter_enumerated().find(|(_, step)| step.label == label);
            let of_grafcet = chart.grafcets.iter_enumerated().find(|(_, grafcet)| grafcet.name == label);
            return step(label)
                .map(Probe::Step)
                .or(of_macro.map(|(id, _)| Probe::Macro(id)))
                .or(of_grafcet.map(|(id, _)| Probe::Grafcet(id)));
        }
        if let Some(label) = name.strip_prefix('F')
            && let Some((id, _)) = chart.grafcets.iter_enumerated().find(|(_, grafcet)| grafcet.name == label)
            && chart.commands().any(|(_, commanded, _)| commanded == id)
        {
            return Some(Probe::Frozen(id));
        }
        name.strip_prefix('T').and_then(step).map(Probe::Duration)
    }

    /// All variables of a kind.
    pub fn variables(chart: &Chart, kind: VariableKind) -> impl Iterator<Item = Probe> {
        let of_kind = chart.variables.iter_enumerated().filter(move |(_, variable)| variable.kind == kind);
        of_kind.map(|(id, _)| Probe::Variable(id))
    }

    /// All steps.
    pub fn steps(chart: &Chart) -> impl Iterator<Item = Probe> {
        chart.steps.indices().map(Probe::Step)
    }

    /// Its name, as conditions have it.
    pub fn name(self, chart: &Chart) -> EcoString {
        match self {
            Probe::Variable(id) => chart.variables[id].name.clone(),
            Probe::Step(id) => eco_format!("X{}", chart.steps[id].label),
            Probe::Duration(id) => eco_format!("T{}", chart.steps[id].label),
            Probe::Macro(id) => eco_format!("X{}", chart.macro_steps[id].label),
            Probe::Grafcet(id) => eco_format!("X{}", chart.grafcets[id].name),
            Probe::Frozen(id) => eco_format!("F{}", chart.grafcets[id].name),
        }
    }

    /// The type of its values.
    pub fn ty(self, chart: &Chart) -> Type {
        match self {
            Probe::Variable(id) => chart.variables[id].ty,
            Probe::Step(_) | Probe::Macro(_) | Probe::Grafcet(_) | Probe::Frozen(_) => Type::Bool,
            Probe::Duration(_) => Type::Time,
        }
    }
}

impl Simulator<'_> {
    /// The values of some probes after the latest reaction, which was at `t`.
    pub fn look(&mut self, probes: &[Probe], t: i64) -> Vec<Value> {
        let wires = probes.iter().filter_map(|probe| {
            let Probe::Variable(id) = *probe else { return None };
            (self.chart.variables[id].mode == Mode::Wire).then_some(Valued::Wire(id))
        });
        let nodes = self.plan.of_wires(self.chart, wires.collect());
        // What is shown raises no flag.
        let flags = self.flags;
        self.evaluate(&nodes, Memory::Hold, t);
        self.flags = flags;
        let macro_steps = active_macro_steps(self.chart, &self.state.active);
        let grafcets = active_grafcets(self.chart, &self.state.active);
        let value = |probe: &Probe| match *probe {
            Probe::Variable(id) if self.chart.variables[id].mode == Mode::Wire => Value::Bool(self.values.wire(id)),
            Probe::Variable(id) => self.state.variables[id],
            Probe::Step(id) => Value::Bool(self.state.active[id]),
            Probe::Duration(id) if self.state.active[id] => Value::Time(t.wrapping_sub(self.state.since[id])),
            Probe::Duration(_) => Value::Time(0),
            Probe::Macro(id) => Value::Bool(macro_steps[id]),
            Probe::Grafcet(id) => Value::Bool(grafcets[id]),
            Probe::Frozen(id) => Value::Bool(self.state.frozen[id]),
        };
        probes.iter().map(value).collect()
    }
}
