//! A test in words of time: the chart is called at each period, as a controller calls it, and lines say what is given and
//! expected when.

use crate::coverage::Coverage;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_model::chart::{
    Chart, Condition, Scenario, ScenarioLine, ScenarioTime, StepId, Value, VariableId, VariableKind,
};
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::{MOST_CALLS, Observer, Probe, Simulator};
use grafc_model::trace::{BrokenClaims, agree, spelled};

/// Runs a scenario with a call every so many milliseconds, and says what is not as it expects. What it makes happen is added
/// to the coverage, if somebody measures that.
pub fn scenario(
    chart: &Chart,
    profile: Profile,
    scenario: &Scenario,
    scan: i64,
    coverage: Option<&mut Coverage>,
) -> Diagnostics {
    let mut run = Run::new(chart, profile, scan, coverage);
    let mut said = Diagnostics::new();
    for line in &scenario.lines {
        let reached = run.line(line, &mut said);
        // What is claimed of the chart is looked at in each scan, and told at the line that it came to by then.
        run.broken.told(chart, line.span).into_iter().for_each(|broken| said.push(broken));
        if let Err(fault) = reached {
            // What stands behind a line that was never reached is not looked at.
            said.push(*fault);
            break;
        }
        run.compare(line, &mut said);
    }
    said
}

struct Run<'a, 'c, 'r> {
    chart: &'a Chart,
    simulator: Simulator<'a>,
    coverage: Option<&'r mut Coverage<'c>>,
    scan: i64,
    /// The variables that are inputs, in order of declaration.
    inputs: Vec<VariableId>,
    values: Vec<Value>,
    /// The places of inputs that are 0 again in the next scan.
    pulses: Vec<usize>,
    /// When the latest scan was.
    now: Option<i64>,
    /// When the latest line was.
    line: i64,
    left: u64,
    broken: BrokenClaims,
}

type Fault = Box<Diagnostic>;

impl<'a, 'c, 'r> Run<'a, 'c, 'r> {
    fn new(chart: &'a Chart, profile: Profile, scan: i64, mut coverage: Option<&'r mut Coverage<'c>>) -> Self {
        let inputs = chart.variables.iter_enumerated().filter(|(_, variable)| variable.kind == VariableKind::Input);
        let (inputs, values) = inputs.map(|(id, variable)| (id, variable.initial())).unzip();
        let mut simulator = Simulator::new(chart, profile);
        if let Some(coverage) = &mut coverage {
            coverage.begin();
            simulator.look_on();
        }
        simulator.watch_claims();
        Run {
            chart,
            simulator,
            coverage,
            scan,
            inputs,
            values,
            pulses: Vec::new(),
            now: None,
            line: 0,
            left: MOST_CALLS,
            broken: BrokenClaims::default(),
        }
    }

    /// The time of the next scan.
    fn next(&self) -> i64 {
        self.now.map_or(0, |now| now.saturating_add(self.scan))
    }

    /// Calls the chart, at the next scan.
    fn call(&mut self, line: &ScenarioLine) -> Result<(), Fault> {
        self.left = self.left.checked_sub(1).ok_or_else(|| {
            let fault = Diagnostic::new(Code::E0606, line.span, "before this line there are too many scans");
            Box::new(fault.help("scan less often with `--scan`; perhaps a time is mistyped"))
        })?;
        let t_ms = self.next();
        let stimulus = Stimulus { t_ms, restart: false, inputs: self.values.clone() };
        match &mut self.coverage {
            Some(coverage) => {
                let mut observe = |simulator: &Simulator| coverage.micro_step(simulator);
                self.simulator.react_observed(&stimulus, &mut observe);
                coverage.rested(&mut self.simulator, t_ms);
            }
            None => _ = self.simulator.react(&stimulus),
        }
        for place in self.pulses.drain(..) {
            self.values[place] = Value::Bool(false);
        }
        self.broken.called(t_ms, self.simulator.broken());
        self.now = Some(t_ms);
        Ok(())
    }

    /// Comes to a line.
    fn line(&mut self, line: &ScenarioLine, said: &mut Diagnostics) -> Result<(), Fault> {
        let target = match &line.when {
            ScenarioTime::At(ms) => {
                if *ms < self.line {
                    let message = format!("the time {ms} ms has passed: it is {} ms", self.line);
                    let fault = Diagnostic::new(Code::E0604, line.span, message);
                    said.push(fault.help("behind `until`, times count from there: `after 1s : …`"));
                }
                *ms
            }
            ScenarioTime::After(ms) => self.line.saturating_add(*ms),
            ScenarioTime::Until(condition, within) => return self.until(line, condition, *within),
        };
        while self.next() < target {
            self.call(line)?;
        }
        for given in &line.given {
            let Ok(place) = self.inputs.binary_search(&given.variable) else { continue };
            self.values[place] = given.value;
            if given.is_pulse {
                self.pulses.push(place);
            }
        }
        self.call(line)?;
        self.line = self.now.unwrap_or_default();
        Ok(())
    }

    fn until(&mut self, line: &ScenarioLine, condition: &Condition, within: i64) -> Result<(), Fault> {
        if self.now.is_none() {
            self.call(line)?;
        }
        let end = self.line.saturating_add(within);
        loop {
            let now = self.now.unwrap_or_default();
            if self.simulator.is_met(condition, now) {
                self.line = now;
                return Ok(());
            }
            if self.next() > end {
                return Err(Box::new(self.not_reached(condition, within, now)));
            }
            self.call(line)?;
        }
    }

    /// What was the case when the time was over.
    fn not_reached(&mut self, condition: &Condition, within: i64, now: i64) -> Diagnostic {
        let message = format!("this was not so within {within} ms");
        let active = self.simulator.state().situation().iter_enumerated().filter(|(_, active)| **active);
        let label = |id: StepId| self.chart.steps[id].label.as_str();
        let labels: Vec<&str> = active.map(|(id, _)| label(id)).collect();
        let mut fault = Diagnostic::new(Code::E0611, condition.span, message)
            .note(format!("at {now} ms the situation was {{{}}}", labels.join(", ")));
        let mut probes = condition.probes();
        probes.sort_unstable();
        probes.dedup();
        let values = self.simulator.look(&probes, now);
        let told: Vec<String> = probes.iter().zip(values).map(|(probe, value)| self.told(*probe, value)).collect();
        if !told.is_empty() {
            fault = fault.note(told.join(", "));
        }
        fault
    }

    fn told(&self, probe: Probe, value: Value) -> String {
        format!("`{}` was {}", probe.name(self.chart), spelled(probe.ty(self.chart), value))
    }

    /// Compares what is with what a line expects.
    fn compare(&mut self, line: &ScenarioLine, said: &mut Diagnostics) {
        let probes: Vec<Probe> = line.expected.iter().map(|expected| expected.probe).collect();
        let now = self.now.unwrap_or_default();
        let found = self.simulator.look(&probes, now);
        for (expected, found) in line.expected.iter().zip(found) {
            let ty = expected.probe.ty(self.chart);
            if !agree(ty, expected.value, found) {
                let name = expected.probe.name(self.chart);
                let [wanted, found] = [expected.value, found].map(|value| spelled(ty, value));
                let message = format!("at {now} ms `{name}` is {found}, expected {wanted}");
                said.push(Diagnostic::new(Code::E0607, expected.span, message));
            }
        }
    }
}
