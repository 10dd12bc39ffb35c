#!/bin/sh
# SPDX-License-Identifier: MIT
# Reads what the adapter's device logic asks of the outside: check_adapter.sh OBJECT...
#
# Nothing but what a compiler calls by itself may be undefined once the objects are put together,
# and there is no writable data but the pointer to the bound bus. Without objects, those of
# $BUILD/adapter are made and read. Exit status: 0 all hold, 1 one does not.
set -u
cd "$(dirname "$0")/.." || exit 1
BUILD=${BUILD:-build}
if [ $# -eq 0 ]; then
    exec make --no-print-directory -s adapter BUILD="$BUILD" SETUP=no
fi
NM=$(command -v arm-none-eabi-nm llvm-nm llvm-nm-14 | head -n 1)
SIZE=$(command -v arm-none-eabi-size llvm-size llvm-size-14 | head -n 1)
if [ -z "$NM" ] || [ -z "$SIZE" ]; then
    NM=nm
    SIZE=size
fi
defined=$("$NM" -g --defined-only "$@" | awk 'NF == 3 { print $3 }')
failures=0
for symbol in $("$NM" -u "$@" | awk '/ [Uu] / { print $NF }' | sort -u); do
    case " $(echo $defined) memcpy memset memmove __aeabi_memclr __aeabi_memclr4 __aeabi_memcpy
__aeabi_memcpy4 __aeabi_memset __aeabi_uidiv __aeabi_uidivmod __gnu_thumb1_case_uqi
__gnu_thumb1_case_uhi __gnu_thumb1_case_sqi __gnu_thumb1_case_shi " in
    *[!a-zA-Z0-9_]"$symbol"[!a-zA-Z0-9_]*) ;;
    *)
        echo "adapter: asks for $symbol; allowed is what a compiler calls by itself"
        failures=1
        ;;
    esac
done
"$SIZE" "$@" | awk '
NR == 1 { print }
NR > 1 {
    print
    text += $1
    data += $2
    bss += $3
}
END {
    printf "adapter: %d bytes of code and tables, %d of data, %d of bss\n", text, data, bss
    exit data > 0 || bss > 4 || text == 0
}' || {
    echo 'adapter: has writable data; allowed is the pointer to the bound bus'
    failures=1
}
exit $failures
