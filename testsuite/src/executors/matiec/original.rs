//! A program as somebody wrote it, over many scans: what an import is held against.

use super::run::RUNTIME;
use super::tools::Tools;
use std::fmt::Write;
use std::fs;

/// A scan: a time in milliseconds and the values of the inputs.
pub type Scan = (i64, Vec<i64>);

/// What a program shows after each scan of each of some runs, by the names of variables. Runs are of one length, and each
/// begins with the program as it starts.
pub fn play_program(
    tools: &Tools,
    text: &str,
    program: &str,
    (inputs, shown): (&[&str], &[&str]),
    runs: &[Vec<Scan>],
) -> Result<Vec<Vec<Vec<i64>>>, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    fs::write(folder.path().join("charts.st"), text).map_err(|e| e.to_string())?;
    tools.iec2c(folder.path()).map_err(|said| format!("{said}\n{text}"))?;
    let program = program.to_uppercase();
    let mut main = format!("{}\nstatic {program} d;\n", RUNTIME.head);
    let width = inputs.len() + 1;
    _ = writeln!(main, "static long long rows[][{width}] = {{");
    for (time, values) in runs.iter().flatten() {
        let values: String = values.iter().map(|value| format!(",{value}")).collect();
        _ = writeln!(main, "{{{time}{values}}},");
    }
    let (length, scans) = (runs.first().map_or(0, Vec::len), runs.iter().map(Vec::len).sum::<usize>());
    _ = writeln!(main, "}};\nint main(void) {{\nfor (int n = 0; n < {scans}; n++) {{");
    _ = writeln!(main, "if (n % {length} == 0) {{ memset(&d, 0, sizeof d); {program}_init__(&d, 0); }}");
    _ = writeln!(main, "long long t = rows[n][0]; {}", RUNTIME.clock);
    for (place, name) in inputs.iter().enumerate() {
        _ = writeln!(main, "d.{}.value = rows[n][{}];", name.to_uppercase(), place + 1);
    }
    _ = writeln!(main, "{program}_body__(&d);");
    for name in shown {
        _ = writeln!(main, "printf(\"%lld \", (long long)d.{}.value);", name.to_uppercase());
    }
    main.push_str("printf(\"\\n\");\n}\nreturn 0;\n}\n");
    fs::write(folder.path().join("main.c"), &main).map_err(|e| e.to_string())?;
    tools.gcc(folder.path(), "-O0").map_err(|said| format!("{said}\n{text}"))?;
    let printed = tools.play(folder.path())?;
    let number = |word: &str| word.parse::<i64>().map_err(|error| format!("{word}: {error}"));
    let all: Result<Vec<Vec<i64>>, String> =
        printed.lines().map(|line| line.split_whitespace().map(number).collect()).collect();
    Ok(all?.chunks(length.max(1)).map(<[_]>::to_vec).collect())
}
