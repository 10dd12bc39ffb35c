#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints a C file that holds the given scene files as byte arrays: embed_scenes.sh FILE.scene...
set -eu

if [ $# -eq 0 ]; then
    echo "embed_scenes.sh: no scene files given: at least one is needed" >&2
    exit 2
fi
for file in "$@"; do
    name=$(basename "$file" .scene)
    case $name in
    '' | *[!A-Za-z0-9_-]*)
        echo "embed_scenes.sh: $file: a scene's name is made of letters, digits, _ and -" >&2
        exit 2
        ;;
    esac
    if [ ! -f "$file" ] || [ ! -r "$file" ]; then
        echo "embed_scenes.sh: $file: cannot be read" >&2
        exit 1
    fi
done

cat <<'END'
/* SPDX-License-Identifier: MIT */
/* Made by host/scene/embed.sh from the built-in scene files: change those instead. */
#include "scene/builtin.h"

END

number=0
for file in "$@"; do
    printf 'static const unsigned char text_%d[] = {\n' "$number"
    od -A n -v -t u1 "$file" | sed 's/\([0-9][0-9]*\)/\1,/g; s/  */ /g; s/^ */    /'
    printf '    0};\n\n'
    number=$((number + 1))
done

echo 'const struct builtin_scene builtin_scenes[] = {'
number=0
for file in "$@"; do
    name=$(basename "$file" .scene)
    printf '    {"%s", (const char *)text_%d, sizeof text_%d - 1},\n' "$name" "$number" "$number"
    number=$((number + 1))
done
cat <<'END'
};

const size_t builtin_scene_count = sizeof builtin_scenes / sizeof *builtin_scenes;
END
