#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the board probe, a PC-98 floppy: build_probe.sh FOLDER
#
# FOLDER is where image.elf and disk.hdm are made; CC the native compiler (gcc).
# Exit status: 0 built, 1 not.
set -eu

folder=$1
CC=${CC:-gcc}
here=firmware/targets
rm -rf "$folder"
mkdir -p "$folder"

. $here/pc98/disk.sh

pc98_disk flat '-m32 -Os' 0x20000 0x2F000 -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow \
    -Werror -ffreestanding -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns \
    -nostdlib -Wl,--gc-sections -Ihal -Ifirmware $here/pc98/probe/*.c firmware/board_driver.c
