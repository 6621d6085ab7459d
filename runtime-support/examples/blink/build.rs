fn main() {
    grafc::Build::new("blink.gct").runtime(grafc::Runtime::Crate).compile();
}
