//! KTX2 and DDS, read back by readers that others wrote.

use ddsfile::{Dds, DxgiFormat};
use tilepack::atlas::formats::{dds::write_dds, ktx2::write_ktx2};
use tilepack::atlas::{Channels, Depth, Format, Image, Light};

fn format(channels: Channels, depth: Depth, light: Light) -> Format {
    Format { channels, depth, light }
}

/// A picture of many different samples.
fn picture(width: usize, height: usize, format: Format) -> Image {
    let bytes = width * height * format.bytes();
    let data = (0..bytes).map(|i| (i * 37 + i / 7 * 11 + width) as u8).collect();
    Image::from_data(width, height, format, data).unwrap()
}

fn chain(format: Format) -> Vec<Image> {
    [(13, 6), (6, 3), (3, 1), (1, 1)].map(|(w, h)| picture(w, h, format)).to_vec()
}

/// What graphics cards should find, sample by sample: the definition.
fn expected(image: &Image) -> Vec<u8> {
    let format = image.format();
    let mut bytes = Vec::new();
    for y in 0..image.height() {
        for x in 0..image.width() {
            for channel in 0..4 {
                let sample = match (format.channels, channel) {
                    (Channels::Gray | Channels::Rgb, 3) => format.max(),
                    (Channels::GrayAlpha, 3) => image.sample(x, y, 1),
                    (Channels::Gray | Channels::GrayAlpha, _) => image.sample(x, y, 0),
                    _ => image.sample(x, y, channel),
                };
                match format.depth {
                    Depth::Eight => bytes.push(sample as u8),
                    Depth::Sixteen => bytes.extend(sample.to_le_bytes()),
                }
            }
        }
    }
    bytes
}

#[test]
fn others_read_what_was_written() {
    use Channels::{Gray, GrayAlpha, Rgb, Rgba};
    use Depth::{Eight, Sixteen};
    let cases = [
        (format(Rgba, Eight, Light::Srgb), 43, DxgiFormat::R8G8B8A8_UNorm_sRGB),
        (format(Rgb, Eight, Light::Linear), 37, DxgiFormat::R8G8B8A8_UNorm),
        (format(Gray, Eight, Light::Srgb), 43, DxgiFormat::R8G8B8A8_UNorm_sRGB),
        (format(GrayAlpha, Eight, Light::Linear), 37, DxgiFormat::R8G8B8A8_UNorm),
        (format(Rgba, Sixteen, Light::Linear), 91, DxgiFormat::R16G16B16A16_UNorm),
        (format(Gray, Sixteen, Light::Linear), 91, DxgiFormat::R16G16B16A16_UNorm),
    ];
    for (format, vk, dxgi) in cases {
        let levels = chain(format);
        for count in [1, 4] {
            let levels = &levels[..count];
            let texels: Vec<Vec<u8>> = levels.iter().map(expected).collect();

            let mut bytes = Vec::new();
            write_ktx2(&mut bytes, levels).unwrap();
            let reader = ktx2::Reader::new(&bytes).unwrap();
            let header = reader.header();
            assert_eq!(header.format.unwrap().value(), vk);
            assert_eq!((header.pixel_width, header.pixel_height), (13, 6));
            assert_eq!((header.level_count as usize, header.face_count), (count, 1));
            let found: Vec<Vec<u8>> = reader.levels().map(|level| level.data.to_vec()).collect();
            assert_eq!(found, texels);
            let keys: Vec<(&str, &[u8])> = reader.key_value_data().collect();
            assert_eq!(keys[0], ("KTXorientation", &b"rd\0"[..]));
            assert!(keys[1].0 == "KTXwriter" && keys[1].1.starts_with(b"tilepack "));
            let block = reader.dfd_blocks().next().unwrap();
            let basic = ktx2::DfdBlockBasic::parse(block.data).unwrap();
            let transfer = if vk == 43 {
                ktx2::TransferFunction::SRGB
            } else {
                ktx2::TransferFunction::Linear
            };
            assert_eq!(basic.header.transfer_function, Some(transfer));
            assert_eq!(basic.header.color_model, Some(ktx2::ColorModel::RGBSDA));
            let samples: Vec<_> = basic.sample_information().collect();
            let bits = if vk == 91 { 16 } else { 8 };
            for (number, sample) in samples.iter().enumerate() {
                assert_eq!(u32::from(sample.bit_offset), number as u32 * bits);
                assert_eq!(u32::from(sample.bit_length.get()), bits);
                assert_eq!(sample.channel_type, [0, 1, 2, 15][number]);
                assert_eq!(sample.upper, (1 << bits) - 1);
            }

            let mut bytes = Vec::new();
            write_dds(&mut bytes, levels).unwrap();
            let read = Dds::read(&bytes[..]).unwrap();
            assert_eq!(read.get_dxgi_format(), Some(dxgi));
            assert_eq!((read.get_width(), read.get_height()), (13, 6));
            assert_eq!(read.get_num_mipmap_levels() as usize, count);
            assert_eq!(read.data, texels.concat());
        }
    }
}

/// There is no sRGB of 16 bits, so light is written.
#[test]
fn sixteen_bits_become_light() {
    let srgb = format(Channels::Rgba, Depth::Sixteen, Light::Srgb);
    let mut image = Image::new(1, 1, srgb);
    // 0.5 encoded is 0.21404 of the light (IEC 61966-2-1).
    for (channel, sample) in [0, 32768, 65535, 32768].into_iter().enumerate() {
        image.set_sample(0, 0, channel, sample);
    }
    let mut bytes = Vec::new();
    write_dds(&mut bytes, &[image]).unwrap();
    let samples: Vec<u16> =
        bytes[148..].chunks(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect();
    assert_eq!(samples, [0, 14028, 65535, 32768]);
}

#[test]
fn what_is_no_mip_chain_is_refused() {
    let one = |w, h| picture(w, h, Format::RGBA8);
    let other = format(Channels::Rgb, Depth::Eight, Light::Srgb);
    let cases = [
        (vec![], "no picture"),
        (vec![one(8, 8), one(4, 5)], "mip level 1 has 4x5 texels, expected 4x4"),
        (vec![one(8, 8), picture(4, 4, other)], "mip level 1 has another format"),
        (vec![one(1, 1), one(1, 1)], "2 mip levels, but level 0 is one texel"),
    ];
    for (levels, expected) in cases {
        let (ktx2, dds) =
            (write_ktx2(&mut Vec::new(), &levels), write_dds(&mut Vec::new(), &levels));
        for error in [ktx2, dds] {
            let error = error.unwrap_err().to_string();
            assert!(error.starts_with(expected), "{error}");
        }
    }
}
