# Helpers for the other scripts: builds for other targets. The other scripts source this file in the project's root.
targets=(thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabi thumbv8m.base-none-eabi thumbv8m.main-none-eabi riscv32imc-unknown-none-elf)

# All counts of instructions are from one release of the compiler. It is used if rustup has it with the target. Otherwise
# rustup's default compiler is used if it has the target, and otherwise Debian's, which also builds the library: `core`,
# or the crates that the variable `library` names.
pinned=$(sed -n '1s/^# rustc //p' tests/instructions.csv)
toolchain() { # target
  local release
  for release in "$pinned" "${RUSTUP_TOOLCHAIN-}"; do
    if [ -d "$(RUSTUP_TOOLCHAIN=$release RUSTUP_AUTO_INSTALL=0 rustc --print target-libdir --target "$1" 2>/dev/null)" ]; then
      printf '%s' "${release:-default}"
      return
    fi
  done
  return 1
}
has_target() { toolchain "$1" >/dev/null; }

install_tools() { .ci/install emulators "${targets[@]}"; }

# Arguments: the targets in one word, then the arguments of cargo. Several targets build side by side, which keeps both
# cores busy: most of the time goes to crates that are compiled in one piece.
cross() {
  local target flags=() release='' found=1
  for target in $1; do
    flags+=(--target "$target")
    release=$(toolchain "$target") || found=
  done
  shift
  if [ -n "$found" ]; then
    [ "$release" != default ] || release=${RUSTUP_TOOLCHAIN-}
    RUSTUP_TOOLCHAIN=$release cargo "$@" "${flags[@]}" --target-dir target/cross
  else
    # Debian's compiler comes without a linker of its own.
    flags+=(--config 'target."cfg(target_os = \"none\")".linker = "ld.lld"')
    RUSTC_BOOTSTRAP=1 RUSTC=/usr/bin/rustc /usr/bin/cargo "$@" -Zbuild-std="${library:-core}" "${flags[@]}" --target-dir target/cross
  fi
}

# The release of the compiler that `cross` uses for a target.
compiler() {
  local release
  if release=$(toolchain "$1"); then
    [ "$release" != default ] || release=${RUSTUP_TOOLCHAIN-}
    RUSTUP_TOOLCHAIN=$release rustc --version
  else
    /usr/bin/rustc --version
  fi | cut -d ' ' -f 2
}

# Names that no program may link: float routines (Arm's, those of other compiler runtimes, and Rust's own conversions to
# and from text), and an allocator.
floats='__aeabi_c?[fd]r?(add|sub|mul|div|neg|cmp|2)|__aeabi_u?[il]2[fd]|__aeabi_h2f'
floats+='|[a-z][sd]f[23]?$|__fix(uns)?[sd]f[sd]i|flt2dec|dec2flt'
allocator='__rust_alloc|__rg_alloc|__rdl_alloc'
