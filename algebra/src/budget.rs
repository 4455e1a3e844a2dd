//! Deterministic budgets for work that could explode.
//!
//! Exact computation can ask for more time and memory than there is: `(1 + u)^(10^9)` is a short input. Every loop of
//! this crate whose length is not bounded by the size of data that already exists therefore *spends* units of work,
//! roughly one unit for what takes 30 ns. The units depend on the input alone, never on a clock, so a
//! computation that ends on one machine ends on all. What needs much memory [reserves](reserve) it first, so that a
//! budget bounds memory as well.
//!
//! [`with_budget`] runs a computation under a limit. When the limit is reached, the computation is left by unwinding
//! (never by a panic message) and `with_budget` returns [`Exhausted`], which says what was being computed and how far it
//! came. This keeps the arithmetic free of error plumbing, so that formulas in code read as they do on paper; no partial
//! result can escape, because everything computed under the limit is dropped on the way out.

use std::borrow::Cow;
use std::cell::RefCell;
use std::fmt;
use std::panic::{self, AssertUnwindSafe};

/// The limit that [`with_budget`] is given where nothing else is known: some ten seconds of optimized work, at some 30 ns
/// a unit.
pub const DEFAULT_LIMIT: u64 = 300_000_000;

/// The error of a computation that reached its limit.
///
/// # Example
/// ```
/// use hodograph_algebra::budget::{doing, progress, spend, with_budget};
/// let work = || {
///     doing("the coordinates", || spend(4_000));
///     doing("the normal", || {
///         for k in 0..8 {
///             progress(k, 8);
///             spend(2_000);
///         }
///     });
/// };
/// let error = with_budget(10_000, work).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "this needs more than the budget of 10000 units of work; it was computing the normal (3 of 8 steps done), after the \
///      coordinates (4000 units)"
/// );
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exhausted {
    /// The limit in units of work.
    pub limit: u64,
    /// What was being computed, outermost task first.
    pub doing: Vec<String>,
    /// The tasks that were finished under the limit before, as parts of those in [`doing`](Self::doing), in the order in
    /// which they were begun; tasks of one name together.
    pub done: Vec<Finished>,
    /// How far the innermost task that counts its steps came, if one does: the steps done, and how many there are.
    pub progress: Option<(u64, u64)>,
    /// A reason other than the number of units, such as an exponent beyond the representable range.
    pub reason: Option<String>,
}

/// Tasks of one name that were finished.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finished {
    /// The name that [`doing`] was given.
    pub task: Cow<'static, str>,
    /// How many times.
    pub times: u64,
    /// The units that they spent together.
    pub units: u64,
}

impl fmt::Display for Exhausted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.reason {
            Some(reason) => write!(f, "{reason}")?,
            None => write!(f, "this needs more than the budget of {} units of work", self.limit)?,
        }
        if let Some((innermost, outer)) = self.doing.split_last() {
            write!(f, "; it was computing {innermost}")?;
            if let Some((done, all)) = self.progress {
                write!(f, " ({done} of {all} steps done)")?;
            }
            for task in outer.iter().rev().take(SHOWN) {
                write!(f, ", for {task}")?;
            }
        }
        // What cost most is what a reader wants to know; it is told in the order in which it was done.
        let mut shown: Vec<&Finished> = self.done.iter().filter(|finished| finished.units > 0).collect();
        shown.sort_by_key(|finished| std::cmp::Reverse(finished.units));
        shown.truncate(SHOWN);
        for (index, finished) in self.done.iter().filter(|finished| shown.contains(finished)).enumerate() {
            f.write_str(match (index, self.doing.is_empty()) {
                (0, true) => "; done before: ",
                (0, false) => ", after ",
                _ => ", ",
            })?;
            finished.fmt(f)?;
        }
        Ok(())
    }
}

/// How many outer tasks, and how many finished ones, the text of an error names at most.
const SHOWN: usize = 4;

impl fmt::Display for Finished {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.task)?;
        if self.times > 1 {
            write!(f, ", {} times", self.times)?;
        }
        match self.units {
            units @ 0..10_000 => write!(f, " ({units} units)"),
            units @ 10_000..10_000_000 => write!(f, " ({} thousand units)", units / 1000),
            units => write!(f, " ({} million units)", units / 1_000_000),
        }
    }
}

impl std::error::Error for Exhausted {}

#[derive(Default)]
struct Account {
    spent: u64,
    limit: Option<u64>,
    /// The open tasks, outermost first; a limit opens one without a name.
    open: Vec<Task>,
}

