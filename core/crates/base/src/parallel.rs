//! Work side by side, on no more cores than there are.

use std::sync::LazyLock;
use std::sync::atomic::{AtomicIsize, AtomicUsize, Ordering};
use std::thread;

/// Cores on which nothing of ours runs. Calls within one another share them; the thread of a first
/// call is not counted.
static IDLE: LazyLock<AtomicIsize> = LazyLock::new(|| {
    let cores = thread::available_parallelism().map_or(1, |n| n.get());
    AtomicIsize::new(cores as isize - 1)
});

/// A core in use until this goes.
struct InUse;

impl InUse {
    /// One that was idle.
    fn any() -> Option<Self> {
        let less = |idle: isize| (idle > 0).then_some(idle - 1);
        IDLE.fetch_update(Ordering::Relaxed, Ordering::Relaxed, less)
            .ok()
            .map(|_| Self)
    }
}

impl Drop for InUse {
    fn drop(&mut self) {
        IDLE.fetch_add(1, Ordering::Relaxed);
    }
}

/// The core of a thread that waits for others: theirs until this goes.
struct Lent;

impl Lent {
    fn own() -> Self {
        IDLE.fetch_add(1, Ordering::Relaxed);
        Self
    }
}

impl Drop for Lent {
    fn drop(&mut self) {
        IDLE.fetch_sub(1, Ordering::Relaxed);
    }
}

/// `f(0)`, `f(1)`, … on this thread and on as many more as cores are idle.
pub fn in_parallel<T: Send>(count: usize, f: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let (next, f) = (AtomicUsize::new(0), &f);
    let work = || {
        let take = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|i| *i < count);
        std::iter::from_fn(take)
            .map(|i| (i, f(i)))
            .collect::<Vec<_>>()
    };
    let mut found = thread::scope(|scope| {
        let help = |core: InUse| {
            scope.spawn(move || {
                let _core = core;
                work()
            })
        };
        let helpers: Vec<_> = (1..count).map_while(|_| InUse::any()).map(help).collect();
        let mut found = work();
        let _own = Lent::own();
        for helper in helpers {
            found.extend(
                helper
                    .join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            );
        }
        found
    });
    found.sort_by_key(|(i, _)| *i);
    found.into_iter().map(|(_, value)| value).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_within_calls_do_all_in_order() {
        let squares = in_parallel(20, |i| {
            in_parallel(10, |j| i * j).into_iter().sum::<usize>()
        });
        let expected: Vec<usize> = (0..20).map(|i| 45 * i).collect();
        assert_eq!(squares, expected);
        assert!(in_parallel(0, |i| i).is_empty());
    }

    #[test]
    fn a_panic_reaches_the_caller() {
        let panics = std::panic::catch_unwind(|| in_parallel(8, |i| assert_ne!(i, 5, "the sixth")));
        assert!(panics.is_err());
        // What comes later is done all the same.
        assert_eq!(in_parallel(4, |i| i), [0, 1, 2, 3]);
    }
}
