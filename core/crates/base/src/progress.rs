//! How far long work is, and whether it should go on.

use crate::error::{Error, Result};

/// Told a share of the work, 0 to 1, and what is being done. False asks it to stop.
pub type Progress<'a> = dyn Fn(f64, &str) -> bool + Sync + 'a;

/// Work that nobody watches.
pub const UNWATCHED: &Progress<'static> = &|_, _| true;

/// Tells; fails with [`Error::Cancelled`] where the answer is to stop.
pub fn tell(progress: &Progress, share: f64, text: &str) -> Result<()> {
    if progress(share, text) {
        Ok(())
    } else {
        Err(Error::Cancelled)
    }
}
