#!/bin/sh
# SPDX-License-Identifier: MIT
# The quick part of `make targets`: small pictures on a 386, a Cortex-M3 and as WebAssembly, what
# they say, and what is refused.
#
# Exit status: 0 all hold, 1 one does not.
# shellcheck source=tests/targets/expect.sh
. "$(dirname "$0")/expect.sh"
work=$BUILD/targets/quick
SIZE=40x25
DEPTH=10
mkdir -p "$work"

# crowd FILE: writes a scene whose sets of primitives are lists.
crowd() {
    {
        echo 'version = 1; size = [40, 25]; depth = 4; camera = { eye = [0, -14, 7]; look_at = [0, 0, 0]; };'
        echo 'lights = ({ direction = [1, 2, -3]; });'
        echo 'materials = { clay = { colour = [200, 90, 40]; diffuse = 0.7; };'
        echo '  glass = { ior = 1.5; colour = [20, 30, 40]; diffuse = 0.2; }; };'
        echo 'objects = ({ material = "clay"; solid = { half_space = { normal = [0, 0, 1]; offset = 0; }; }; }'
        for i in 0 1 2 3 4 5 6 7 8 9; do
            for j in 0 1 2 3 4 5 6 7 8 9; do
                material=clay
                [ $(((i + j) % 2)) -eq 0 ] || material=glass
                echo ", { material = \"$material\"; solid = { ball = { centre = [$i - 4.5, $j - 4.5, 0.4]; radius = 0.45; }; }; }"
            done
        done
        echo ');'
    } > "$1"
}

native_hash() {
    "$SUPERFRAME" render "$1" --size $SIZE --depth $DEPTH --quiet -o "$work/native.png" --stats - |
        sed -n 's/.*"trace_hash": "\([0-9a-f]*\)".*/\1/p'
}

# One hash everywhere, on a scene of boxes and on one of balls and rotated boxes, and in full.
hashes() {
    crowd "$work/crowd.scene"
    for run in 'cortex-m3 fig3 minimal' 'cortex-m3 fig4b full' 'wasm fig3 minimal' '386-flat fig3 minimal' \
        "386-flat $work/crowd.scene minimal" "wasm $work/crowd.scene full"; do
        # shellcheck disable=SC2086 # three words
        set -- $run
        folder=$work/$1-$(basename "$2")
        expected=$(native_hash "$2")
        if ! sh firmware/targets/build.sh "$1" fx "$2" $SIZE $DEPTH "$3" "$folder" ||
            ! TARGET_TIMEOUT=100 sh tests/targets/run_target.sh "$1" "$folder"; then
            wrong "$run: not built, or not run to its end"
            continue
        fi
        hash=$(sh tests/targets/trace_hash.sh "$folder")
        echo "$run: $hash"
        [ -n "$hash" ] && [ "$hash" = "$expected" ] ||
            wrong "$run: trace_hash $hash; the native one is $expected"
    done
}

# What the screen of the image says: Esc ends it; a board at another address does not answer.
screens() {
    image=$work/386-flat-fig3/disk.hdm
    expect 0 'screen: Ended by Esc' "$SUPERFRAME" boot "$image" --escape 3 -o "$work/screen.png"
    expect 0 'No SuperFrame board answers' "$SUPERFRAME" boot "$image" --base 02D0 --escape 3 -o "$work/screen.png"
}

# A multiple exposure: all eight where there is no screen, a refusal where there is one.
exposures() {
    scene=$work/exposed.scene
    sed '/^depth/i colour = "exposures";' firmware/scenes/fig3.scene > "$scene"
    grep -q exposures "$scene" || wrong 'no scene of a multiple exposure'
    sh firmware/targets/build.sh gcc fx "$scene" $SIZE $DEPTH full "$work/exposed" &&
        sh tests/targets/run_target.sh gcc "$work/exposed" || wrong 'exposures: not built, or not run'
    hash=$(sh tests/targets/trace_hash.sh "$work/exposed")
    [ "$hash" = "$(native_hash "$scene")" ] || wrong "exposures: trace_hash $hash; the native one is $(native_hash "$scene")"
    for target in 386-flat wasm; do
        expect 1 'shows one picture, and .* is a multiple exposure' \
            sh firmware/targets/build.sh $target fx "$scene" $SIZE $DEPTH minimal "$work/refused"
    done
}

# An image that lacks a feature refuses the scene by the feature's name, when it is built: each feature
# that these scenes require is taken away once, a number is made one less.
lacking_feature() {
    missing=$work/missing
    mkdir -p "$missing"
    : > "$missing/names.txt"
    lacks_each fig6b --error 1 --highlight blinn
    lacks_each fig5 --model wavelength --tail estimate
    lacks_each fig4b --model simple --colour full
    lacks_each fig7-frustum
    lacks_each tests/targets/features.scene
    lacks_each "$work/crowd.scene"
    # Who looks on is no scene's matter.
    sort -u "$missing/names.txt" > "$missing/tried.txt"
    sed 's/ =.*//' "$work/full.txt" | grep -v FEATURE_OBSERVER | diff - "$missing/tried.txt" >&2 ||
        wrong 'no scene above requires these features'
}

