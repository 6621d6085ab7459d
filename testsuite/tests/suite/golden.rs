//! What the compiler writes for the example charts, word for word: so that a change of it is seen and read before it
//! lands.
//!
//! `NAME.st`, `.il` and `.awl` are the code in the default encoding, `ENCODING/NAME.st` and so on that in another,
//! `rust/` holds some of it in Rust, `js/` in JavaScript with the declarations for TypeScript, `plcopen/` a body in instructions and a ladder, `dumps/NAME/` what lies between the
//! stages. A golden file proves nothing about
//! meaning; that is what the other tests are for. `UPDATE_EXPECT=1` rewrites them.

use expect_test::expect_file;
use grafc::{Options, Product};
use grafc_backends::plcopen::{self, Body};
use grafc_backends::{Target, awl, il, js, rust, st};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_net::passes;
use grafc_testsuite::charts::{Case, cases, charts_folder};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Charts whose code is kept in every encoding: branches in parallel, macro-steps, enclosures, enclosures in enclosures.
const IN_EVERY_ENCODING: [&str; 4] = ["figure_12_6", "weigh_mix_b4", "weigh_mix_b6", "figure_3"];

/// Charts whose way through the compiler is kept: a choice, branches in parallel, orders.
const STAGE_BY_STAGE: [&str; 3] = ["figure_12_6", "lock_12_2", "weigh_mix_b5"];

/// Charts whose code is kept in Rust as well: delays and branches in parallel, enclosures and orders.
const IN_RUST: [&str; 2] = ["weigh_mix_b4", "weigh_mix_b5"];

/// The chart whose code is kept in JavaScript: orders, stored actions, delays; and how much of it is to be seen.
const IN_JAVASCRIPT: (&str, [(&str, bool); 2]) = ("weigh_mix_b5", [("", false), ("_observed", true)]);

/// Charts of which a PLCopen project is kept, and its body: instructions with a delay, a small ladder.
const AS_PROJECT: [(&str, Body, &str); 2] = [("press_a", Body::Il, "il"), ("lock_extended", Body::Ld, "ld")];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

/// The golden files that were asked for.
#[derive(Default)]
struct Golden {
    files: BTreeSet<String>,
}

impl Golden {
    fn expect(&mut self, file: String, text: &str) {
        let path = folder().join(&file);
        if let Some(parent) = path.parent().filter(|_| std::env::var_os("UPDATE_EXPECT").is_some()) {
            std::fs::create_dir_all(parent).expect("a folder for it");
        }
        expect_file![path].assert_eq(text);
        assert!(self.files.insert(file.clone()), "{file} is written twice");
    }

    /// What a chart becomes.
    fn made(&self, case: &Case, encoding: Encoding, simplify: bool, product: Product) -> String {
        let options = Options::new(Lowering { profile: case.profile, encoding, simplify }, product);
        let (made, diagnostics) = grafc::compile(FileId::default(), &case.text, &case.name, &options);
        made.unwrap_or_else(|| panic!("{}: {diagnostics:?}", case.name)).text
    }

    /// The languages of PLCs; the name of the file has no ending yet.
    fn code(&mut self, case: &Case, encoding: Encoding, simplify: bool, file: &str) {
        let header = vec![format!("from {}.gct", case.name)];
        let text = Product::Code(Target::St(st::Options { header: header.clone(), ..st::Options::default() }));
        let list = Product::Code(Target::Il(il::Options { header: header.clone(), ..il::Options::default() }));
        let source =
            Product::Code(Target::Awl(awl::Options { header, organization_block: true, ..awl::Options::default() }));
        for (product, ending) in [(text, "st"), (list, "il"), (source, "awl")] {
            let text = self.made(case, encoding, simplify, product);
            self.expect(format!("{file}.{ending}"), &text);
        }
    }

    /// The same in Rust.
    fn rust(&mut self, case: &Case, encoding: Encoding, file: String) {
        let header = vec![format!("from {}.gct", case.name)];
        let options = rust::Options { header, ..rust::Options::default() };
        let text = self.made(case, encoding, true, Product::Code(Target::Rust(options)));
        self.expect(file, &text);
    }

    /// The same in JavaScript, and the file beside it.
    fn javascript(&mut self, case: &Case, encoding: Encoding, observed: bool, file: &str) {
        let header = vec![format!("from {}.gct", case.name)];
        let product = Product::Code(Target::Js(js::Options { header, observed }));
        let options = Options::new(Lowering { profile: case.profile, encoding, simplify: true }, product);
        let (made, diagnostics) = grafc::compile(FileId::default(), &case.text, &case.name, &options);
        let made = made.unwrap_or_else(|| panic!("{}: {diagnostics:?}", case.name));
        self.expect(format!("{file}.mjs"), &made.text);
        self.expect(format!("{file}.d.mts"), made.beside.as_deref().expect("a file beside it"));
    }

