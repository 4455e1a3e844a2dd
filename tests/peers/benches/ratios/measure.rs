//! Several ways to do one piece of work, checked against a reference and measured in turns.
//!
//! A benchmark library times one function after the other, and a machine that is shared changes its speed in between. Here the
//! alternatives take turns for some rounds, and the best time of each counts, so that ratios hold where absolute figures do not.

use std::hint::black_box;
use std::time::{Duration, Instant};

/// How long an alternative is run in its turn.
const TURN: Duration = Duration::from_millis(20);

/// What the command line asks for.
pub(crate) struct Settings {
    rounds: usize,
    /// Words of the titles of the works to run; all if there are none.
    words: Vec<String>,
    /// Alternatives are checked, but not timed: so `cargo test --benches` runs this.
    check_only: bool,
}

impl Settings {
    /// Those of the arguments: words, `--rounds N`, and `--bench`, which `cargo bench` adds.
    pub(crate) fn from_arguments() -> Result<Self, String> {
        let mut settings = Self { rounds: 20, words: Vec::new(), check_only: true };
        let mut arguments = std::env::args().skip(1);
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "--bench" => settings.check_only = false,
                "--rounds" => {
                    let count =
                        arguments.next().and_then(|count| count.parse().ok()).filter(|&count| count > 0);
                    settings.rounds = count.ok_or("--rounds takes a positive number")?;
                }
                option if option.starts_with('-') => return Err(format!("unknown option {option}")),
                word => settings.words.push(word.to_lowercase()),
            }
        }
        Ok(settings)
    }

    /// Whether a work of this title is to be run.
    pub(crate) fn include(&self, title: &str) -> bool {
        let title = title.to_lowercase();
        self.words.is_empty() || self.words.iter().any(|word| title.contains(word))
    }
}

/// The results from one index on: how many, and each.
pub(crate) type Sink<'s, const L: usize> = dyn FnMut(usize, usize, &dyn Fn(usize) -> [f64; L]) + 's;

/// The result at an index.
type Reference<'a, const L: usize> = Box<dyn Fn(usize) -> [f64; L] + 'a>;

type Run<'a, const L: usize> = Box<dyn FnMut(&mut Sink<'_, L>) + 'a>;

/// A piece of work, with its alternatives; the first one is that which the others are compared with.
pub(crate) struct Work<'a, const L: usize> {
    title: String,
    alternatives: Vec<Alternative<'a, L>>,
}

struct Alternative<'a, const L: usize> {
    name: String,
    points: usize,
    /// What it should find at each index, if anything.
    reference: Option<Reference<'a, L>>,
    /// How far results may be off, relative to the largest number at the index.
    tolerance: f64,
    /// The ratio to this alternative that is asked for.
    wanted: Option<f64>,
    run: Run<'a, L>,
    /// The best time of a run.
    seconds: f64,
}

impl<'a, const L: usize> Work<'a, L> {
    /// A work without alternatives.
    pub(crate) fn new(title: &str) -> Self {
        Self { title: title.to_owned(), alternatives: Vec::new() }
    }

