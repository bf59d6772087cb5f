//! Buffers: the binary chunk, data in the text, and files beside it (section 3.6.1).

use std::borrow::Cow;

use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use percent_encoding::percent_decode_str;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::short;

use super::json::Json;
use super::scheme::{Buffer, Root};
use crate::tolerances::MOST_BYTES_OF_BUFFERS;
use radiosity_photometry::files::Files;

/// Base64 with or without padding (RFC 4648, section 4).
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// The bytes of all buffers.
pub(super) fn all<'a>(
    root: &Root<'a>,
    json: &Json<'a>,
    binary: Option<&'a [u8]>,
    files: &dyn Files,
) -> Result<Vec<Cow<'a, [u8]>>, Refusal> {
    let mut buffers: Vec<Cow<'a, [u8]>> = Vec::new();
    let mut size = 0;
    for (index, item) in root.buffers.iter().enumerate() {
        let what = format!("the buffer {index}");
        let buffer: Buffer = json.parse(item.get(), &what)?;
        let uri: Option<Cow<str>> = match buffer.uri {
            Some(uri) => Some(Cow::Owned(json.parse::<String>(uri.get(), &what)?)),
            None => None,
        };
        let bytes = bytes(uri.as_deref(), binary.filter(|_| index == 0), files);
        let checked = bytes.and_then(|bytes| {
            size += bytes.len();
            check(bytes, buffer.byte_length, size)
        });
        buffers.push(checked.map_err(|refusal| refusal.of(&what, json.place(item.get())))?);
    }
    Ok(buffers)
}

/// The bytes if they are as many as stated and not too many in all.
fn check(bytes: Cow<'_, [u8]>, length: usize, size: usize) -> Result<Cow<'_, [u8]>, Refusal> {
    if bytes.len() < length {
        return refuse(
            format!("it has {} bytes, {length} are announced", bytes.len()),
            "copy or export the model again",
        );
    }
    if size > MOST_BYTES_OF_BUFFERS {
        return refuse(
            format!("the buffers have more than {MOST_BYTES_OF_BUFFERS} bytes"),
            "split the model",
        );
    }
    Ok(bytes)
}

/// The bytes that a URI names; without one, those of the binary chunk.
fn bytes<'a>(
    uri: Option<&str>,
    binary: Option<&'a [u8]>,
    files: &dyn Files,
) -> Result<Cow<'a, [u8]>, Refusal> {
    let Some(uri) = uri else {
        return binary.map(Cow::Borrowed).ok_or_else(|| {
            Refusal::new("it has no uri, and no binary chunk holds it", "export the model again")
        });
    };
    if let Some(data) = uri.strip_prefix("data:") {
        let Some((kind, data)) = data.split_once(',').filter(|(kind, _)| kind.ends_with(";base64")) else {
            return refuse("its data is not base64", "write it as 'data:…;base64,…'");
        };
        return BASE64.decode(data).map(Cow::Owned).map_err(|error| {
            Refusal::new(format!("its data ({}): {error}", short(kind)), "export the model again")
        });
    }
    let name = percent_decode_str(uri).decode_utf8_lossy();
    files.bytes(&name).map(Cow::Owned).map_err(|error| {
        let what = format!("the file '{}'", short(&name));
        error.refusal(&what, "put it beside the model, or export a GLB, which holds all")
    })
}
