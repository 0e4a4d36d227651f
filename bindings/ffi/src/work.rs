//! Long work: told of, stopped, and run where the stack is large enough.

use std::sync::Arc;
use std::thread;

use gyradius_core::progress::{Progress, tell};

use crate::error::{GyradiusError, Result};

/// As much as a main thread has; threads of an app may have no more than 512 KiB.
const STACK_BYTES: usize = 8 << 20;

/// Watches long work.
#[uniffi::export(foreign)]
pub trait ProgressListener: Send + Sync {
    /// Told the share that is done (0 to 1) and what is being done, from a thread of the work;
    /// false stops it, and what was called fails with `Cancelled`.
    fn on_progress(&self, share: f64, doing: String) -> bool;
}

/// Who watches, if anybody does.
pub type Listener = Option<Arc<dyn ProgressListener>>;

/// Runs work on a thread with a large stack.
pub fn aside<T: Send>(work: impl FnOnce() -> gyradius_core::Result<T> + Send) -> Result<T> {
    let started = |error: std::io::Error| GyradiusError::NoResult {
        text: format!("the work: no thread for it: {error}"),
        what: "the work".into(),
    };
    let done = thread::scope(|scope| {
        let worker = thread::Builder::new()
            .stack_size(STACK_BYTES)
            .spawn_scoped(scope, work)?;
        // What the core never does is told by UniFFI as an internal error.
        Ok(worker
            .join()
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    });
    done.map_err(started)?.map_err(GyradiusError::from)
}

/// Runs work that tells how far it is.
pub fn watched<T: Send>(
    listener: &Listener,
    work: impl FnOnce(&Progress) -> gyradius_core::Result<T> + Send,
) -> Result<T> {
    aside(|| work(&|share, doing| goes_on(listener, share, doing)))
}

/// Runs work that cannot be stopped half-way: told of before it, and given up where its listener
/// wants an end by then.
pub fn announced<T: Send>(
    listener: &Listener,
    doing: &str,
    work: impl FnOnce() -> gyradius_core::Result<T> + Send,
) -> Result<T> {
    watched(listener, |progress| {
        tell(progress, 0.0, doing)?;
        let done = work()?;
        tell(progress, 1.0, doing)?;
        Ok(done)
    })
}

fn goes_on(listener: &Listener, share: f64, doing: &str) -> bool {
    listener
        .as_ref()
        .is_none_or(|listener| listener.on_progress(share, doing.to_owned()))
}
