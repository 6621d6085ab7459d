//! Traces as pages read them: what `grafc sim` takes they take, with the same values, and what it refuses they refuse.

use grafc_model::chart::{Type, Value};
use grafc_model::dump::type_name;
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{check, stimuli};
use grafc_testsuite::executors::js::Tools;
use serde_json::{Value as Json, json};
use std::fs;

/// An input of each type; that of the last is called as a column of the trace's own.
const CHART: &str = "\
input a : bool input n : int input d : dint input u : uint input w : udint
input r : real input l : lreal input t : time input `restart` : bool
initial step 1";

/// Reads traces from a file, and prints of each the rows, values exactly; null where it is refused.
const SCRIPT: &str = "\
import fs from 'node:fs';
import { read } from './csv.js';
const { inputs, traces } = JSON.parse(fs.readFileSync('traces.json', 'utf8'));
const bits = new DataView(new ArrayBuffer(8));
const exact = (value, type) => {
  if (type === 'bool' || Number.isNaN(value)) return String(value);
  if (type !== 'real' && type !== 'lreal') return Object.is(value, -0) ? 'minus zero' : String(value);
  bits.setFloat64(0, value);
  return bits.getBigUint64(0).toString(16);
};
const said = traces.map((text) => {
  let trace;
  try {
    trace = read(text, inputs);
  } catch (fault) {
    if (!fault.key) throw fault;
    return null;
  }
  const values = inputs.map(({ initial }) => initial);
  return [...trace.rows()].map(({ t, changes, restart }) => {
    for (const [place, value] of changes) values[place] = value;
    return { t, restart, values: values.map((value, place) => exact(value, inputs[place].type)) };
  });
});
console.log(JSON.stringify(said));
";

