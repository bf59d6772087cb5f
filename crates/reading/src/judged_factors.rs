//! View factors judged by a referee: F_ij that are printed, beside the part of the rays of i that meets j.
//!
//! Of the rows that are judged, factors from 1e-3 on count, printed, or found for certain: of fewer a referee tells
//! little, and of many that are about as large those would count that it found too large by chance.
//! Factors of a row make a class of their own. Rows of surfaces on which something stands are left out: their
//! factors are of the whole surface, and rays leave what is open.

use radiosity_audit::{Checked, Effort, Judged, Mean, Verdict, ViewFactorReferee, ViewFactorRow};
use radiosity_scene::Scene;
use radiosity_solve::view_factors::ViewFactors;
use radiosity_work::Work;

/// The least factor that is judged. Chosen: below, thousands of rays meet the other surface a few times.
const LEAST: f64 = 1e-3;

/// Deviations by which a found factor is above that for certain. Chosen: one in thirty thousand is not.
const FOR_CERTAIN: f64 = 4.0;

/// Judged factors.
#[derive(Clone, Debug)]
pub struct JudgedFactors {
    /// The factors, row after row.
    pub factors: Vec<JudgedFactor>,
    /// Rays of each row.
    pub rays: u64,
    /// Verdict of the referee on them.
    pub verdict: Verdict,
    /// Errors that follow from it.
    pub checked: Checked,
}

/// A judged factor, of the class of the surface that it is from.
#[derive(Clone, Debug)]
pub struct JudgedFactor {
    /// Index of the surface that it is from.
    pub from: usize,
    /// Name of the surface that it is to.
    pub to: String,
    /// The printed and the found number.
    pub judged: Judged,
}

impl JudgedFactors {
    /// Judges the pairs that are `wanted` in the rows of these surfaces, by their indices. Where more is found than
    /// the method tells, a second look of four times the rays, with other draws, decides: by chance alone the first
    /// finds more in one of forty right runs. Where time is up before the second is done, the first stands.
    pub fn of(
        scene: &Scene,
        factors: &ViewFactors,
        rows: &[usize],
        wanted: &dyn Fn(usize, usize) -> bool,
        effort: &Effort,
        work: &Work<'_>,
    ) -> Self {
        let referee = ViewFactorReferee::of(scene);
        let effort = effort.of_surfaces();
        let first = Self::judged(factors, &referee.rows(rows, &effort, work), wanted, &effort);
        if !first.checked.doubts() {
            return first;
        }
        let more = effort.again();
        let found = referee.rows(rows, &more, work);
        if found.len() < rows.len() { first } else { Self::judged(factors, &found, wanted, &more) }
    }

    /// The factors beside the rows that rays of this effort found.
    fn judged(
        factors: &ViewFactors,
        found: &[ViewFactorRow],
        wanted: &dyn Fn(usize, usize) -> bool,
        effort: &Effort,
    ) -> Self {
        let is_open = |row: &&ViewFactorRow| row.rays == effort.walks();
        let all: Vec<JudgedFactor> =
            found.iter().filter(is_open).flat_map(|row| judged_row(factors, wanted, row)).collect();
        let judged: Vec<Judged> = all.iter().map(|own| own.judged.clone()).collect();
        let own: Vec<f64> = all.iter().map(|own| factors.errors[own.from]).collect();
        let verdict = Verdict::of(&judged, Verdict::WORST);
        let checked = Checked::of(&judged, &own, &verdict, "view factors");
        Self { factors: all, rays: effort.walks(), verdict, checked }
    }
}

/// The factors of a row that count; its rays are those of the first.
fn judged_row(
    factors: &ViewFactors,
    wanted: &dyn Fn(usize, usize) -> bool,
    row: &ViewFactorRow,
) -> Vec<JudgedFactor> {
    let printed = factors.row(row.surface);
    let is_found = |to: usize| {
        let Mean { value, error } = row.to(to);
        value - FOR_CERTAIN * error >= LEAST
    };
    let counts = |to: &usize| wanted(row.surface, *to) && (printed[*to] >= LEAST || is_found(*to));
    let judged = |(number, to): (usize, usize)| JudgedFactor {
        from: row.surface,
        to: factors.names[to].clone(),
        judged: Judged::of_number(
            &factors.names[row.surface],
            printed[to],
            row.to(to),
            if number == 0 { row.rays } else { 0 },
        ),
    };
    (0..printed.len()).filter(counts).enumerate().map(judged).collect()
}
