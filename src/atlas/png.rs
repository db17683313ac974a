//! PNG: written row by row as they come, compressed on all threads; and read.
//!
//! The rows are cut into pieces of some hundred kilobytes, each compressed on its own and ended
//! at a byte (a deflate stream may be cut there: RFC 1951, 3.2.4), so the bytes are the same for
//! any number of threads. A row is stored as it is, or as the difference to its left or upper
//! neighbor (in small pictures also to the nearest of three), whichever has the smallest sum (PNG
//! specification, 12.7).

use super::{Channels, Depth, Format, Image, Light};
use flate2::{Compress, Compression, Crc, FlushCompress, Status};
use rayon::prelude::*;
use std::io::{self, BufRead, Seek, Write};

/// Bytes of samples that are compressed together.
const PIECE: usize = 512 << 10;

/// Bytes of samples of a picture that is worth the effort of compressing well.
const SMALL: usize = 32 << 20;

/// Bytes of a PNG's compressed data in one chunk of the file at most.
const CHUNK: usize = 1 << 30;

/// A PNG that is being written.
pub struct PngWriter<W: Write> {
    out: W,
    row: usize,
    texel: usize,
    rows_left: usize,
    /// Rows that wait to be compressed, and before them the last one that does not.
    pending: Vec<u8>,
    /// Adler-32 of what went before.
    adler: u32,
    /// Whether to compress well, or fast.
    well: bool,
}

impl<W: Write> PngWriter<W> {
    /// Begins a picture. `text` are keywords (Latin-1, below 80 characters) and what they say.
    ///
    /// # Errors
    /// What `out` reports.
    pub fn new(
        mut out: W,
        width: usize,
        height: usize,
        format: Format,
        text: &[(&str, &str)],
    ) -> io::Result<Self> {
        out.write_all(b"\x89PNG\r\n\x1a\n")?;
        let mut header = Vec::with_capacity(13);
        for size in [width, height] {
            let size = u32::try_from(size).unwrap_or(u32::MAX);
            header.extend(size.to_be_bytes());
        }
        let depth = 8 * format.sample_bytes() as u8;
        let color = match format.channels {
            Channels::Gray => 0,
            Channels::GrayAlpha => 4,
            Channels::Rgb => 2,
            Channels::Rgba => 6,
        };
        header.extend([depth, color, 0, 0, 0]);
        chunk(&mut out, b"IHDR", &header)?;
        match format.light {
            Light::Srgb => chunk(&mut out, b"sRGB", &[0])?,
            Light::Linear => chunk(&mut out, b"gAMA", &100_000u32.to_be_bytes())?,
        }
        for (keyword, text) in text {
            let data = [keyword.as_bytes(), b"\0", text.as_bytes()].concat();
            chunk(&mut out, b"tEXt", &data)?;
        }
        // The header of a zlib stream: deflate, a window of 32 kB, fast.
        chunk(&mut out, b"IDAT", &[0x78, 0x01])?;
        let row = width * format.bytes();
        let (pending, texel) = (vec![0; row], format.bytes());
        let well = row.saturating_mul(height) <= SMALL;
        Ok(Self { out, row, texel, rows_left: height, pending, adler: 1, well })
    }

    /// Takes the next rows; their number is that of the bytes by those of a row.
    ///
    /// # Errors
    /// What the output reports; more rows than there are.
    pub fn rows(&mut self, rows: &[u8]) -> io::Result<()> {
        let count = rows.len() / self.row;
        if count * self.row != rows.len() || count > self.rows_left {
            return Err(io::Error::other("rows that the picture does not have"));
        }
        self.rows_left -= count;
        self.pending.extend_from_slice(rows);
        // Enough for all threads. Pieces are cut at the same rows whenever they are compressed.
        let piece_rows = self.piece_rows();
        let full = (self.pending.len() / self.row - 1) / piece_rows;
        if full >= 16 {
            self.compress(full * piece_rows, false)?;
        }
        Ok(())
    }

    /// Ends the picture and gives the output back.
    ///
    /// # Errors
    /// What the output reports; missing rows.
    pub fn finish(mut self) -> io::Result<W> {
        if self.rows_left > 0 {
            return Err(io::Error::other("a picture with missing rows"));
        }
        let rows = self.pending.len() / self.row - 1;
        self.compress(rows, true)?;
        chunk(&mut self.out, b"IDAT", &self.adler.to_be_bytes())?;
        chunk(&mut self.out, b"IEND", &[])?;
        Ok(self.out)
    }

    fn piece_rows(&self) -> usize {
        (PIECE / self.row).max(1)
    }

