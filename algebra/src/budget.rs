//! Deterministic budgets for work that could explode.
//!
//! Exact computation can ask for more time and memory than there is: `(1 + u)^(10^9)` is a short input. Every loop of
//! this crate whose length is not bounded by the size of data that already exists therefore *spends* units of work,
//! roughly one unit for one product of two coefficients of a machine word. The units depend on the input alone, never on a clock, so a
//! computation that ends on one machine ends on all.
//!
//! [`with_budget`] runs a computation under a limit. When the limit is reached, the computation is left by unwinding
//! (never by a panic message) and `with_budget` returns [`Exhausted`], which names what was being computed. This keeps
//! the arithmetic free of error plumbing, so that formulas in code read as they do on paper; no partial result can
//! escape, because everything computed under the limit is dropped on the way out.

use std::cell::RefCell;
use std::fmt;
use std::panic::{self, AssertUnwindSafe};

/// The limit that [`with_budget`] is given where nothing else is known: some ten seconds of optimized work, at 20 to 50 ns
/// a unit.
pub const DEFAULT_LIMIT: u64 = 300_000_000;

/// The error of a computation that reached its limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exhausted {
    /// The limit in units of work.
    pub limit: u64,
    /// What was being computed, outermost task first.
    pub doing: Vec<String>,
    /// A reason other than the number of units, such as an exponent beyond the representable range.
    pub reason: Option<String>,
}

impl fmt::Display for Exhausted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.reason {
            Some(reason) => write!(f, "{reason}")?,
            None => write!(f, "this needs more than the budget of {} units of work", self.limit)?,
        }
        if let Some(innermost) = self.doing.last() {
            write!(f, "; it was computing {innermost}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Exhausted {}

#[derive(Default)]
struct Account {
    spent: u64,
    limit: Option<u64>,
    doing: Vec<String>,
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
        (outer, account.doing.len())
    });
    let outcome = panic::catch_unwind(AssertUnwindSafe(work));
    ACCOUNT.with_borrow_mut(|account| {
        account.limit = outer_limit;
        account.doing.truncate(depth);
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
        account.limit.is_some_and(|limit| account.spent > limit)
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

/// Runs `work` as the task `what`, which an error will name.
pub fn doing<T>(what: impl Into<String>, work: impl FnOnce() -> T) -> T {
    ACCOUNT.with_borrow_mut(|account| account.doing.push(what.into()));
    let value = work();
    ACCOUNT.with_borrow_mut(|account| {
        account.doing.pop();
    });
    value
}

/// Leaves the computation because a number, such as an exponent, is beyond the representable range.
///
/// Outside [`with_budget`] this unwinds as a panic does.
pub fn refuse(reason: impl Into<String>) -> ! {
    leave(Some(reason.into()))
}

fn leave(reason: Option<String>) -> ! {
    let (doing, limit) =
        ACCOUNT.with_borrow(|account| (account.doing.clone(), account.limit.unwrap_or(u64::MAX)));
    panic::resume_unwind(Box::new(Exhausted { limit, doing, reason }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_the_innermost_task() {
        let error = with_budget(10, || doing("the normal", || doing("a product", || spend(11)))).unwrap_err();
        assert_eq!(error.doing, ["the normal", "a product"]);
        assert!(error.to_string().ends_with("it was computing a product"));
        // The account is clean again.
        assert_eq!(with_budget(10, || spend(10)), Ok(()));
    }

    #[test]
    fn inner_limits_never_exceed_the_outer_one() {
        let outer = with_budget(10, || with_budget(1000, || spend(11)).is_err());
        assert_eq!(outer, Ok(true));
    }

    #[test]
    fn other_panics_pass_through() {
        let caught =
            panic::catch_unwind(|| with_budget(10, || panic::resume_unwind(Box::new("other"))).is_ok());
        assert!(caught.is_err());
    }
}