/// A task that is being done.
struct Task {
    name: Option<Cow<'static, str>>,
    /// What had been spent when it was begun.
    begin: u64,
    progress: Option<(u64, u64)>,
    finished: Vec<Finished>,
}

impl Task {
    fn new(name: Option<Cow<'static, str>>, begin: u64) -> Task {
        Task { name, begin, progress: None, finished: Vec::new() }
    }
}

/// How many names of finished parts of one task are kept.
const MOST_NAMES: usize = 16;

impl Account {
    /// Ends the innermost task, and notes it as a finished part of the one around it.
    fn finish(&mut self) {
        let Some(task) = self.open.pop() else { return };
        let (Some(name), Some(outer)) = (task.name, self.open.last_mut()) else { return };
        let units = self.spent - task.begin;
        if let Some(finished) = outer.finished.iter_mut().find(|finished| finished.task == name) {
            finished.times += 1;
            finished.units = finished.units.saturating_add(units);
        } else if outer.finished.len() < MOST_NAMES {
            outer.finished.push(Finished { task: name, times: 1, units });
        }
    }

    /// The error for leaving now.
    fn exhausted(&self, reason: Option<String>) -> Exhausted {
        let under_limit = self.open.iter().rposition(|task| task.name.is_none()).unwrap_or(0);
        Exhausted {
            limit: self.limit.unwrap_or(u64::MAX),
            doing: self.open.iter().filter_map(|task| task.name.as_ref().map(ToString::to_string)).collect(),
            done: self.open[under_limit..].iter().flat_map(|task| task.finished.clone()).collect(),
            progress: self.open.last().and_then(|task| task.progress),
            reason,
        }
    }
}

thread_local! {
    static ACCOUNT: RefCell<Account> = RefCell::new(Account::default());
}

/// Runs `work` under a limit of `limit` units, and gives its result.
///
/// Budgets nest: what an inner computation spends counts for the outer one as well, and an inner limit never exceeds
/// what the outer one has left.
///
/// # Errors
/// [`Exhausted`] when `work` needs more than `limit` units, or a number beyond the representable range.
///
/// # Example
/// ```
/// use hodograph_algebra::budget;
/// assert_eq!(budget::with_budget(100, || { budget::spend(99); 7 }), Ok(7));
/// let error = budget::with_budget(100, || { budget::spend(101); 7 }).unwrap_err();
/// assert_eq!(error.to_string(), "this needs more than the budget of 100 units of work");
/// ```
pub fn with_budget<T>(limit: u64, work: impl FnOnce() -> T) -> Result<T, Exhausted> {
    let (outer_limit, depth) = ACCOUNT.with_borrow_mut(|account| {
        let outer = account.limit;
        let absolute = account.spent.saturating_add(limit);
        account.limit = Some(outer.map_or(absolute, |outer| outer.min(absolute)));
        account.open.push(Task::new(None, account.spent));
        (outer, account.open.len() - 1)
    });
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    ACCOUNT.with_borrow_mut(|account| {
        account.limit = outer_limit;
        account.open.truncate(depth);
    });
    match outcome {
        Ok(value) => Ok(value),
        Err(payload) => match payload.downcast::<Exhausted>() {
            Ok(exhausted) => Err(Exhausted { limit, ..*exhausted }),
            Err(other) => panic::resume_unwind(other),
        },
    }
}

/// Counts `units` of work, and leaves the computation when the limit is passed.
///
/// Outside [`with_budget`] there is no limit.
pub fn spend(units: u64) {
    let exhausted = ACCOUNT.with_borrow_mut(|account| {
        account.spent = account.spent.saturating_add(units);
        match account.limit {
            Some(limit) if account.spent > limit => {
                // What is left undone is not to be paid for by an outer budget.
                account.spent = limit.saturating_add(1);
                true
            }
            _ => false,
        }
    });
    if exhausted {
        leave(None);
    }
}

/// Leaves the computation if `units` more would pass the limit, without spending them: what cannot be paid for is refused
/// before time and memory go into it.
pub fn require(units: u64) {
    let exhausted = ACCOUNT.with_borrow(|account| {
        account.limit.is_some_and(|limit| account.spent.saturating_add(units) > limit)
    });
    if exhausted {
        leave(None);
    }
}

/// Leaves the computation if the limit, at six bytes a unit, does not allow for `bytes` of memory more: with
/// [`DEFAULT_LIMIT`], nothing takes much more than two gigabytes.
pub fn reserve(bytes: u64) {
    require(bytes / 6);
}

/// The result of `work` and the units that it spent.
///
/// ```
/// use hodograph_algebra::budget;
/// assert_eq!(budget::measured(|| budget::spend(3)), ((), 3));
/// ```
pub fn measured<T>(work: impl FnOnce() -> T) -> (T, u64) {
    let before = spent();
    let value = work();
    (value, spent() - before)
}

