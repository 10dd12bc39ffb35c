#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the board probe, a PC-98 floppy: build_probe.sh FOLDER
#
# FOLDER is where image.elf and disk.hdm are made; CC the native compiler (gcc).
# Exit status: 0 built, 1 not.
set -eu

folder=$1
CC=${CC:-gcc}
rm -rf "$folder"
mkdir -p "$folder"

. firmware/targets/targets.sh
target_read 386-flat
optimisation=-Os
pc98_disk -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -ffreestanding \
    -ffunction-sections -fdata-sections -fno-tree-loop-distribute-patterns -nostdlib \
    -Wl,--gc-sections -Ihal -Ifirmware "$targets"/pc98/probe/*.c firmware/board_driver.c