/// What the rules take as a value of the type, and what they do not.
const CELLS: [(&str, &[&str], &[&str]); 8] = [
    (
        "a",
        &["0", "1", "TRUE", "true", "False", "wahr", "FALSCH", "Vrai", "faux", " 1 ", "\u{85}1\u{3000}"],
        &["01", "1.0", "T", "yes", "on", "2#1", "-0", "+1", "2", "X", "tru\u{1d49}", "FAL\u{17f}E", "1_", "\u{feff}1"],
    ),
    (
        "n",
        &[
            "1",
            "+1",
            "-0",
            "-0_0",
            "007",
            "1_000",
            "1_0_0",
            "16#7F",
            "16#7fff",
            "-16#1",
            "+8#17",
            "2#1_0",
            "16#0_F",
            "32767",
            "-32768",
            "16#00000000000000000000000000000000000000000000000000000000000000000000007F",
        ],
        &[
            "1__0",
            "_1",
            "1_",
            "16#-1",
            "8#19",
            "2#12",
            "2#",
            "16#",
            "16#G",
            "8#8",
            "10#5",
            "016#1",
            "1.0",
            "1e3",
            "1,0",
            "0x10",
            "16#_F",
            "16#F_",
            "1 0",
            "--1",
            "- 1",
            "1s",
            "inf",
            "NaN",
            "32768",
            "-32769",
            "16#8000",
            "\u{ff11}",
            "99999999999999999999",
            "16#FFFFFFFFFFFFFFFFF1",
            "4294967297",
            "#1",
            "#",
            "+",
        ],
    ),
    ("d", &["2147483647", "-2147483648", "16#7FFFFFFF"], &["2147483648", "-2147483649", "16#80000000"]),
    ("u", &["0", "65535", "-0", "16#FFFF"], &["-1", "65536", "1.5"]),
    ("w", &["4294967295", "16#FFFFFFFF", "0"], &["-1", "4294967296", "16#1_0000_0000", "18446744073709551617"]),
    (
        "r",
        &[
            "1",
            ".5",
            "5.",
            "-.5",
            "+5.e1",
            "1,5",
            ",5",
            "5,",
            "1,5e3",
            "1_000.5",
            "1_0,5",
            "1_0.",
            "1.5e-3",
            "1.5E3",
            "1e-60",
            "1_0e1_0",
            "3.4028235e38",
            "16#FF",
            "8#17",
            "-2#11",
            "inf",
            "+inf",
            "Inf",
            "-INF",
            "infinity",
            "-Infinity",
            "nan",
            "NAN",
            "-nan",
            "+NaN",
            "1.#INF",
            "-1.#INF",
            "1.#QNAN",
            "1.#ind",
            "-0",
            "-0.0",
            "-0_0",
            "0.1",
            "16777217",
            "0e999",
            "1.00000017881393432617187499",
            "9223372036854775807",
            "99999999999999999999",
        ],
        &[
            "8#19",
            "2#9",
            "1e999",
            "3.5e38",
            "3.4028236e38",
            "-1e39",
            "1d",
            "1s",
            "1e",
            "e1",
            "0x1p3",
            "1.000,5",
            "1,000.5",
            "1e3.5",
            "1e3,5",
            "-",
            "+",
            ".",
            ",",
            "-.",
            "1_.5",
            "1._5",
            "1__0.5",
            "_1.5",
            "1.5_",
            "1_0e",
            "1_0e5-3",
            "1 5",
            "- 1",
            "--1",
            "infinit",
            "in",
            "1.#",
            "NaNs",
            "16#F.8",
            "2#1,1",
            "1_0000000000000000000",
            "\u{ff11}.5",
        ],
    ),
    (
        "l",
        &[
            "1e308",
            "3.5e38",
            "0.1",
            "1e-320",
            "1.7976931348623157e308",
            "9007199254740993",
            "16#7FFFFFFFFFFFFFFF",
            "9_007_199_254_740_993",
            "-inf",
            "NaN",
            "-0",
        ],
        &["1e309", "1e999", "16#8000000000000000", "1_0e999", "8#19", "T#1s"],
    ),
    (
        "t",
        &[
            "5",
            "+5",
            "-5",
            "-0",
            "2147483647",
            "2147483648",
            "4294967296",
            "-2147483649",
            "9007199254740991",
            "16#10",
            "1_000",
            "1s",
            "+1s",
            "-1s",
            "1.s",
            "T#1s",
            "t#1s",
            "TIME#1s",
            "-T#1s",
            "T#1.5s",
            "T#1S",
            "T#1M30S",
            "T#1m30s",
            "T#1s_500ms",
            "T#1s__500ms",
            "1.001s",
            "1.005s",
            "8.19s",
            "4.35s",
            "0.3s",
            "1.9990s",
            "1min30s",
            "1h5min2s",
            "1min1.001s",
            "24d",
            "1.5d",
            "0.0009765625d",
            "0.1h",
            "1_000ms",
            "0ms",
            "1.000s",
            "1d0.5h",
        ],
        &[
            "1.5",
            "1.0",
            "1e3",
            "1,5s",
            "1S",
            "1MIN",
            "1m30s",
            "T#1min30s",
            "30s1min",
            "1s1s",
            "1.5min30s",
            "1min 30s",
            "T#-1s",
            "T#",
            "#1s",
            "Q#1s",
            "T#1",
            "T#s",
            "T#_1s",
            "T#1_s",
            "T#1s_",
            "1s_500ms",
            "1s500",
            "1min.5s",
            "25d",
            "2147483648ms",
            "0.5ms",
            "1us",
            "1.9999s",
            "0.0000001d",
            "0.00000001157407407407407d",
            "1__0s",
            "1_s",
            "1._5s",
            "1.5_s",
            "99999999999999999999s",
            "inf",
            "NaN",
            "1constructor",
            "T#1toString",
            "--1s",
        ],
    ),
];

