//! Checksums, by which damage of files is found.

use std::io;

use flate2::Crc;

/// The CRC-32 of what is written to it.
#[derive(Debug, Default)]
pub struct Checksum(Crc);

impl Checksum {
    /// The sum of all that was written.
    pub fn sum(&self) -> u32 {
        self.0.sum()
    }

    /// The sum of these bytes.
    pub fn of(bytes: &[u8]) -> u32 {
        let mut checksum = Self::default();
        checksum.0.update(bytes);
        checksum.sum()
    }
}

impl io::Write for Checksum {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.update(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use super::Checksum;

    #[test]
    fn the_sum_is_that_of_the_standard() {
        // The check value of CRC-32/ISO-HDLC, in parts and as a whole.
        let mut parts = Checksum::default();
        parts.write_all(b"1234").and_then(|()| parts.write_all(b"56789")).expect("it takes all");
        assert_eq!([parts.sum(), Checksum::of(b"123456789")], [0xCBF4_3926; 2]);
    }
}
