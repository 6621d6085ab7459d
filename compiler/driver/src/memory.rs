//! Where the allocator takes large tables from.
//!
//! The allocator of glibc takes them from the system and gives them back when they are dropped; but each that is given
//! back makes it keep the next ones of that size on its own heap, where holes stay between what lives on. Of a chart with
//! 100,000 steps these were a third of all memory. A fixed limit keeps it from learning that.

/// Gives large tables back to the system, however often that was done.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[allow(unsafe_code)]
pub fn give_back_large_tables() {
    /// In bytes. Of tables that are larger there are few.
    const LARGE: libc::c_int = 1 << 20;
    // SAFETY: this sets a number of the allocator's, before there is a second thread.
    unsafe { libc::mallopt(libc::M_MMAP_THRESHOLD, LARGE) };
}

/// Other allocators need no telling.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub fn give_back_large_tables() {}