    /// Compresses the first `rows` rows that wait.
    fn compress(&mut self, rows: usize, last: bool) -> io::Result<()> {
        let (row, texel, piece_rows) = (self.row, self.texel, self.piece_rows());
        let starts: Vec<usize> = (0..rows.max(1)).step_by(piece_rows).collect();
        let (pending, well) = (&self.pending, self.well);
        let pieces: Vec<io::Result<Piece>> = starts
            .par_iter()
            .map(|&start| {
                let end = (start + piece_rows).min(rows);
                // One row more: the one above the first.
                let lines = &pending[start * row..(end + 1) * row];
                Piece::new(lines, row, texel, well, last && end == rows)
            })
            .collect();
        for piece in pieces {
            let piece = piece?;
            for part in piece.compressed.chunks(CHUNK) {
                chunk(&mut self.out, b"IDAT", part)?;
            }
            self.adler = adler_joined(self.adler, piece.adler, piece.length);
        }
        self.pending.drain(..rows * row);
        Ok(())
    }
}

/// Some rows, compressed.
struct Piece {
    compressed: Vec<u8>,
    adler: u32,
    /// Bytes before compression.
    length: u64,
}

impl Piece {
    /// Compresses all rows but the first, which is the one above them.
    fn new(lines: &[u8], row: usize, texel: usize, well: bool, last: bool) -> io::Result<Self> {
        let mut filtered = Vec::with_capacity(lines.len() / row.max(1) * (row + 1));
        let mut above = &lines[..row];
        for line in lines[row..].chunks_exact(row) {
            push_filtered(&mut filtered, line, above, texel, well);
            above = line;
        }
        let level = if well { Compression::new(7) } else { Compression::fast() };
        let mut compress = Compress::new(level, false);
        let mut compressed = Vec::with_capacity(filtered.len() / 2 + 64);
        let flush = if last { FlushCompress::Finish } else { FlushCompress::Full };
        loop {
            let done = compress.total_in() as usize;
            compressed.reserve(filtered.len() / 4 + 1024);
            let status = compress.compress_vec(&filtered[done..], &mut compressed, flush)?;
            let room = compressed.capacity() > compressed.len();
            let all = compress.total_in() as usize == filtered.len();
            if status == Status::StreamEnd || (!last && all && room) {
                break;
            }
        }
        Ok(Self { compressed, adler: adler(&filtered), length: filtered.len() as u64 })
    }
}

/// The row after its best filter, with the number of the filter before it.
fn push_filtered(to: &mut Vec<u8>, line: &[u8], above: &[u8], texel: usize, well: bool) {
    let size = |byte: u8| u64::from(byte.min(byte.wrapping_neg()));
    let plain: u64 = line.iter().map(|&byte| size(byte)).sum();
    let texel_before = line.iter().zip(&line[texel.min(line.len())..]);
    let left: u64 = texel_before.map(|(&before, &byte)| size(byte.wrapping_sub(before))).sum();
    let up: u64 = line.iter().zip(above).map(|(&byte, &up)| size(byte.wrapping_sub(up))).sum();
    let paeth = || (0..line.len()).map(|at| size(paeth_filtered(line, above, texel, at))).sum();
    let paeth: u64 = if well { paeth() } else { u64::MAX };
    if paeth < plain.min(left).min(up) {
        to.push(4);
        to.extend((0..line.len()).map(|at| paeth_filtered(line, above, texel, at)));
    } else if plain <= left && plain <= up {
        to.push(0);
        to.extend_from_slice(line);
    } else if left <= up {
        to.push(1);
        to.extend_from_slice(&line[..texel]);
        to.extend(line.iter().zip(&line[texel..]).map(|(&left, &byte)| byte.wrapping_sub(left)));
    } else {
        to.push(2);
        to.extend(line.iter().zip(above).map(|(&byte, &up)| byte.wrapping_sub(up)));
    }
}

/// A sample less the one of its left, upper and upper left neighbors that is nearest to left plus
/// upper less upper left (PNG specification, 9.4).
fn paeth_filtered(line: &[u8], above: &[u8], texel: usize, at: usize) -> u8 {
    let before = |row: &[u8]| if at >= texel { row[at - texel] } else { 0 };
    let (left, up, corner) = (before(line), above[at], before(above));
    let guess = i16::from(left) + i16::from(up) - i16::from(corner);
    let away = |sample: u8| (guess - i16::from(sample)).abs();
    let nearest = if away(left) <= away(up) && away(left) <= away(corner) {
        left
    } else if away(up) <= away(corner) {
        up
    } else {
        corner
    };
    line[at].wrapping_sub(nearest)
}

const ADLER: u64 = 65521;

/// The checksum of zlib (RFC 1950, 8.2).
fn adler(bytes: &[u8]) -> u32 {
    let (mut a, mut b) = (1u64, 0u64);
    // So many bytes do not overflow, and divide seldom.
    for part in bytes.chunks(4096) {
        let (mut sum, mut weighted) = (0u32, 0u64);
        for &byte in part {
            sum += u32::from(byte);
            weighted += u64::from(sum);
        }
        b = (b + part.len() as u64 * a + weighted) % ADLER;
        a = (a + u64::from(sum)) % ADLER;
    }
    (b << 16 | a) as u32
}

