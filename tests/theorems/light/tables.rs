//! Texts of photometric files.

/// An IES file of type C with this opening (width, length, height in metres), whose intensities are `candela`
/// at these vertical angles (degrees; `candela` takes radians), alike all around.
pub(crate) fn ies(opening: &str, gammas: &[f64], candela: impl Fn(f64) -> f64) -> String {
    let row = |values: &mut dyn Iterator<Item = f64>| {
        values.map(|value| format!("{value:.9}")).collect::<Vec<_>>().join("\n")
    };
    format!(
        "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] none\nTILT=NONE\n1 -1 1 {} 1 1 2 {opening}\n1 1 10\n{}\n0\n{}\n",
        gammas.len(),
        row(&mut gammas.iter().copied()),
        row(&mut gammas.iter().map(|gamma| candela(gamma.to_radians()))),
    )
}
