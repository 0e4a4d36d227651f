//! UniFFI's generator for Swift, which writes headers and a module map beside the source.

fn main() {
    uniffi::uniffi_bindgen_swift();
}
