#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs what firmware/targets/build.sh has made: run_target.sh TARGET FOLDER
#
# Leaves in FOLDER the port writes, as ports.bin (records) or ports.trace (a trace), and, where COUNT
# names the plugin, instructions.txt. TARGET_TIMEOUT seconds (600) are allowed.
# Exit status: 0 the image has come to its own end, 1 not.
#
# shellcheck disable=SC2034 # values for the target
set -eu

. firmware/targets/targets.sh
target_read "$1" || exit 1
targets=$(realpath "$targets")
limit="timeout -k 5 ${TARGET_TIMEOUT:-600}"
SUPERFRAME=$(realpath "${SUPERFRAME:-build/superframe}")
# For QEMU: no screen, and the image calls the host; the plugin that counts instructions.
semihosted='-nographic -monitor none -serial none -semihosting-config enable=on,target=native'
plugin=
[ -z "${COUNT:-}" ] || plugin="-plugin $(realpath "$COUNT")"
cd "$2"
rm -f ports.bin ports.trace instructions.txt
run
