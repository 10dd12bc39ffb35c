# SPDX-License-Identifier: MIT
# Reads what the targets say of themselves; sourced in the root of the tree.
#
# A target is a folder of firmware/targets/ with a file target.sh. That file sets what differs from
# the values of target_read(), and may source what several targets share, a family.sh:
#
# title        what docs/targets.md calls the target
# place        the order of the table's rows; those that run longest have the highest, and start first
# packages     compiler and emulator, in lines "kind|thing|package" as in the table of setup.sh
# arithmetics  what it ships: a row of the table each
# fx           the folder of firmware/real/ whose fx suits its registers and products; same bits in all
# square_root  the source of sqrtf() for floating point
# memory       bytes that the stack shares with the sections of image.elf; 0: not limited
# sections     which sections these are
# entry        the function where the stack begins; none: the stack is not known
# calls        lines "caller>called" of calls by pointer, as gcc names functions
# screen       yes: one picture is shown, so a multiple exposure is refused
# sizes        the images of `make size`: arithmetic/features, with /count where instructions are counted
# build()      makes the image in $folder; build.sh sets the variables used there
# run()        runs the image in the current folder; run_target.sh sets the variables used there

targets=firmware/targets

# target_read NAME: returns false if there is no such target.
target_read() {
    title='' place=0 packages='' arithmetics=fx fx=fx square_root=$targets/common/square_root.c
    memory=0 sections='.data .bss' entry='' screen=no sizes=''
    calls='frame_draw>firmware/image.c:image_draw'
    if [ ! -f "$targets/$1/target.sh" ]; then
        echo "no target \"$1\"; there are: $(target_names)" >&2
        return 1
    fi
    # shellcheck source=/dev/null
    . "$targets/$1/target.sh"
}

# target_names: prints all names in a line, in the order of their places.
target_names() {
    for target_file in "$targets"/*/target.sh; do
        target_name=$(basename "$(dirname "$target_file")")
        (target_read "$target_name" && echo "$place $target_name")
    done | sort -n | cut -d ' ' -f 2 | paste -s -d ' ' -
}
