//! The performance figures, each as a ratio to a baseline of the same run: `cargo bench`.
//!
//! Machines differ and are noisy; ratios within one run are what can be compared.

use std::hint::black_box;
use std::io::Read;
use std::ops::ControlFlow;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use bevelscope::bearing::{Bearing, Data, Held, Kind, Vector, equilibrium};
use bevelscope::comparison::{compare, solve, solve_with_bearings};
use bevelscope::design::{self, Design};
use bevelscope::model::{Model, ModelKind, Rotors};
use bevelscope::response::{Modes, Solved, direct_spectrum, frequency_lines};
use portable_pty::{CommandBuilder, PtySize, native_pty_system};

const PROGRAM: &str = env!("CARGO_BIN_EXE_bevelscope");
const DESIGN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/designs/overhung-elastic.toml");

fn main() {
    let text = std::fs::read_to_string(DESIGN).expect("shipped design");
    let design = design::read(&text).design.expect("valid design");
    println!("overhung-elastic: 92 coordinates, {} lines; medians\n", design.analysis.frequency_lines);
    kernels(&design, &text);
    equilibria();
    processes();
}

/// Ball and roller bearings: random loads that come from a displacement, so that there is an equilibrium; and a shaft under torque.
fn equilibria() {
    const CASES: usize = 10_000;
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let cases: Vec<(Bearing, Vector, Held)> = std::iter::repeat_with(|| random.case()).flatten().take(CASES).collect();
    let start = Instant::now();
    let balanced = cases.iter().filter(|(bearing, load, held)| equilibrium(bearing, load, held).is_ok()).count();
    let each = start.elapsed() / CASES as u32;
    println!("\nbearing equilibria: {balanced} of {CASES} random cases found, {} each", shown(each));
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/designs/tapered-axle.toml");
    let design = design::read(&std::fs::read_to_string(path).expect("shipped design")).design.expect("valid design");
    let rotors = Rotors::new(&design).expect("rotors");
    let fresh = median(21, || drop(black_box(Rotors::new(&design))));
    let kept = median(21, || drop(black_box(Rotors::reusing(&design, Some(&rotors)))));
    println!("tapered-axle: rotors with mean states {}, with those of before {}", shown(fresh), shown(kept));
}

/// Numbers without a library for them (xorshift).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A bearing with the loads of a displacement; nothing where no element is in contact.
    fn case(&mut self) -> Option<(Bearing, Vector, Held)> {
        let radius = 0.01 * 15_f64.powf(self.unit());
        let sort = (3.0 * self.unit()) as usize;
        let (kind, stiffness) = match sort {
            0 => (Kind::Ball { groove_distance: 0.012 * radius }, 1e10),
            1 => (Kind::Roller { length: 0.0 }, 1e9),
            _ => (Kind::Roller { length: 0.4 * radius }, 1e9),
        };
        let contact_angle = (100.0 * self.unit() - 50.0).to_radians();
        let bearing = Bearing::new(Data {
            elements: 5 + (25.0 * self.unit()) as usize,
            contact_angle,
            clearance: 8e-6 * self.unit(),
            radius,
            contact_stiffness: stiffness * (0.2 + 5.0 * self.unit()),
            kind,
        });
        let bearing = bearing.ok()?;
        let size = 2e-6 * 20_f64.powf(self.unit());
        let mut q = Vector::from_fn(|i, _| (2.0 * self.unit() - 1.0) * if i < 3 { size } else { size / radius });
        q[2] = q[2].abs() * contact_angle.signum() + 0.3 * q[2];
        let held = if sort == 1 { [None, None, None, Some(q[3]), Some(q[4])] } else { [None; 5] };
        (bearing.energy(&q) > 0.0).then(|| (bearing, Vector::from(bearing.load(&q.into())), held))
    }
}

