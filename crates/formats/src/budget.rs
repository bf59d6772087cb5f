//! The budget of a reader: how much text it follows before it gives up.

use radiosity_photometry::error::Refusal;

/// Most characters and items that are followed, repetitions by arrays and includes counted: a scene of 10⁷
/// lines is within, and a few lines that repeat one another without end are given up in
/// seconds.
const MOST: u64 = 1_000_000_000;

/// Price of an item beside its characters (characters), so that many empty items are not free.
const ITEM: u64 = 32;
/// Price of an opening of an included file or of an instance of an array (characters): each takes about as
/// long as some lines. An arbitrary choice: with a smaller value arrays of little take longer before they are
/// given up.
const INCLUDE: u64 = 2000;

/// Characters that a reader may still follow, the prices of items and includes counted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget(u64);

impl Default for Budget {
    fn default() -> Self {
        Budget(MOST)
    }
}

impl Budget {
    /// Takes the price of an item of so many characters.
    ///
    /// # Errors
    /// A budget that is spent.
    pub(crate) fn spend(&mut self, characters: usize) -> Result<(), Refusal> {
        self.take(characters as u64 + ITEM)
    }

    /// Takes the price of opening an included file, or of an instance of an array.
    ///
    /// # Errors
    /// A budget that is spent.
    pub(crate) fn spend_on_include(&mut self) -> Result<(), Refusal> {
        self.take(INCLUDE)
    }

    fn take(&mut self, price: u64) -> Result<(), Refusal> {
        self.0 = self.0.checked_sub(price).ok_or_else(|| {
            Refusal::new(
                format!("more than {MOST} characters are followed, arrays and includes counted"),
                "make arrays smaller or split the scene",
            )
        })?;
        Ok(())
    }
}
