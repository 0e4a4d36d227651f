fn main() {
    let path = std::env::args().nth(1).unwrap();
    let loaded = gyradius_core::recording::load_session(&path).unwrap();
    match gyradius_core::critique::criticise(&loaded, &|_, _| true) {
        Ok(c) => println!("{}", serde_json::to_string_pretty(&c.critique).unwrap()),
        Err(e) => println!("ERROR {e}"),
    }
}
