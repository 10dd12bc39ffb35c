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

# Sets compiler, start and emulator for a target.
choose() {
    arm='arm-none-eabi-gcc -mthumb'
    case $1 in
    m0) compiler="$arm -mcpu=cortex-m0" start=arm emulator=qemu-arm ;;
    m3) compiler="$arm -mcpu=cortex-m3" start=arm emulator=qemu-arm ;;
    m4f) compiler="$arm -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16" start=arm_fpu emulator=qemu-arm ;;
    i386) compiler='gcc -m32 -march=i386 -fno-pic -fno-pie -no-pie' start=i386 emulator=qemu-i386 ;;
    i387) compiler='gcc -m32 -march=i386 -mfpmath=387 -fno-pic -fno-pie -no-pie' start=i387 emulator=qemu-i386 ;;
    x86_64) compiler='gcc -fno-pie -no-pie' start=x86_64 emulator=qemu-x86_64 ;;
    *)
        echo "$1: no such target; allowed are: m0 m3 m4f i386 i387 x86_64" >&2
        exit 2
        ;;
    esac
}

# real ARITHMETIC TARGET: the arithmetic's folder, as firmware/targets/build.sh takes it for the target.
real() {
    case $1-$2 in
    fx-m0) echo fx_16 ;;
    fx-m3) echo fx_m3 ;;
    fx-m4f | fx-i386) echo fx_32 ;;
    *) echo "$1" ;;
    esac
}

# count_instructions: of $folder/program, by the plugin of QEMU that COUNT names.
count_instructions() {
    plugin=$(realpath "${COUNT:-${BUILD:-build}/targets/count.so}")
    (cd "$folder" && "$emulator" -plugin "$plugin" ./program > /dev/null && cat instructions.txt)
}
