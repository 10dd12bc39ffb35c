#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs what firmware/targets/build.sh has made: run_target.sh TARGET FOLDER
#
# Leaves in FOLDER the port writes, as ports.bin (records) or ports.trace (a trace), and, where COUNT
# names the plugin, instructions.txt. TARGET_TIMEOUT seconds (600) are allowed.
# Exit status: 0 the image has come to its own end, 1 not.
set -eu

target=$1 folder=$2
limit="timeout -k 5 ${TARGET_TIMEOUT:-600}"
SUPERFRAME=$(realpath "${SUPERFRAME:-build/superframe}")
scripts=$(realpath "$(dirname "$0")")
plugin=
[ -z "${COUNT:-}" ] || plugin="-plugin $(realpath "$COUNT")"
cd "$folder"
rm -f ports.bin ports.trace instructions.txt

quiet='-nographic -monitor none -serial none -semihosting-config enable=on,target=native'
# shellcheck disable=SC2086 # lists of words
case $target in
cortex-m0) $limit qemu-system-arm -M microbit $quiet $plugin -kernel image.elf ;;
cortex-m3) $limit qemu-system-arm -M mps2-an385 $quiet $plugin -kernel image.elf ;;
cortex-m4f) $limit qemu-system-arm -M mps2-an386 $quiet $plugin -kernel image.elf ;;
rv32im) $limit qemu-system-riscv32 -M virt -cpu rv32,c=off,a=off,f=off,d=off -bios none $quiet \
    $plugin -kernel image.elf ;;
powerpc) $limit qemu-ppc ./image.elf ;;
386-flat | 386-real)
    $limit "$SUPERFRAME" boot disk.hdm --quiet --trace ports.trace --stats boot.json
    sed -n 's/.*"instructions": \([0-9]*\).*/\1/p' boot.json > instructions.txt
    ;;
qemu-486 | qemu-486-real) sh "$scripts/run_qemu_486.sh" ;;
wasm) $limit node "$scripts/run_wasm.mjs" image.wasm ports.bin ;;
*) $limit ./image.elf ;;
esac
