//! Arguments as what the library calls a request.

use std::num::NonZeroUsize;

use pyo3::prelude::*;
use radiosity::elements::cells::Layers;
use radiosity::formats::{format::Format, model::Sides};
use radiosity::published::zatz1993::masked_light::Masking;
use radiosity::reading::grid::Rates;
use radiosity::reading::quality::Quality;
use radiosity::request::{HeatRequest, ImportRequest, MethodRequest, ReadRequest, TransferRequest, ranges};
use radiosity::scene::{MAX_ORDER, MAX_PARTS};
use radiosity::solve::MOST_RAYS;
use radiosity_solvers::method::Method;

use crate::arguments::Arguments;
use crate::error::Trouble;

/// Request for the computation of light.
pub(crate) fn method(given: &mut Arguments<'_>) -> PyResult<MethodRequest> {
    let usual = MethodRequest::default();
    let layers = Layers {
        count: given.count("layers", &ranges::LAYERS)?.unwrap_or(usual.layers.count),
        ratio: given.number("ratio", ranges::fraction)?.unwrap_or(usual.layers.ratio),
    };
    Ok(MethodRequest {
        quality: given.named::<Quality>("quality")?.unwrap_or(usual.quality),
        method: given.named("method")?.unwrap_or(usual.method),
        basis: given.named("basis")?.unwrap_or(usual.basis),
        order: given.read("order", str::parse)?,
        accuracy: given.number("accuracy", ranges::fraction)?,
        aim: None,
        time_limit: given.number("time_limit", ranges::seconds)?,
        tensor: given.flag("tensor")?,
        subdivide: subdivide(given)?,
        layers,
        eps: given.number("eps", ranges::accuracy)?,
        kernel: given.named("kernel")?.unwrap_or(usual.kernel),
        transport: given.named("transport")?.unwrap_or(usual.transport),
        rays: given.whole("rays", &(1..=MOST_RAYS))?,
        solver: given.read("solver", Method::named)?.unwrap_or(usual.solver),
        preconditioner: given.named("preconditioner")?.unwrap_or(usual.preconditioner),
        bounces: given.count("bounces", &ranges::BOUNCES)?,
        tolerance: given.number("tolerance", ranges::positive)?.unwrap_or(usual.tolerance),
        max_iterations: given.count("max_iterations", &ranges::ITERATIONS)?.unwrap_or(usual.max_iterations),
        shadows: given.named("shadows")?.unwrap_or(usual.shadows),
        direct: given.named("direct")?.unwrap_or(usual.direct),
        shadow_eps: given.number("shadow_eps", ranges::accuracy)?,
        masks: masks(given)?,
        memory: given.bytes("memory")?,
        threads: threads(given)?,
    })
}

/// Cells and averages of shadow masks.
fn masks(given: &mut Arguments<'_>) -> PyResult<Masking> {
    let usual = Masking::default();
    let cells = given.count("mask_cells", &ranges::MASK_CELLS)?.and_then(NonZeroUsize::new);
    let average = given.named("mask_average")?.unwrap_or(usual.average);
    Ok(Masking { cells: cells.unwrap_or(usual.cells), average })
}

/// Elements along a side of each surface; None chooses.
fn subdivide(given: &mut Arguments<'_>) -> PyResult<Option<usize>> {
    let parts = |text: &str| match text {
        "auto" => Ok(None),
        text => {
            let parts = text.parse().ok().filter(|parts| (1..=MAX_PARTS).contains(parts));
            parts.map(Some).ok_or_else(|| format!("expected a whole number from 1 to {MAX_PARTS}, or auto"))
        }
    };
    Ok(given.read("subdivide", parts)?.flatten())
}

/// Number of threads; None for the usual number.
pub(crate) fn threads(given: &mut Arguments<'_>) -> PyResult<Option<usize>> {
    given.count("threads", &ranges::THREADS)
}

/// Request for the reading of a solution.
pub(crate) fn reading(given: &mut Arguments<'_>) -> PyResult<ReadRequest> {
    let (read, by) = (given.named("read")?, given.named("read_by")?);
    let eps = given.number("read_eps", ranges::accuracy)?;
    Ok(ReadRequest { read, by, eps, samples: None })
}

/// Request for the reading of means over the cells of a solution.
pub(crate) fn reading_of_cells(given: &mut Arguments<'_>) -> PyResult<ReadRequest> {
    let rates = given.pair("read_samples", &ranges::POINTS)?;
    let samples = rates.map(|[direct, indirect]| Rates { direct, indirect });
    Ok(ReadRequest { samples, ..reading(given)? })
}

/// Request for the integration of transfers, to the relative accuracy `eps` unless another one is given.
pub(crate) fn transfers(given: &mut Arguments<'_>, eps: f64) -> PyResult<TransferRequest> {
    let usual = TransferRequest::new(eps);
    Ok(TransferRequest {
        subdivide: subdivide(given)?,
        eps: given.number("eps", ranges::accuracy)?.unwrap_or(usual.eps),
        shadow_eps: given.number("shadow_eps", ranges::accuracy)?,
        shadows: given.named("shadows")?.unwrap_or(usual.shadows),
        threads: threads(given)?,
    })
}

/// Request for a balance of heat.
pub(crate) fn heat(given: &mut Arguments<'_>) -> PyResult<HeatRequest> {
    let usual = HeatRequest::default();
    Ok(HeatRequest {
        transfers: transfers(given, TransferRequest::HEAT)?,
        order: given.count("order", &(0..=MAX_ORDER as u64))?.unwrap_or(usual.order),
        transport: given.named("transport")?.unwrap_or(usual.transport),
        solver: given.read("solver", Method::named)?.unwrap_or(usual.solver),
        memory: given.bytes("memory")?,
        conductances: given.flag("conductances")?,
    })
}

/// Options of the import of a scene of another program.
pub(crate) fn import(given: &mut Arguments<'_>) -> PyResult<ImportRequest> {
    let format = |text: &str| {
        let names = || Format::ALL.map(Format::name).join(", ");
        let known = Format::ALL.into_iter().find(|format| format.name() == text);
        known.ok_or_else(|| format!("expected one of {}", names()))
    };
    Ok(ImportRequest {
        format: given.read("format", format)?,
        sides: sides(given)?,
        materials: given.path("materials")?,
        unit: given.read("unit", str::parse)?,
        up: given.read("up", str::parse)?,
        fix_fronts: given.flag("fix_fronts")?,
        grey: given.flag("grey")?,
    })
}

fn sides(given: &mut Arguments<'_>) -> PyResult<Option<Sides>> {
    match (given.flag("one_sided")?, given.flag("two_sided")?) {
        (true, true) => {
            Err(Trouble::new("one_sided= does not go with two_sided=", "leave one of them out").into())
        }
        (true, false) => Ok(Some(Sides::Front)),
        (false, true) => Ok(Some(Sides::Both)),
        (false, false) => Ok(None),
    }
}
