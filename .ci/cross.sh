# Helpers for the other scripts: builds for other targets. The other scripts source this file in the project's root. A
# build uses the target's library if rustup has installed it. Otherwise Debian's compiler also builds the library:
# `core`, or the crates that the variable `library` names.
targets=(thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabi thumbv8m.base-none-eabi thumbv8m.main-none-eabi riscv32imc-unknown-none-elf)

has_target() { [ -d "$(rustc --print target-libdir --target "$1")" ]; }

install_tools() { .ci/install emulators "${targets[@]}"; }

# Arguments: the targets in one word, then the arguments of cargo. Several targets build side by side, which keeps both
# cores busy: most of the time goes to crates that are compiled in one piece.
cross() {
  local target flags=() found=1
  for target in $1; do
    flags+=(--target "$target")
    has_target "$target" || found=
  done
  shift
  if [ -n "$found" ]; then
    cargo "$@" "${flags[@]}" --target-dir target/cross
  else
    # Debian's compiler comes without a linker of its own.
    flags+=(--config 'target."cfg(target_os = \"none\")".linker = "ld.lld"')
    RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc /usr/bin/cargo "$@" -Zbuild-std="${library:-core}" "${flags[@]}" --target-dir target/cross
  fi
}

# The compiler that `cross` uses for a target.
compiler() {
  if has_target "$1"; then rustc --version; else /usr/bin/rustc --version; fi
}

# Names that no program may link: float routines (Arm's, those of other compiler runtimes, and Rust's own conversions to
# and from text), and an allocator.
floats='__aeabi_c?[fd]r?(add|sub|mul|div|neg|cmp|2)|__aeabi_u?[il]2[fd]|__aeabi_h2f'
floats+='|[a-z][sd]f[23]?$|__fix(uns)?[sd]f[sd]i|flt2dec|dec2flt'
allocator='__rust_alloc|__rg_alloc|__rdl_alloc'
