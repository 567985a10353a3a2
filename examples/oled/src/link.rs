//! Build script: like that of the other emulated boards, but with this board's memory, 256 KiB of flash and 64 KiB of
//! RAM.

#[path = "../../common/link.rs"]
mod link;

fn main() {
    link::main();
    if std::env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        println!("cargo::rustc-link-arg-bins=--defsym=_flash_length=0x40000");
        println!("cargo::rustc-link-arg-bins=--defsym=_ram_length=0x10000");
    }
}
