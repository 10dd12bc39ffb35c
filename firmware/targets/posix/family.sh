# SPDX-License-Identifier: MIT
# A program on the build machine, or on another Linux by qemu-user. A target sets compiler, which
# may have options, and link_options.
link_options=''

build() {
    objects=
    for source in $firmware $records; do
        object=$folder/$(basename "$source" .c)_.o
        $compiler -O2 $flags -c -o "$object" "$source"
        objects="$objects $object"
    done
    $compiler -O2 -std=c99 -Wall -Wextra -Werror -I$targets/common $link_options \
        -o "$folder/image.elf" tests/targets/posix_main.c $objects -lm
}

run() {
    $limit ./image.elf
}
