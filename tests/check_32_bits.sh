#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles hal/, emulator/ and host/ for hosts whose long and size_t have 32 bits, where a
# number that fits only 64 is a warning. Nothing is linked: the libraries need not be there.
#
# Exit status: 0 no warning, 1 there are some.
set -u
cd "$(dirname "$0")/.." || exit 1

flags='-m32 -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -D_POSIX_C_SOURCE=200809L
 -D_FILE_OFFSET_BITS=64 -fsyntax-only -Ihal -Ihal/cable -Iemulator/board -Iemulator/picture -Iemulator/trace
 -Iemulator/bus -Iemulator/testing -Ifirmware -Ifirmware/adapter -Ihost
 -isystem /usr/include/libusb-1.0 -isystem /usr/include/hidapi'
# The kernel's headers are one for both; only gcc-multilib, which no cross compiler stands beside, says so.
flags="$flags -idirafter /usr/include/$(gcc -print-multiarch)"
# The arithmetics, the streams and what one kind of CPU alone has are compiled with flags of their own.
# shellcheck disable=SC2086 # a list of words
find hal firmware/adapter emulator host -name '*.c' ! -path 'host/stream/*' ! -path '*/per_arithmetic/*' \
    ! -name instruction_sets_x86_64.c |
    xargs -P 2 -n 12 gcc $flags || exit 1
echo 'check_32_bits: no warning'
