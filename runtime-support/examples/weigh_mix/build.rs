//! Compiles the chart to `$OUT_DIR/weigh_mix.rs`.

use grafc::{Build, Encoding, Runtime};

fn main() {
    Build::new("weigh_mix.gct").encoding(Encoding::Switch).runtime(Runtime::Crate).compile();
}
