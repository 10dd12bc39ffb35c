#!/bin/sh
# SPDX-License-Identifier: MIT
# Packs the guest of `make test-kernel`: initramfs.sh SYSTEM INSTALLED FOLDER
#
# SYSTEM     Debian's packages as fetch.sh left them
# INSTALLED  what `make install DESTDIR=INSTALLED` put there: the program and the udev rule
# FOLDER     gets the initramfs, and the link "kernel"; what was in it goes
set -eu
system=$1
installed=$2
folder=$3
here=$(dirname "$0")
root=$folder/root
busybox=$(cd "$system" && pwd)/bin/busybox

# The loader looks into the unpacked packages first, then into this machine's libraries.
libraries_of() {
    LD_LIBRARY_PATH="$system/lib/x86_64-linux-gnu:$system/usr/lib/x86_64-linux-gnu" ldd "$@" |
        sed -n -e 's/.*=> \([^ ]*\).*/\1/p' -e 's/^[[:space:]]*\(\/lib[^ ]*\) .*/\1/p' | sort -u
}

rm -rf "$folder"
umask 022 # udev and su distrust a root that others may write to
mkdir -p "$root/bin" "$root/sbin" "$root/dev" "$root/proc" "$root/sys" "$root/run" "$root/tmp" \
    "$root/etc" "$root/lib64" "$root/lib/x86_64-linux-gnu" "$root/usr/local/bin" \
    "$root/usr/local/lib/udev/rules.d" "$root/var" "$root/usr/sbin"
ln -s "$(cd "$system" && pwd)"/boot/vmlinuz-* "$folder/kernel"

cp "$system/bin/busybox" "$system/bin/udevadm" "$system/bin/kmod" "$root/bin/"
cp "$system/usr/sbin/usbip" "$root/usr/sbin/"
cp -R "$system/lib/udev" "$system/lib/modules" "$root/lib/"
rm -f "$root/lib/udev/hwdb.bin"
ln -s ../../bin/udevadm "$root/lib/udev/udevd" # by that name it is the daemon
cp "$installed/usr/local/bin/superframe" "$root/usr/local/bin/"
cp "$installed/usr/local/lib/udev/rules.d/70-superframe.rules" "$root/usr/local/lib/udev/rules.d/"
for library in $(libraries_of "$installed/usr/local/bin/superframe" "$system/bin/udevadm" \
    "$system/bin/kmod" "$system/usr/sbin/usbip"); do
    case $library in
    not)
        echo 'initramfs: a library that the guest needs is not here: see ldd' >&2
        exit 2
        ;;
    *ld-linux*) cp -L "$library" "$root/lib64/" ;;
    *) cp -L "$library" "$root/lib/x86_64-linux-gnu/" ;;
    esac
done

cat > "$root/etc/passwd" << 'END'
root:x:0:0:root:/:/bin/sh
artist:x:1000:1000:sits at the machine:/tmp:/bin/sh
visitor:x:1001:1001:came over the network:/tmp:/bin/sh
END
cat > "$root/etc/group" << 'END'
root:x:0:
tty:x:5:
input:x:101:
kvm:x:102:
artist:x:1000:
visitor:x:1001:
END
cp "$here/guest.sh" "$root/init"
cp "$here/guest_steps.sh" "$root/steps"
chmod 755 "$root/init"
(cd "$root" && find . | "$busybox" cpio -o -H newc -R 0:0) > "$folder/initramfs.new" 2> "$folder/cpio.log"
mv "$folder/initramfs.new" "$folder/initramfs"
rm -rf "$root"
