include!(concat!(env!("OUT_DIR"), "/blink.rs"));

use blink::Blink;
use grafc_runtime::Runner;
use std::ops::ControlFlow;

fn main() {
    let mut runner = Runner::new(Blink::new(), 10);
    let mut lit = false;
    runner.run(
        // Here sensors are read; this chart has no inputs.
        |_now, _inputs| (),
        |chart| {
            let outputs = chart.outputs();
            if outputs.led != lit {
                lit = outputs.led;
                println!("{}", if lit { "on" } else { "off" });
            }
            let done = outputs.blinks == 3 && !lit;
            if done { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        },
    );
}