/// What a comparison costs beside the direct solve of the finite element model alone.
fn kernels(design: &Design, text: &str) {
    let rotors = Rotors::new(design).expect("rotors");
    let lines = frequency_lines(&design.analysis);
    let fe = Model::new(ModelKind::Fe, design, &rotors).expect("model");
    let direct = median(3, || drop(black_box(direct_spectrum(&fe, &lines))));
    println!("direct solve, FE, dense complex LU a line    {:>10}", shown(direct));
    let beside = |name: &str, time: Duration| {
        let ratio = direct.as_secs_f64() / time.as_secs_f64();
        println!("{name:<44} {:>10}   1/{ratio:.0} of the direct solve", shown(time));
    };
    beside("comparison: 3 models, 3 spectra, agreement", median(51, || drop(black_box(compare(design)))));
    beside("  rotors: statics and bending modes", median(51, || drop(black_box(Rotors::new(design)))));
    for kind in ModelKind::ALL.into_iter().chain([ModelKind::Reduced(3)]) {
        let time = median(51, || drop(black_box(solve(kind, design, &rotors, &lines))));
        beside(&format!("  {}: model, modes, spectrum", kind.name()), time);
    }
    let forces = || drop(black_box(solve_with_bearings(ModelKind::Fe, design, &rotors, &lines)));
    beside("  fe with the forces of all bearings", median(51, forces));
    beside("all modes of FE with the mesh", median(11, || drop(black_box(Modes::new(&fe, usize::MAX)))));
    let solved = Solved::new(fe).expect("modes of the rotors");
    let from_those = || drop(black_box(solved.modes_over(&mut |_| ControlFlow::Continue(()))));
    beside("  from those of the rotors", median(11, from_those));
    beside("reading the design file", median(51, || drop(black_box(design::read(text)))));
}

/// Whole processes, beside one that does nothing but start.
fn processes() {
    let version = median(31, || run(&["--version"]));
    println!("\nprocess: bevelscope --version                {:>10}", shown(version));
    let beside = |name: &str, time: Duration| {
        let ratio = time.as_secs_f64() / version.as_secs_f64();
        println!("{name:<44} {:>10}   {ratio:.1} times --version", shown(time));
    };
    beside("process: bevelscope solve --format json", median(31, || run(&["solve", DESIGN, "--format", "json"])));
    beside("process: bevelscope check", median(31, || run(&["check", DESIGN])));
    let in_terminal = median_of(31, || first_output(&["--version"]));
    println!("\nin a pseudo-terminal: --version, first byte  {:>10}", shown(in_terminal));
    let frame = median_of(31, || first_output(&["--ascii", DESIGN]));
    let ratio = frame.as_secs_f64() / in_terminal.as_secs_f64();
    println!("{:<44} {:>10}   {ratio:.1} times --version", "explorer: start to first frame", shown(frame));
}

fn run(arguments: &[&str]) {
    let status = Command::new(PROGRAM).args(arguments).stdout(Stdio::null()).status().expect("the program runs");
    assert!(status.success(), "{arguments:?}: {status}");
}

/// Starts the program in a pseudo-terminal and waits for a whole first frame (or for the end, where there is none).
fn first_output(arguments: &[&str]) -> Duration {
    // the last line of the explorer's first frame
    const LAST_OF_FRAME: &[u8] = b"quit";
    let pair = native_pty_system().openpty(PtySize { rows: 40, cols: 120, ..PtySize::default() }).expect("a pty");
    let mut command = CommandBuilder::new(PROGRAM);
    command.args(arguments);
    let start = Instant::now();
    let mut child = pair.slave.spawn_command(command).expect("the program runs");
    drop(pair.slave);
    let mut reader = pair.master.try_clone_reader().expect("a reader");
    let (mut seen, mut chunk) = (Vec::new(), [0; 4096]);
    while !seen.windows(LAST_OF_FRAME.len()).any(|window| window == LAST_OF_FRAME) {
        match reader.read(&mut chunk) {
            Ok(0) | Err(_) => break,
            Ok(count) => seen.extend_from_slice(&chunk[..count]),
        }
    }
    let time = start.elapsed();
    // ending it politely takes longer than the figure
    let _ = child.kill();
    let _ = child.wait();
    time
}

/// Median time of a number of runs.
fn median(runs: usize, mut work: impl FnMut()) -> Duration {
    median_of(runs, || {
        let start = Instant::now();
        work();
        start.elapsed()
    })
}

/// Median of times that the work measures itself.
fn median_of(runs: usize, work: impl FnMut() -> Duration) -> Duration {
    let mut times: Vec<Duration> = std::iter::repeat_with(work).take(runs).collect();
    times.sort();
    times[runs / 2]
}

fn shown(time: Duration) -> String {
    let milliseconds = time.as_secs_f64() * 1e3;
    if milliseconds < 1.0 { format!("{:.0} us", milliseconds * 1e3) } else { format!("{milliseconds:.1} ms") }
}
