//! The spread of many ratios.

/// Prints the least, the median and the greatest of the finite ones as a table with one row.
#[expect(clippy::print_stdout, reason = "a table for people")]
pub fn print_spread(name: &str, ratios: impl IntoIterator<Item = f64>) {
    let mut ratios: Vec<f64> = ratios.into_iter().filter(|ratio| ratio.is_finite()).collect();
    ratios.sort_by(f64::total_cmp);
    let [Some(least), Some(greatest)] = [ratios.first(), ratios.last()] else { return };
    println!("\n| {name} | runs | least | median | greatest |");
    println!("| --- | --- | --- | --- | --- |");
    println!("| all | {} | {least:.2} | {:.2} | {greatest:.2} |", ratios.len(), ratios[ratios.len() / 2]);
}