/// The units spent so far on this thread.
pub(crate) fn spent() -> u64 {
    ACCOUNT.with_borrow(|account| account.spent)
}

/// The units that the limit leaves on this thread.
pub(crate) fn left() -> u64 {
    ACCOUNT.with_borrow(|account| account.limit.map_or(u64::MAX, |limit| limit.saturating_sub(account.spent)))
}

/// Runs `work` as the task `what`, which an error will name: as what was being done, or as what was finished before.
pub fn doing<T>(what: impl Into<Cow<'static, str>>, work: impl FnOnce() -> T) -> T {
    ACCOUNT.with_borrow_mut(|account| {
        let task = Task::new(Some(what.into()), account.spent);
        account.open.push(task);
    });
    let value = work();
    ACCOUNT.with_borrow_mut(Account::finish);
    value
}

/// Says how far the innermost task has come: `done` of `all` steps.
pub fn progress(done: u64, all: u64) {
    ACCOUNT.with_borrow_mut(|account| {
        if let Some(task) = account.open.last_mut() {
            task.progress = Some((done, all));
        }
    });
}

/// Leaves the computation because a number, such as an exponent, is beyond the representable range.
///
/// Outside [`with_budget`] this unwinds as a panic does.
pub fn refuse(reason: impl Into<String>) -> ! {
    leave(Some(reason.into()))
}

fn leave(reason: Option<String>) -> ! {
    panic::resume_unwind(Box::new(ACCOUNT.with_borrow(|account| account.exhausted(reason))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_what_was_being_done() {
        let error = with_budget(10, || doing("the normal", || doing("a product", || spend(11)))).unwrap_err();
        assert_eq!(error.doing, ["the normal", "a product"]);
        assert!(error.to_string().ends_with("it was computing a product, for the normal"));
        // The account is clean again.
        assert_eq!(with_budget(10, || spend(10)), Ok(()));
    }

    #[test]
    fn tells_what_was_finished_before() {
        let work = || {
            doing("the position", || doing("a product", || spend(2)));
            for _ in 0..3 {
                doing("a root", || spend(1));
            }
            doing("the normal", || {
                doing("a gcd", || spend(3));
                progress(4, 5);
                spend(9)
            });
        };
        let error = with_budget(10, work).unwrap_err();
        let done: Vec<String> = error.done.iter().map(ToString::to_string).collect();
        assert_eq!(done, ["the position (2 units)", "a root, 3 times (3 units)", "a gcd (3 units)"]);
        assert_eq!(error.progress, Some((4, 5)));
        // A task that was left is not finished, and tasks outside of a limit are not told.
        let outer = with_budget(100, || {
            doing("before", || spend(1));
            with_budget(2, || doing("left", || spend(3))).unwrap_err()
        });
        let inner = outer.unwrap();
        assert_eq!((inner.limit, inner.doing.as_slice(), inner.done.len()), (2, &["left".to_owned()][..], 0));
        let mut unit = Finished { task: "it".into(), times: 1, units: 9_999 };
        let texts = [9_999, 10_000, 1_234_567, 34_000_000].map(|units| {
            unit.units = units;
            unit.to_string()
        });
        assert_eq!(
            texts,
            [
                "it (9999 units)",
                "it (10 thousand units)",
                "it (1234 thousand units)",
                "it (34 million units)"
            ]
        );
    }

    #[test]
    fn names_are_kept_within_bounds() {
        let work = || {
            for k in 0..1000 {
                doing(format!("part {k}"), || spend(1));
            }
            refuse("enough")
        };
        let error: Exhausted = with_budget(u64::MAX, work).unwrap_err();
        assert_eq!(error.done.len(), MOST_NAMES);
        assert_eq!(error.to_string().matches("part").count(), SHOWN);
    }

    #[test]
    fn inner_limits_never_exceed_the_outer_one() {
        let outer = with_budget(10, || with_budget(1000, || spend(11)).is_err());
        assert_eq!(outer, Ok(true));
    }

    #[test]
    fn what_is_refused_is_not_paid_for() {
        let outer = with_budget(20, || {
            assert!(with_budget(10, || spend(1_000)).is_err());
            spend(9);
        });
        assert_eq!(outer, Ok(()));
    }

    #[test]
    fn other_panics_pass_through() {
        let caught =
            panic::catch_unwind(|| with_budget(10, || panic::resume_unwind(Box::new("other"))).is_ok());
        assert!(caught.is_err());
    }
}
