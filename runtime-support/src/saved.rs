//! The memory of a chart as bytes, for flash, EEPROM, backup RAM or a file.
//!
//! Values stand one after the other, little endian, with nothing in between. They
//! are taken back in the order in which they were put. A checksum behind them, the
//! seal, tells bytes that have changed from those that were saved.

/// A value that can be saved in a fixed number of bytes.
pub trait Saved: Sized {
    /// How many bytes it takes.
    const LEN: usize;

    /// Writes the value to the first `LEN` bytes. If there are fewer, nothing is
    /// written.
    fn write(self, into: &mut [u8]);

    /// Reads a value from the first `LEN` bytes. None if there are fewer, or if
    /// they are no value of this type.
    fn read(from: &[u8]) -> Option<Self>;
}

/// How many bytes the seal takes.
pub const SEAL_LEN: usize = u32::LEN;

/// The CRC-32 of IEEE 802.3, as zip and Ethernet have it. It finds each change of
/// one, two or three bits in up to 11 KiB, each change of one or two in any buffer
/// up to 512 MiB, and of other changes all but one in four thousand million.
pub fn crc32(bytes: &[u8]) -> u32 {
    // Bit by bit: a table would be larger than most charts.
    let mut crc = u32::MAX;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..u8::BITS {
            let feedback = if crc & 1 == 1 { 0xEDB8_8320 } else { 0 };
            crc = (crc >> 1) ^ feedback;
        }
    }
    !crc
}

/// Writes the seal of all bytes before it to the last [`SEAL_LEN`] bytes. A buffer
/// that is shorter is left as it is.
pub fn seal(buffer: &mut [u8]) {
    if let Some(length) = buffer.len().checked_sub(SEAL_LEN) {
        let (bytes, seal) = buffer.split_at_mut(length);
        crc32(bytes).write(seal);
    }
}

/// Saves values in a buffer, one after the other.
#[derive(Debug)]
pub struct Saver<'b> {
    rest: &'b mut [u8],
}

impl<'b> Saver<'b> {
    /// Begins at the start of `buffer`.
    #[inline]
    pub fn new(buffer: &'b mut [u8]) -> Self {
        Self { rest: buffer }
    }

    /// Saves one value. A value that does not fit is left out, and so are all
    /// that follow it: the buffer never holds a later value in an earlier's place.
    // It is called for each variable: inlined, it would be most of the code.
    #[inline(never)]
    pub fn put<V: Saved>(&mut self, value: V) {
        let rest = core::mem::take(&mut self.rest);
        if let Some((head, tail)) = rest.split_at_mut_checked(V::LEN) {
            value.write(head);
            self.rest = tail;
        }
    }
}

/// Takes values back from a buffer, one after the other.
#[derive(Clone, Debug)]
pub struct Restorer<'b> {
    rest: &'b [u8],
}

impl<'b> Restorer<'b> {
    /// Begins at the start of `buffer`.
    #[inline]
    pub const fn new(buffer: &'b [u8]) -> Self {
        Self { rest: buffer }
    }

    /// Begins at the start of a buffer that was sealed, and ends before the seal.
    /// None if the seal is not that of the bytes before it.
    pub fn sealed(buffer: &'b [u8]) -> Option<Self> {
        let length = buffer.len().checked_sub(SEAL_LEN)?;
        let (bytes, seal) = buffer.split_at_checked(length)?;
        (u32::read(seal) == Some(crc32(bytes))).then_some(Self::new(bytes))
    }

    /// Takes the next value. None, and nothing is taken, if there are not enough
    /// bytes left or if they are no value of this type, as a bool that is 2.
    // It is called for each variable: inlined, it would be most of the code.
    #[inline(never)]
    pub fn take<V: Saved>(&mut self) -> Option<V> {
        let (head, tail) = self.rest.split_at_checked(V::LEN)?;
        let value = V::read(head)?;
        self.rest = tail;
        Some(value)
    }

    /// Whether all bytes have been taken.
    #[inline]
    pub const fn is_done(&self) -> bool {
        self.rest.is_empty()
    }
}

impl Saved for bool {
    const LEN: usize = 1;

    fn write(self, into: &mut [u8]) {
        u8::from(self).write(into);
    }

    fn read(from: &[u8]) -> Option<Self> {
        match from.first() {
            Some(0) => Some(false),
            Some(1) => Some(true),
            _ => None,
        }
    }
}

/// Numbers: each pattern of bits is a value.
macro_rules! saved_numbers {
    ($($number:ty)*) => {$(
        impl Saved for $number {
            const LEN: usize = size_of::<Self>();

            fn write(self, into: &mut [u8]) {
                if let Some(bytes) = into.first_chunk_mut() {
                    *bytes = self.to_le_bytes();
                }
            }

            fn read(from: &[u8]) -> Option<Self> {
                let bytes = from.first_chunk()?;
                Some(Self::from_le_bytes(*bytes))
            }
        }
    )*};
}

saved_numbers!(u8 u16 i16 u32 i32 u64 i64 f32 f64);
