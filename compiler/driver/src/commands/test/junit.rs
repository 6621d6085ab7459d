//! What came of tests in the form of JUnit, which servers read. It bears no times: the same tests give the same text.

use super::run::{Done, Ending, Loaded};
use grafc_diagnostics::{Severity, SourceMap, render};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

/// A suite a chart.
pub fn junit(suites: &[(&Loaded, Vec<Done>)], sources: &SourceMap) -> String {
    let mut report = Report::new("grafc test");
    for (loaded, tests) in suites {
        let mut suite = TestSuite::new(loaded.name.clone());
        if loaded.chart.is_none() {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
            status.set_message("the chart has errors");
            suite.add_test_case(case(&loaded.name, &loaded.name, status));
        }
        for test in tests {
            suite.add_test_case(case(&test.name, &loaded.name, status(test, sources)));
        }
        report.add_test_suite(suite);
    }
    // Writing to memory does not fail.
    report.to_string().unwrap_or_default()
}

fn case(name: &str, chart: &str, status: TestCaseStatus) -> TestCase {
    let own = name.strip_prefix(chart).and_then(|rest| rest.strip_prefix("::")).unwrap_or(name);
    let mut case = TestCase::new(own, status);
    case.set_classname(chart);
    case
}

fn status(test: &Done, sources: &SourceMap) -> TestCaseStatus {
    match test.ending {
        Ending::Passed => return TestCaseStatus::success(),
        Ending::NotRun => {
            let mut status = TestCaseStatus::skipped();
            status.set_message("interrupted before it began");
            return status;
        }
        Ending::Failed => {}
    }
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    if let Some(first) = test.said.iter().find(|one| one.severity() == Severity::Error) {
        status.set_type(first.code.as_str()).set_message(first.message.clone());
    }
    status.set_description(render::human(sources, &test.said, false));
    status
}
