# SPDX-License-Identifier: MIT
# A module for a web page, which holds the board too: superframe.h.
title='WebAssembly (node)'
place=50
packages='tool|clang|clang
tool|wasm-ld|lld
tool|node|nodejs'
screen=yes
sizes='fx/minimal fx/full'

build() {
    clang --target=wasm32 -Oz -Iemulator/board $flags -I$targets/wasm/include -nostdlib \
        -Wl,--no-entry -Wl,--gc-sections -Wl,--strip-all -Wl,-z,stack-size=65536 -fno-builtin \
        -o "$folder/image.wasm" $firmware $targets/wasm/module.c $targets/common/memory.c \
        emulator/board/board.c emulator/board/board_pixel.c emulator/board/board_setup.c \
        emulator/board/board_report.c
}

run() {
    $limit node "$targets/wasm/run.mjs" image.wasm ports.bin
}
