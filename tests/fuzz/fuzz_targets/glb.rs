#![no_main]

use libfuzzer_sys::fuzz_target;
use radiosity_test_support::readers::{Reader, with};

fuzz_target!(|bytes: &[u8]| with(Reader::Scene("scene.glb"), bytes));
