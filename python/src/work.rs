//! Long work: a thread of its own does it, without the lock of the interpreter, while the thread that asked
//! for it waits for signals and tells how far it is.
//!
//! Ctrl-C, or an exception of the observer, interrupts the work ([`radiosity::work::interruption`]).

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::thread;
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use radiosity::work::interruption::Interruption;

use crate::error::Trouble;
use crate::progress::{Progress, Step};

/// Time between two looks for signals, and between two reports of progress. Chosen.
const PERIOD: Duration = Duration::from_millis(50);

/// Does `work`; `observer(stage, done, total)` is called with the progress.
///
/// # Errors
/// Errors of the work; exceptions of a handler of signals or of the observer; a `RuntimeError` where the
/// library has a fault.
pub(crate) fn work<T: Send, E: Into<Trouble> + Send>(
    py: Python<'_>,
    observer: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Progress) -> Result<T, E> + Send,
) -> PyResult<T> {
    let (progress, interruption) = (Progress::default(), Interruption::new());
    let (sender, mut receiver) = sync_channel(1);
    let (raised, outcome) = thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let outcome = catch_unwind(AssertUnwindSafe(|| interruption.within(|| work(&progress))));
            // Nobody waits where the other side is gone.
            let _ = sender.send(());
            outcome
        });
        let mut raised = None;
        while is_working(py, &mut receiver) {
            if raised.is_none() {
                raised = py.check_signals().and_then(|()| report(observer, progress.news())).err();
            }
            if raised.is_some() {
                interruption.raise();
            }
        }
        (raised, py.detach(|| worker.join().and_then(|outcome| outcome)))
    });
    match (raised, outcome) {
        (Some(raised), _) => Err(raised),
        (None, Ok(outcome)) => {
            let outcome = outcome.expect("what interrupts it is raised");
            report(observer, progress.news())?;
            outcome.map_err(|error| error.into().into())
        }
        (None, Err(fault)) => Err(broken(&*fault)),
    }
}

/// Waits a moment; whether there is no end yet.
fn is_working(py: Python<'_>, end: &mut Receiver<()>) -> bool {
    py.detach(move || end.recv_timeout(PERIOD)) == Err(RecvTimeoutError::Timeout)
}

fn report(observer: Option<&Bound<'_, PyAny>>, news: Option<Step>) -> PyResult<()> {
    if let (Some(observer), Some(Step { stage, done, total })) = (observer, news) {
        observer.call1((stage, done, total))?;
    }
    Ok(())
}

/// A fault of the library itself.
fn broken(fault: &(dyn Any + Send)) -> PyErr {
    let text = fault.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| fault.downcast_ref::<&str>().copied()).unwrap_or("no reason is known");
    PyRuntimeError::new_err(format!("radiosity has a fault, please report it: {text}"))
}