/// The checksum of two pieces, from theirs and the length of the second.
fn adler_joined(first: u32, second: u32, length: u64) -> u32 {
    let [a, b] = [first & 0xffff, first >> 16].map(u64::from);
    let [c, d] = [second & 0xffff, second >> 16].map(u64::from);
    // The second began with 1 where it goes on with a.
    let shift = (a + ADLER - 1) % ADLER;
    let sum = (c + shift) % ADLER;
    let weighted = (b + d + length % ADLER * shift) % ADLER;
    (weighted << 16 | sum) as u32
}

fn chunk(out: &mut impl Write, name: &[u8; 4], data: &[u8]) -> io::Result<()> {
    let length = u32::try_from(data.len()).map_err(io::Error::other)?;
    let mut crc = Crc::new();
    crc.update(name);
    crc.update(data);
    out.write_all(&length.to_be_bytes())?;
    out.write_all(name)?;
    out.write_all(data)?;
    out.write_all(&crc.sum().to_be_bytes())
}

/// Writes a picture as PNG.
///
/// # Errors
/// What `out` reports.
pub fn write_png(out: impl Write, image: &Image, text: &[(&str, &str)]) -> io::Result<()> {
    let mut writer = PngWriter::new(out, image.width(), image.height(), image.format(), text)?;
    writer.rows(image.data())?;
    writer.finish()?.flush()
}

/// Reads a PNG of any kind: palettes become red, green and blue, fewer than 8 bits become 8. It
/// is taken for encoded for the eye unless it says that its gamma is 1.
///
/// # Errors
/// What is wrong with it, in words; pictures above `limit` bytes.
pub fn read_png(input: impl BufRead + Seek, limit: u64) -> Result<Image, String> {
    let mut decoder = png::Decoder::new(input);
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    let (color, depth) = reader.output_color_type();
    let channels = match color {
        png::ColorType::Grayscale => Channels::Gray,
        png::ColorType::GrayscaleAlpha => Channels::GrayAlpha,
        png::ColorType::Rgb | png::ColorType::Indexed => Channels::Rgb,
        png::ColorType::Rgba => Channels::Rgba,
    };
    let depth = if depth == png::BitDepth::Sixteen { Depth::Sixteen } else { Depth::Eight };
    let info = reader.info();
    let gamma = info.gama_chunk.map(|gamma| gamma.into_scaled());
    let linear = info.srgb.is_none() && gamma == Some(100_000);
    let light = if linear { Light::Linear } else { Light::Srgb };
    let (width, height) = (info.width as usize, info.height as usize);
    let format = Format { channels, depth, light };
    let bytes = width as u64 * height as u64 * format.bytes() as u64;
    if bytes > limit {
        let limit = limit >> 20;
        return Err(format!(
            "{width} x {height} texels take {} MiB, the limit is {limit}",
            bytes >> 20
        ));
    }
    let mut data = vec![0; bytes as usize];
    reader.next_frame(&mut data).map_err(|error| error.to_string())?;
    Image::from_data(width, height, format, data).ok_or_else(|| "its size is wrong".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksums_join() {
        let bytes: Vec<u8> = (0..70_000u32).map(|at| (at * 31 % 251) as u8).collect();
        let whole = adler(&bytes);
        for cut in [0, 1, 5000, 69_999] {
            let (first, second) = bytes.split_at(cut);
            assert_eq!(adler_joined(adler(first), adler(second), second.len() as u64), whole);
        }
        assert_eq!(adler(b"Wikipedia"), 0x11e6_0398);
    }

    #[test]
    fn pictures_come_back() {
        for channels in [Channels::Gray, Channels::GrayAlpha, Channels::Rgb, Channels::Rgba] {
            for depth in [Depth::Eight, Depth::Sixteen] {
                for light in [Light::Srgb, Light::Linear] {
                    let format = Format { channels, depth, light };
                    for (width, height) in [(1, 1), (3, 700), (1500, 401)] {
                        let bytes = width * height * format.bytes();
                        let data = (0..bytes as u64)
                            .map(|at| if at % 5000 < 2500 { 7 } else { ((at * at) >> 7) as u8 });
                        let image =
                            Image::from_data(width, height, format, data.collect()).unwrap();
                        let mut file = Vec::new();
                        write_png(&mut file, &image, &[("Comment", "seed 1")]).unwrap();
                        let back = read_png(io::Cursor::new(&file), 1 << 30).unwrap();
                        assert_eq!(back, image);
                    }
                }
            }
        }
    }
}