    /// A PLCopen project of the neutral dialect.
    fn project(&mut self, case: &Case, body: Body, file: String) {
        let header = vec![format!("from {}.gct", case.name)];
        let options = plcopen::Options { body, header, ..plcopen::Options::default() };
        let text = self.made(case, Encoding::default(), true, Product::Code(Target::Plcopen(options)));
        self.expect(file, &text);
    }

    fn stages(&mut self, case: &Case) {
        let file = |stage: &str| format!("dumps/{}/{stage}.txt", case.name);
        for (stage, encoding, product) in [
            ("ast", Encoding::SinglePhase, Product::Tree),
            ("model", Encoding::SinglePhase, Product::Chart),
            ("logic", Encoding::SinglePhase, Product::Equations),
            ("scan", Encoding::SinglePhase, Product::Program),
            ("logic-switch", Encoding::Switch, Product::Equations),
            ("scan-switch", Encoding::Switch, Product::Program),
        ] {
            let text = self.made(case, encoding, true, product);
            self.expect(file(stage), &text);
        }
        let mut last = String::new();
        for (place, pass) in passes::ORDER.iter().enumerate() {
            let encoding = if pass.for_overlap { Encoding::RTrigger } else { Encoding::SinglePhase };
            let text = self.made(case, encoding, true, Product::NetAfter(pass.name.to_string()));
            self.expect(file(&format!("net-{}-{}", place + 1, pass.name)), &text);
            last = if pass.for_overlap { last } else { text };
        }
        // So there is no file of it.
        assert_eq!(self.made(case, Encoding::SinglePhase, true, Product::Net), last);
    }
}

#[test]
fn what_the_compiler_writes_is_as_it_was_read_last() {
    let mut golden = Golden::default();
    for case in cases(&charts_folder()) {
        golden.code(&case, Encoding::default(), true, &case.name);
        if IN_EVERY_ENCODING.contains(&case.name.as_str()) {
            for encoding in Encoding::ALL.into_iter().filter(|encoding| *encoding != Encoding::default()) {
                golden.code(&case, encoding, true, &format!("{}/{}", encoding.name(), case.name));
            }
            golden.code(&case, Encoding::default(), false, &format!("not-optimized/{}", case.name));
        }
        if IN_RUST.contains(&case.name.as_str()) {
            for encoding in Encoding::ALL {
                golden.rust(&case, encoding, format!("rust/{}_{}.rs", case.name, encoding.name().replace('-', "_")));
            }
        }
        if case.name == IN_JAVASCRIPT.0 {
            for encoding in [Encoding::SinglePhase, Encoding::Switch] {
                for (ending, observed) in IN_JAVASCRIPT.1 {
                    let file = format!("js/{}_{}{ending}", case.name, encoding.name().replace('-', "_"));
                    golden.javascript(&case, encoding, observed, &file);
                }
            }
        }
        for (_, body, language) in AS_PROJECT.into_iter().filter(|(name, ..)| *name == case.name) {
            golden.project(&case, body, format!("plcopen/{}_{language}.xml", case.name));
        }
        if STAGE_BY_STAGE.contains(&case.name.as_str()) {
            golden.stages(&case);
        }
    }
    let count = |start: &str| golden.files.iter().filter(|file| file.starts_with(start)).count();
    assert!(golden.files.iter().filter(|file| !file.contains('/')).count() >= 3 * 16, "charts are missing");
    assert_eq!(count("switch/"), 3 * IN_EVERY_ENCODING.len());
    assert_eq!(count("rust/"), IN_RUST.len() * Encoding::ALL.len());
    assert_eq!(count("js/"), 2 * 2 * IN_JAVASCRIPT.1.len());
    assert_eq!(count("plcopen/"), AS_PROJECT.len());
    assert_eq!(count("dumps/"), STAGE_BY_STAGE.len() * (6 + passes::ORDER.len()));
    assert_eq!(present(), golden.files, "golden files without a chart");
}

/// All files in the folder.
fn present() -> BTreeSet<String> {
    let root = folder();
    let mut files = BTreeSet::new();
    let mut folders = vec![root.clone()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of golden files") {
            let path = entry.expect("a golden file").path();
            if path.is_dir() {
                folders.push(path);
            } else if let Ok(file) = path.strip_prefix(&root) {
                files.insert(file.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    files
}