    /// An alternative that computes so many points and passes all of them on; the reference has what it should find at each.
    pub(crate) fn with(
        mut self,
        name: &str,
        points: usize,
        reference: impl Fn(usize) -> [f64; L] + 'a,
        run: impl FnMut(&mut Sink<'_, L>) + 'a,
    ) -> Self {
        let reference: Reference<'a, L> = Box::new(reference);
        self.add(name, points, Some(reference), Box::new(run));
        self
    }

    /// An alternative that computes nothing, and takes the time that so many points would at the same rate.
    pub(crate) fn measure_only(mut self, name: &str, points: usize, mut run: impl FnMut() + 'a) -> Self {
        self.add(name, points, None, Box::new(move |_| run()));
        self
    }

    fn add(&mut self, name: &str, points: usize, reference: Option<Reference<'a, L>>, run: Run<'a, L>) {
        let (name, tolerance) = (name.to_owned(), 1e-12);
        let seconds = f64::INFINITY;
        self.alternatives.push(Alternative {
            name,
            points,
            reference,
            tolerance,
            wanted: None,
            run,
            seconds,
        });
    }

    /// The last alternative may be this far off the reference, relative to the largest number at the index, instead of 1e-12.
    pub(crate) fn within(mut self, tolerance: f64) -> Self {
        if let Some(last) = self.alternatives.last_mut() {
            last.tolerance = tolerance;
        }
        self
    }

    /// The ratio that the first alternative should reach to that of a name.
    pub(crate) fn wanted(mut self, name: &str, ratio: f64) -> Self {
        let of_name = self.alternatives.iter_mut().find(|alternative| alternative.name == name);
        of_name.expect("an alternative of this name").wanted = Some(ratio);
        self
    }

    /// Checks the alternatives, times them in turns and prints the table.
    ///
    /// # Errors
    /// The first alternative that does not do the work.
    pub(crate) fn measure(mut self, settings: &Settings) -> Result<(), String> {
        if !settings.include(&self.title) {
            return Ok(());
        }
        self.check()?;
        if settings.check_only {
            println!("{}: {} alternatives agree", self.title, self.alternatives.len());
            return Ok(());
        }
        for _ in 0..settings.rounds {
            for alternative in &mut self.alternatives {
                alternative.take_turn();
            }
        }
        self.print();
        Ok(())
    }

    fn check(&mut self) -> Result<(), String> {
        for Alternative { name, points, reference, tolerance, run, .. } in &mut self.alternatives {
            let (mut found_points, mut wrong) = (0, None);
            run(&mut |first, count, results| {
                found_points += count;
                let Some(reference) = reference else { return };
                // Every result of short lists, else some, spread over all of the work.
                for k in (0..count).step_by(count.div_ceil(1000)).chain(count.checked_sub(1)) {
                    let (found, expected) = (results(k), reference(first + k));
                    let size = expected.iter().fold(1.0_f64, |size, c| size.max(c.abs()));
                    if !found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= *tolerance * size) {
                        wrong = Some((first + k, found, expected));
                    }
                }
            });
            if let Some((index, found, expected)) = wrong {
                return Err(format!("{}: {name} finds {found:?} at {index}, not {expected:?}", self.title));
            }
            if reference.is_some() && found_points != *points {
                return Err(format!("{}: {name} finds {found_points} points, not {points}", self.title));
            }
        }
        Ok(())
    }

    /// A line for each alternative: its rate, its time for a point, and the first one's rate in units of it.
    fn print(&self) {
        println!("\n{}", self.title);
        println!("{:40}{:>11}{:>10}{:>9}{:>11}", "", "M points/s", "ns/point", "ratio", "wanted");
        let rate = |of: &Alternative<'_, L>| of.points as f64 / of.seconds;
        for alternative in &self.alternatives {
            let ratio = rate(&self.alternatives[0]) / rate(alternative);
            let wanted = match alternative.wanted {
                None => String::new(),
                Some(wanted) if ratio >= wanted => format!("{wanted:.2} met"),
                Some(wanted) => format!("{wanted:.2} NOT"),
            };
            let (millions, nanoseconds) = (1e-6 * rate(alternative), 1e9 / rate(alternative));
            println!("{:40}{millions:11.1}{nanoseconds:10.2}{ratio:9.2}{wanted:>11}", alternative.name);
        }
    }
}

impl<const L: usize> Alternative<'_, L> {
    /// Runs for some milliseconds.
    ///
    /// The first run is not timed: the others find the caches, and the clocks of memory and processor, as their own kind leaves them.
    fn take_turn(&mut self) {
        (self.run)(&mut use_results);
        let begin = Instant::now();
        while begin.elapsed() < TURN {
            let start = Instant::now();
            (self.run)(&mut use_results);
            self.seconds = self.seconds.min(start.elapsed().as_secs_f64());
        }
    }
}

/// Keeps the compiler from dropping what nobody reads.
fn use_results<const L: usize>(_: usize, _: usize, results: &dyn Fn(usize) -> [f64; L]) {
    black_box(results);
}
