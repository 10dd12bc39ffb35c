#!/bin/sh
# SPDX-License-Identifier: MIT
# Gets what the guest of `make test-kernel` is made of: Debian's kernel, udev and usbip, unpacked
# into FOLDER, not installed: fetch.sh FOLDER
#
# Nothing of this machine changes but FOLDER: a kernel that is installed wants to be booted, and a
# udev that is installed wants to run. What is there already is not fetched again. Exit status: 0 it
# is all there, 2 it can't be had.
set -u
folder=$1
arch=amd64

say() {
    printf 'fetch: %s\n' "$*" >&2
}

[ ! -e "$folder/complete" ] || exit 0
command -v apt-get > /dev/null 2>&1 || {
    say 'there is no apt-get here: the guest is made of Debian packages'
    exit 2
}
rm -rf "$folder"
mkdir -p "$folder/packages" "$folder/system" || exit 2

# The kernel that the meta-package depends on; the cloud variant has no USB.
kernel_package() {
    apt-cache depends "linux-image-$arch" 2> /dev/null |
        sed -n "s/^ *Depends: \(linux-image-[0-9].*-$arch\)$/\1/p" | head -n 1
}

download() {
    kernel=$(kernel_package)
    [ -n "$kernel" ] &&
        (cd "$folder/packages" &&
            timeout 300 apt-get -q download "$kernel" udev systemd libkmod2 kmod usbip busybox-static) \
            > "$folder/apt.log" 2>&1
}

if ! download; then
    # The package lists may be old, or not be there at all.
    as_root=
    [ "$(id -u)" -eq 0 ] || as_root=sudo
    $as_root apt-get -q update > "$folder/apt.log" 2>&1 < /dev/null
    if ! download; then
        tail -n 5 "$folder/apt.log" >&2
        say 'the packages can not be downloaded'
        exit 2
    fi
fi

# Of the kernel's 400 MB only what the guest loads.
for package in "$folder"/packages/*.deb; do
    case $package in
    */linux-image-*)
        dpkg-deb --fsys-tarfile "$package" | tar -x -C "$folder/system" --wildcards \
            './boot/vmlinuz-*' './lib/modules/*/modules.*' \
            './lib/modules/*/drivers/usb/common/*' './lib/modules/*/drivers/usb/core/*' \
            './lib/modules/*/drivers/usb/usbip/*' './lib/modules/*/drivers/hid/hid.ko*' \
            './lib/modules/*/drivers/hid/hid-generic.ko*' './lib/modules/*/drivers/hid/usbhid/*' \
            './lib/modules/*/drivers/net/ethernet/intel/e1000/*'
        ;;
    *) dpkg-deb -x "$package" "$folder/system" ;;
    esac || {
        say "$package can not be unpacked"
        exit 2
    }
done
version=$(basename "$folder"/system/lib/modules/*)
ln -sf ../bin/kmod "$folder/system/sbin/depmod" # the package's own link is an absolute one
"$folder/system/sbin/depmod" -b "$folder/system" "$version" 2> "$folder/depmod.log" || {
    say "depmod failed: $(head -n 1 "$folder/depmod.log")"
    exit 2
}
rm -rf "$folder/packages"
touch "$folder/complete"
