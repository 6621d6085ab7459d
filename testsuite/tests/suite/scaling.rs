//! What is written for a chart of any shape grows as the chart does, in every encoding.

use grafc::{Options, Product};
use grafc_backends::{Target, js, st};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::Profile;
use grafc_testsuite::scaling::{SHAPES, ScalingShape};

/// Twice the size takes about twice the text; where it grew with the square, it would take four times as much.
const AT_MOST: f64 = 2.6;

fn length(shape: &ScalingShape, size: usize, encoding: Encoding, target: &Target) -> usize {
    let lowering = Lowering { profile: Profile::default(), encoding, simplify: true };
    let options = Options::new(lowering, Product::Code(target.clone()));
    let (made, said) = grafc::compile(FileId::default(), &(shape.write)(size), shape.name, &options);
    made.unwrap_or_else(|| panic!("{}: {said:?}", shape.name)).text.len()
}

#[test]
fn texts_grow_with_their_charts() {
    for shape in &SHAPES {
        for encoding in Encoding::ALL {
            for target in [
                Target::St(st::Options::default()),
                Target::Js(js::Options { observed: true, ..js::Options::default() }),
            ] {
                let [small, large] = [300, 600].map(|size| length(shape, size, encoding, &target));
                let (ratio, target) = (large as f64 / small as f64, target.about().name);
                assert!(
                    ratio < AT_MOST,
                    "{} in {}, {target}: {small} bytes, then {large}",
                    shape.name,
                    encoding.name()
                );
            }
        }
    }
}