/// Tables that are read, and tables that are not.
const TABLES: (&[&str], &[&str]) = (
    &[
        "\u{feff}t_ms,n\n0,7\n",
        "t_ms,a\r0,1\r5,0\r",
        "t_ms,a\r\n0,1\r\n\r\n5,0",
        "\n\r\nt_ms,n\n\n0,7\n\n",
        "sep=;\nt_ms;r\n0;1,5\n",
        "sep=,\r\nt_ms,n\r\n0,7\r\n",
        "\u{feff}sep=\t\nt_ms\tn\n0\t7\n",
        "t_ms\tn\n0\t7\n",
        "t_ms;r;n\n0;1,5;2\n",
        " t_ms , n \n 0 , 7 \n",
        "\"t_ms\",\"n\"\n\"0\",\"7\"\n",
        "t_ms,n\n0,\"1\" \n",
        "t_ms,n\n0,\"\n7\r\"\n",
        "t_ms,`n`,`t`\n0,7,1s\n",
        "t_ms\n0\n5\n5\n",
        "t_ms,n\n0,7\n5,\n9,8\n",
        "t_ms,n\n+5,7\n",
        "t_ms,n\n-0,7\n",
        "t_ms,n\n4294967296,7\n9007199254740991,8\n",
        "t_ms,restart,`restart`\n0,,1\n5,1,\n",
        "t_ms,`restart`\n0,1\n",
        "t_ms,l\n0,-0\n1,0\n",
        "t_ms,n\n",
    ],
    &[
        "",
        "\n\n",
        "n,t_ms\n0,7\n",
        "`t_ms`,n\n0,7\n",
        "T_MS,n\n0,7\n",
        "t_ms,t_ms\n0,7\n",
        "t_ms,n,n\n0,7,7\n",
        "t_ms,n,`n`\n0,7,7\n",
        "t_ms,N\n0,7\n",
        "t_ms,\n0,\n",
        "t_ms,x\n0,7\n",
        "t_ms,restart\n0,1\n",
        "t_ms,restart,`restart`\n0,x,1\n",
        "t_ms,n\n0\n",
        "t_ms,n\n0,7,\n",
        "t_ms,n\n \n0,7\n",
        "t_ms,n\n\"\"\n0,7\n",
        "t_ms,n\n,7\n",
        "t_ms,n\n0,7\n,\n",
        "t_ms,n\n5,7\n4,7\n",
        "t_ms,n\n-1,7\n",
        "t_ms,n\n1_0,7\n",
        "t_ms,n\n16#5,7\n",
        "t_ms,n\n1.0,7\n",
        "t_ms,n\n1s,7\n",
        "t_ms,n\n\u{663},7\n",
        "t_ms,n\n0, \"7\"\n",
        "t_ms,n\n0,1\"2\"\n",
        "t_ms,n\n0,\"\"\"7\"\"\"\n",
        "t_ms,n\n0,\u{200b}7\n",
        "t_ms,n\n0,\"1\"2\n",
        "t_ms,n\n0,\"1\n",
        "t_ms,n\n0,\"1\" \u{85}2\n",
        "t_ms,\"n\"x\n0,1\n",
        "sep=|\nt_ms|n\n0|7\n",
        "sep=;\rt_ms;n\r0;7\r",
    ],
);

/// A value as the script writes it.
fn exact(value: Value) -> String {
    match value {
        Value::Bool(value) => value.to_string(),
        Value::Int(value) | Value::Time(value) => value.to_string(),
        Value::Real(value) if value.is_nan() => "NaN".into(),
        Value::Real(value) => format!("{:x}", value.to_bits()),
    }
}

#[test]
fn pages_read_traces_as_the_simulator_does() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let chart = check("cells", CHART).expect("a chart without errors");
    let mut traces: Vec<(String, bool)> = Vec::new();
    for (input, taken, refused) in CELLS {
        let mut add = |cell: &str, is_taken| traces.push((format!("t_ms;{input}\n0;{cell}\n"), is_taken));
        taken.iter().for_each(|cell| add(cell, true));
        refused.iter().for_each(|cell| add(cell, false));
    }
    traces.extend(TABLES.0.iter().map(|text| ((*text).to_owned(), true)));
    traces.extend(TABLES.1.iter().map(|text| ((*text).to_owned(), false)));

    let inputs: Vec<Json> = chart
        .variables
        .iter()
        .map(|one| {
            let initial = if one.ty == Type::Bool { json!(false) } else { json!(0) };
            json!({ "name": one.name.as_str(), "type": type_name(one.ty), "initial": initial })
        })
        .collect();
    let folder = tempfile::tempdir().expect("a folder");
    let put = |name: &str, text: &[u8]| fs::write(folder.path().join(name), text).expect("a file");
    for file in fs::read_dir(root().join("compiler/page/src/script")).expect("the script") {
        let file = file.expect("a file");
        fs::copy(file.path(), folder.path().join(file.file_name())).expect("a copy");
    }
    let texts: Vec<&str> = traces.iter().map(|(text, _)| text.as_str()).collect();
    put("package.json", br#"{ "type": "module" }"#);
    put("traces.json", json!({ "inputs": inputs, "traces": texts }).to_string().as_bytes());
    put("check.js", SCRIPT.as_bytes());
    let said = tools.play(folder.path(), "check.js").unwrap_or_else(|fault| panic!("{fault}"));
    let said: Vec<Json> = serde_json::from_str(&said).expect("JSON");
    assert_eq!(said.len(), traces.len());

    let mut wrong = Vec::new();
    for ((text, is_taken), page) in traces.iter().zip(said) {
        let simulator = match stimuli("cells", text, &chart) {
            Ok(rows) => rows
                .iter()
                .map(|row| {
                    let values: Vec<String> = row.inputs.iter().map(|value| exact(*value)).collect();
                    json!({ "t": row.t_ms, "restart": row.restart, "values": values })
                })
                .collect(),
            Err(_) => Json::Null,
        };
        if simulator.is_null() == *is_taken {
            wrong.push(format!("{text:?}: the simulator says {simulator}"));
        }
        if simulator != page {
            wrong.push(format!("{text:?}: the simulator says {simulator}, the page {page}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