# lacks_each SCENE OPTION...
lacks_each() {
    "$SUPERFRAME" compile "$@" --minimal -o "$missing/all.h"
    "$SUPERFRAME" compile "$@" -o "$missing/scene.c"
    compile="gcc -std=c99 -fsyntax-only -Ifirmware/real/fx -I$missing -Ifirmware -Ihal $missing/scene.c"
    cp "$missing/all.h" "$missing/feature_set.h"
    $compile || wrong "$*: its own features do not do"
    for feature in $(sed -n 's/^ *\(FEATURE_[A-Z_]*\) = [1-9].*/\1/p' "$missing/all.h"); do
        awk -v feature="$feature" '$1 == feature { sub($3, $3 - 1 (/,/ ? "," : "")) } { print }' \
            "$missing/all.h" > "$missing/feature_set.h"
        # shellcheck disable=SC2086 # a list of words
        expect 1 "image_lacks_${feature}[^A-Z_]" $compile
        echo "$feature" >> "$missing/names.txt"
    done
}

# Each folder with a target.sh is a target, and another name is refused with the names that there are.
names() {
    names=$(. firmware/targets/targets.sh && target_names)
    for file in firmware/targets/*/target.sh; do
        name=$(basename "$(dirname "$file")")
        case " $names " in
        *" $name "*) ;;
        *) wrong "$file: $name is not among the targets: $names" ;;
        esac
    done
    expect 1 "no target \"z80\"; there are: $names" \
        sh firmware/targets/build.sh z80 fx fig3 $SIZE $DEPTH minimal "$work/refused"
    expect 1 "no target \"z80\"; there are: $names" sh tests/targets/run_target.sh z80 "$work"
}

# A scene whose stack does not fit the machine is refused when it is built, with what would fit.
too_large() {
    expect 1 'fig5 does not fit 386-real: .* choose a smaller --size or --depth, minimal features' \
        sh firmware/targets/build.sh 386-real fx fig5 $SIZE $DEPTH full "$work/large"
    expect 0 '' sh firmware/targets/build.sh 386-real fx fig5 $SIZE $DEPTH minimal "$work/large"
}

# --minimal knows every feature that there is.
feature_names() {
    crowd "$work/crowd.scene"
    for form in full:fig3 many:"$work/crowd.scene"; do
        "$SUPERFRAME" compile "${form#*:}" --minimal -o - | grep -o 'FEATURE_[A-Z_]* =' |
            sort > "$work/minimal.txt"
        cat firmware/features/all.h "firmware/features/${form%%:*}/feature_set.h" |
            grep -o 'FEATURE_[A-Z_]* =' | sort > "$work/full.txt"
        [ -s "$work/full.txt" ] && diff "$work/full.txt" "$work/minimal.txt" ||
            wrong "host/compiler/features.c and firmware/features/${form%%:*}/feature_set.h differ"
    done
    cat firmware/features/all.h firmware/features/*/feature_set.h | grep -o 'FEATURE_[A-Z_]* =' | sort -u > "$work/full.txt"
}

# What `make size` says of figures that grew: FIELD (5 code ... 9 instructions), FACTOR, the status.
growth() {
    sizes='cortex-m0 fx fig3 minimal 10000 2000 2500 2400 1000.0
cortex-m0 f32 fig3 minimal 10000 2000 2500 2400 2500.0
386-flat fx fig3 minimal 20000 2000 2900 2900 1000.0'
    echo "$sizes" > "$work/kept.txt"
    echo "$sizes" | awk -v field="$1" -v factor="$2" '{ $field = $field * factor; print }' > "$work/now.txt"
    expect "$3" "$4" awk -f tests/targets/size_growth.awk "$work/kept.txt" "$work/now.txt"
}

sizes() {
    growth 5 1.019 0 ''
    growth 5 1.021 1 'cortex-m0 fx fig3 minimal: code grew from 10000 to 10210'
    growth 7 1.03 1 'RAM grew'
    growth 9 1.03 1 'instructions grew'
    growth 9 0.5 0 ''
    echo 'rv32im fx fig3 minimal 1 1 1 1 -' >> "$work/now.txt"
    expect 1 'rv32im fx fig3 minimal: no kept figures' awk -f tests/targets/size_growth.awk "$work/kept.txt" "$work/now.txt"
    sed -i 1d "$work/now.txt"
    expect 1 'cortex-m0 fx fig3 minimal: has kept figures and was not measured' awk -f tests/targets/size_growth.awk "$work/kept.txt" "$work/now.txt"
    expect 0 'cortex-m0: f32 in software takes 2.50 times' awk -f tests/targets/size_limits.awk "$work/kept.txt"
    growth 7 1.2 1 ''
    expect 1 'cortex-m0, RAM: 3000 bytes; the limit is 2920' awk -f tests/targets/size_limits.awk "$work/now.txt"
}

feature_names
names
sizes
hashes
screens
exposures
lacking_feature
too_large
[ $failures -eq 0 ]
