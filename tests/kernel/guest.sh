#!/bin/busybox sh
# SPDX-License-Identifier: MIT
# The guest of `make test-kernel`, from the kernel's first process on: Debian's udev, the modules for
# USB over the network, two ordinary users; then the steps of guest_steps.sh.
#
# What it says goes out by the serial line; the machine is switched off at the end.
/bin/busybox --install -s /bin
PATH=/usr/local/bin:/bin:/usr/sbin
export PATH
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
mount -t tmpfs -o mode=0755 run /run
chmod 1777 /tmp
ln -s /run /var/run
exec > /dev/ttyS0 2>&1 < /dev/null
echo "guest: Linux $(uname -r), up after $(cut -d ' ' -f 1 /proc/uptime) s"

ln -sf kmod /bin/modprobe
modprobe e1000
modprobe vhci-hcd
ip link set eth0 up
ip address add 10.0.2.15/24 dev eth0

# What logind writes down when somebody logs in at the machine; udev's uaccess reads it.
mkdir -p /run/systemd/seats
printf 'ACTIVE=c1\nACTIVE_UID=1000\n' > /run/systemd/seats/seat0

# The project's rule is in its place as `make install` left it; the first steps do without.
mv /usr/local/lib/udev/rules.d/70-superframe.rules /tmp/
/lib/udev/udevd --daemon

. /steps
echo "guest: done, $failures steps failed, after $(cut -d ' ' -f 1 /proc/uptime) s"
poweroff -f
