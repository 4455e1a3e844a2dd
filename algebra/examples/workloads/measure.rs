//! Time and memory of one workload.

use std::fs;
use std::time::{Duration, Instant};

use crate::hash::hash;
use crate::{Measurement, Workload};

/// A workload runs at least this often.
const LEAST_RUNS: usize = 5;
/// A workload runs at most this often.
const MOST_RUNS: usize = 200;
/// Further runs are made for so long.
const LONG_ENOUGH: Duration = Duration::from_secs(1);

/// Runs a workload several times. The results of earlier runs are dropped before the next one begins.
pub(crate) fn run(workload: &Workload) -> Measurement {
    let mut work = (workload.prepare)();
    let mut times = Vec::new();
    let begin = Instant::now();
    let result = loop {
        let start = Instant::now();
        let result = work();
        times.push(start.elapsed());
        let enough = times.len() >= LEAST_RUNS && begin.elapsed() >= LONG_ENOUGH;
        if enough || times.len() == MOST_RUNS {
            break result;
        }
    };
    let peak_mib = peak_mib();
    times.sort();
    Measurement {
        name: workload.name.to_owned(),
        median_ms: (milliseconds(times[(times.len() - 1) / 2]) + milliseconds(times[times.len() / 2])) / 2.0,
        min_ms: milliseconds(times[0]),
        runs: times.len(),
        terms: result.iter().map(|poly| poly.terms().len()).collect(),
        hash: hash(&result, workload.variables),
        peak_mib,
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The largest resident size of this process so far, as Linux tells it.
fn peak_mib() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib / 1024.0)
}
