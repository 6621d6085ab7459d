//! The answers as JUnit: a suite a chart, a case a claim. What is open is an error, so that nobody takes it for proved; a
//! note that fails has passed, with what it says beside it.

use super::said::fault;
use grafc::files::Refusal;
use grafc_verify::{Answer, Verified};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};
use std::io;

/// The document.
///
/// # Errors
/// It cannot be written.
pub fn junit(chart: &str, verified: &Verified) -> Result<String, Refusal> {
    let mut suite = TestSuite::new(chart);
    for verdict in &verified.verdicts {
        let claim = &verdict.claim;
        let mut output = None;
        let status = match &verdict.answer {
            Answer::Holds => TestCaseStatus::success(),
            Answer::Fails(trace) => {
                let said = fault(verdict, trace.as_ref());
                let shown = trace.as_ref().map(|trace| trace.csv());
                if claim.kind.is_note() {
                    output = Some([Some(said), shown].into_iter().flatten().collect::<Vec<_>>().join("\n"));
                    TestCaseStatus::success()
                } else {
                    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
                    status.set_message(said).set_type(claim.kind.name());
                    shown.into_iter().for_each(|shown| _ = status.set_description(shown));
                    status
                }
            }
            Answer::Open(reason) => {
                let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
                status.set_message(format!("open: {reason}")).set_type("open");
                status
            }
        };
        let mut case = TestCase::new(claim.name.clone(), status);
        case.set_classname(chart);
        output.into_iter().for_each(|output| _ = case.set_system_out(output));
        suite.add_test_case(case);
    }
    let mut report = Report::new("grafc verify");
    report.add_test_suite(suite);
    let text = report.to_string();
    text.map(|text| text + "\n").map_err(|error| Refusal::to_write("standard output", io::Error::other(error)))
}
