#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what the build lacks: sh setup.sh [GROUP...], the groups of the table below.
#
# CC     the compiler whose headers count (default: cc)
# SETUP  "no" lists what is missing and stops
#
# Exit status: 0 nothing is missing (any more), 2 something is and can't be installed here.
# What is there is found by asking the compiler and the shell, not the package manager: a system
# of any kind that has the libraries passes, at once and without a network.
set -u

CC=${CC:-cc}
SETUP=${SETUP:-yes}

# group | how to look for it: header, tool, file, pc (pkg-config), runtime (clang's) or m32 | what to look for | Debian package
# or group | target | a target of firmware/targets/, whose folder says what it needs, or "every"
table='
build|tool|make|make
build|header|stdio.h|libc6-dev
build|header|png.h|libpng-dev
build|header|xxhash.h|libxxhash-dev
build|header|libdeflate.h|libdeflate-dev
test|header|cmocka.h|libcmocka-dev
test|m32|stdio.h|gcc-multilib
test|tool|clang|clang
test|tool|g++|g++
test|tool|pkg-config|pkg-config
test|runtime|libclang_rt.fuzzer-x86_64.a|libclang-rt-14-dev
pov|tool|povray|povray
paper|tool|gnuplot|gnuplot-nox
usb|tool|pkg-config|pkg-config
usb|pc|libusb-1.0|libusb-1.0-0-dev
usb|pc|hidapi-hidraw|libhidapi-dev
usb|pc|umockdev-1.0|libumockdev-dev
usb|tool|umockdev-run|umockdev
kernel|tool|qemu-system-x86_64|qemu-system-x86
lint|tool|clang-format|clang-format
lint|tool|clang-tidy|clang-tidy
lint|tool|cppcheck|cppcheck
coverage|tool|gcovr|gcovr
count|tool|valgrind|valgrind
prove|tool|frama-c|frama-c-base
prove|tool|gappa|gappa
quick|tool|pkg-config|pkg-config
quick|header|unicorn/unicorn.h|libunicorn-dev
quick|target|386-flat
quick|target|cortex-m3
quick|target|wasm
pc98|target|386-flat
targets|target|every
targets|tool|avr-gcc|gcc-avr
targets|file|/usr/lib/avr/include/stdint.h|avr-libc
'

say() {
    printf 'setup: %s\n' "$*" >&2
}

# preprocesses HEADER...: true if the compiler finds each of them.
has_headers() {
    for wanted_header in "$@"; do
        printf '#include <%s>\n' "$wanted_header"
    done | $CC -E -x c - > /dev/null 2>&1
}

# The 32-bit C library's headers and the compiler's own 32-bit library; only an x86-64 compiler
# makes 386 code from the same package.
has_m32() {
    case $($CC -dumpmachine 2> /dev/null) in
    x86_64*) ;;
    *) return 0 ;;
    esac
    printf '#include <%s>\n' "$1" | $CC -m32 -E -x c - > /dev/null 2>&1 &&
        [ -e "$($CC -m32 -print-libgcc-file-name 2> /dev/null)" ]
}

in_groups() {
    case " $groups " in
    *" $1 "*) return 0 ;;
    *) return 1 ;;
    esac
}

# packages_of TARGET|every: prints rows without their group.
packages_of() (
    . firmware/targets/targets.sh
    [ "$1" = every ] && names=$(target_names) || names=$1
    for name in $names; do
        target_read "$name"
        # shellcheck disable=SC2154 # the target's value
        [ -z "$packages" ] || printf '%s\n' "$packages"
    done
)

# The table's rows of the wanted groups, without blank lines.
wanted_rows() {
    printf '%s\n' "$table" | while IFS='|' read -r group kind thing package; do
        if [ -n "$group" ] && in_groups "$group"; then
            case $kind in
            target) packages_of "$thing" ;;
            *) echo "$kind|$thing|$package" ;;
            esac
        fi
    done
}

# Prints the packages that are missing. All headers in one go first: that is the usual case, and
# it takes one run of the preprocessor.
missing() {
    headers=$(wanted_rows | sed -n 's/^header|\([^|]*\)|.*/\1/p')
    # shellcheck disable=SC2086 # a list of words
    has_headers $headers && headers=
    wanted_rows | while IFS='|' read -r kind thing package; do
        case $kind in
        header) [ -z "$headers" ] || has_headers "$thing" ;;
        pc) pkg-config --exists "$thing" > /dev/null 2>&1 ;;
        tool) command -v "$thing" > /dev/null 2>&1 ;;
        file) [ -e "$thing" ] ;;
        runtime) [ -e "$(clang -print-resource-dir 2> /dev/null)/lib/linux/$thing" ] ;;
        m32) has_m32 "$thing" ;;
        esac || echo "$package"
    done | sort -u | tr '\n' ' ' | sed 's/ $//'
}

groups=${*:-build}
known=$(printf '%s\n' "$table" | sed -n 's/|.*//p' | sort -u | tr '\n' ' ')
for group in $groups; do
    case " $known" in
    *" $group "*) ;;
    *)
        say "no group \"$group\"; there are: $known"
        exit 2
        ;;
    esac
done

# shellcheck disable=SC2086 # CC may hold options
if ! command -v ${CC%% *} > /dev/null 2>&1; then
    say "no C compiler \"$CC\"; install gcc, or name another one by CC=..."
    exit 2
fi

packages=$(missing)
[ -n "$packages" ] || exit 0

say "these packages are missing: $packages"
by_hand="apt-get update && apt-get install --no-install-recommends $packages"
if [ "$SETUP" = no ]; then
    say "nothing was installed (SETUP=no); as root: $by_hand"
    exit 2
fi
if ! command -v apt-get > /dev/null 2>&1; then
    say "there is no apt-get here; install what these Debian packages hold, then try again"
    exit 2
fi
if [ "$(id -u)" -eq 0 ]; then
    as_root=
elif command -v sudo > /dev/null 2>&1; then
    as_root=sudo
else
    say "only root may install them, and there is no sudo; as root: $by_hand"
    exit 2
fi

# Another apt-get may be at work (a fresh machine's own updates): wait for its lock.
apt() {
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=300 "$@" \
        < /dev/null >&2
}

say "installing them"
apt update || say "the package lists could not be renewed; trying with those that are there"
# shellcheck disable=SC2086 # a list of words
if ! apt install --no-install-recommends $packages; then
    say "apt-get could not install them; as root: $by_hand"
    exit 2
fi
packages=$(missing)
if [ -n "$packages" ]; then
    say "installed, but \"$CC\" still does not find what these packages hold: $packages"
    exit 2
fi
