# SPDX-License-Identifier: MIT
# The targets whose instructions are counted; sourced with $folder set to a scratch folder.

cat > "$folder/arm.s" << 'END'
.syntax unified
.thumb
.global _start
.thumb_func
_start: bl run
    movs r7, #1
    movs r0, #0
    svc #0
END
cat "$folder/arm.s" - > "$folder/arm_fpu.s" << 'END'
.global sqrtf
.thumb_func
sqrtf: vsqrt.f32 s0, s0
    bx lr
END
cat > "$folder/i387.s" << 'END'
.global _start, sqrtf, sqrt
_start: call run
    movl $1, %eax
    xorl %ebx, %ebx
    int $0x80
sqrtf: flds 4(%esp)
    fsqrt
    ret
sqrt: fldl 4(%esp)
    fsqrt
    ret
END
cat > "$folder/i386.s" << 'END'
.global _start
_start: call run
    movl $1, %eax
    xorl %ebx, %ebx
    int $0x80
END
cat > "$folder/x86_64.s" << 'END'
.global _start, sqrtf, sqrt
_start: call run
    movl $60, %eax
    xorl %edi, %edi
    syscall
sqrtf: sqrtss %xmm0, %xmm0
    ret
sqrt: sqrtsd %xmm0, %xmm0
    ret
END

. firmware/targets/targets.sh

# choose TARGET: sets compiler, start, emulator, and fx, the folder of firmware/real/ for fx; where
# there are images for the CPU, as they have it.
choose() {
    fx=fx
    case $1 in
    m0 | m3 | m4f)
        target_read "cortex-$1"
        compiler="arm-none-eabi-gcc -mthumb $cpu" start=arm emulator=qemu-arm
        [ "$1" != m4f ] || start=arm_fpu
        ;;
    i386)
        target_read 386-flat
        compiler="gcc $cpu -march=i386 -fno-pic -fno-pie -no-pie" start=i386 emulator=qemu-i386
        ;;
    i387) compiler='gcc -m32 -march=i386 -mfpmath=387 -fno-pic -fno-pie -no-pie' start=i387 emulator=qemu-i386 ;;
    x86_64) compiler='gcc -fno-pie -no-pie' start=x86_64 emulator=qemu-x86_64 ;;
    *)
        echo "$1: no such target; allowed are: m0 m3 m4f i386 i387 x86_64" >&2
        exit 2
        ;;
    esac
}

# real ARITHMETIC: the arithmetic's folder on the chosen target.
real() {
    [ "$1" = fx ] && echo "$fx" || echo "$1"
}

# count_instructions: of $folder/program, by the plugin of QEMU that COUNT names.
count_instructions() {
    plugin=$(realpath "${COUNT:-${BUILD:-build}/targets/count.so}")
    (cd "$folder" && "$emulator" -plugin "$plugin" ./program > /dev/null && cat instructions.txt)
}
