# SPDX-License-Identifier: MIT
# What an ordinary user does with an adapter, step by step: read by guest.sh, in the guest.
#
# The environment has the TCP port of each virtual adapter on the other side: PORT_BULK, PORT_HID,
# PORT_REPLUG_BULK, PORT_REPLUG_HID and PORT_PULLED. Each step prints "ok - WHAT" or "not ok - WHAT".
failures=0

# verdict STATUS WHAT: what was printed last goes with what did not hold.
verdict() {
    if [ "$1" -eq 0 ]; then
        echo "ok - $2, $(cut -d " " -f 1 /proc/uptime) s"
    else
        echo "not ok - $2"
        sed 's/^/    /' /tmp/out
        failures=$((failures + 1))
    fi
}

# as USER WORDS...: superframe as that user; its words are in /tmp/out, its exit status in $status.
as() {
    user=$1
    shift
    su "$user" -c "cd /tmp && superframe $*" > /tmp/out 2>&1
    status=$?
}

# expect STATUS TEXT WHAT: of what ran last.
expect() {
    [ "$status" -eq "$1" ] && { [ -z "$2" ] || grep -q -- "$2" /tmp/out; }
    verdict $? "$3"
}

# until_true SECONDS COMMAND...: asks until it is true; machines under load are slow.
until_true() {
    tries=$(($1 * 50))
    shift
    until "$@" > /dev/null 2>&1; do
        tries=$((tries - 1))
        [ $tries -gt 0 ] || return 1
        usleep 20000
    done
}

attach() {
    usbip --tcp-port "$1" attach -r 10.0.2.2 -b 1-1 > /tmp/usbip 2>&1
}

# has_nodes PLACE: the device there has its hidraw node, the last of its nodes.
has_nodes() {
    [ -d "$(echo /sys/bus/usb/devices/1-"$1":1.1/*/hidraw/hidraw*)" ]
}

is_gone() {
    ! [ -e "/sys/bus/usb/devices/1-$1" ]
}

# Plugs in the adapter behind a TCP port, at the first try: who has just left has left it free.
plug() {
    attach "$1" || {
        cp /tmp/usbip /tmp/out
        verdict 1 "plug in port $1"
    }
}

# plug_and_settle PORT PLACE: the same, and waits until udev has done with it.
plug_and_settle() {
    plug "$1"
    until_true 60 has_nodes "$2"
    udevadm settle --timeout=60
}

# pull PLACE: pulls what is plugged in there, counted from 1.
pull() {
    usbip detach -p $(($1 - 1)) > /tmp/usbip 2>&1
    until_true 60 is_gone "$1" || verdict 1 "pull the cable at $1"
}

# has_sent N: so many transfers have been handed to the device.
has_sent() {
    [ "$(cat /sys/bus/usb/devices/1-1/urbnum)" -ge "$1" ]
}

# ---- Without the project's udev rule -----------------------------------------------------------

as artist render fig3 --bus usb
expect 1 'no adapter (1209:9801) is plugged in' 'without an adapter there is an error'
plug_and_settle "$PORT_BULK" 1
as artist devices
expect 0 '^usb.*no permission' 'without the rule devices says that the bulk node may not be opened'
expect 0 '^hid.*no permission' 'without the rule devices says that the hidraw node may not be opened'
for way in usb hid; do
    as artist render fig3 --bus $way
    expect 1 '70-superframe.rules is missing' "without the rule render --bus $way names it"
done
pull 1

# ---- With it -----------------------------------------------------------------------------------

mv /tmp/70-superframe.rules /usr/local/lib/udev/rules.d/
udevadm control --reload
plug_and_settle "$PORT_BULK" 1
as visitor render fig3 --bus usb
expect 1 'may not open it' 'the rule lets nobody in who is not at the machine'
as artist devices
expect 0 '^usb.BULK.USB bus 001 device [0-9]*$' 'with the rule devices lists the bulk node'
expect 0 '^hid.BULK./dev/hidraw[0-9]*$' 'with the rule devices lists the hidraw node'
as artist render fig3 --bus usb --verify --quiet
expect 0 '256000 pixels read back, 0 differed' 'render fig3 --bus usb draws, and reads all of it back'

plug_and_settle "$PORT_HID" 2
as artist render fig3 --bus hid
expect 1 '2 adapters are plugged in.*BULK.*HID' 'with two adapters one has to be named'
pull 1
as artist render fig3 --bus hid --verify=5 --quiet
expect 0 'pixels read back, 0 differed' 'render fig3 --bus hid draws, and reads a sample back'
pull 2

# ---- Hot-plugging ------------------------------------------------------------------------------

# draw WORDS...: begins a rendering that goes on in the background.
draw() {
    rm -f /tmp/stats
    su artist -c "cd /tmp && superframe render fig3 --depth 2 --quiet --stats stats $*" \
        > /tmp/out 2>&1 &
    drawing=$!
}

# Pulls the cable after so many transfers.
pull_after() {
    until_true 60 has_sent "$1"
    pull 1
    kill -0 $drawing
    verdict $? "the cable is pulled in the middle of the frame"
}

end_of_drawing() {
    wait $drawing
    status=$?
}

# replug PORT TRANSFERS WORDS...: pulled and plugged in again, a rendering goes on where it was.
replug() {
    port=$1
    transfers=$2
    shift 2
    draw --wait "$@"
    until_true 60 grep -q 'waiting for an adapter' /tmp/out
    plug "$port"
    pull_after "$transfers"
    plug "$port"
    end_of_drawing
    expect 0 '' "$*: plugged in again, it goes on to the end"
    tr -d ' \n' < /tmp/stats | grep -q '"reconnects":[1-9],"restarts":0,'
    verdict $? "$*: it went on where it was"
    pull 1
}
replug "$PORT_REPLUG_BULK" 45 --bus usb --colour dither
replug "$PORT_REPLUG_HID" 250 --bus hid

# Pulled for good: an error in time that says which rows are there; the others alone complete it.
plug_and_settle "$PORT_PULLED" 1
draw --bus usb --colour dither
pull_after 45
since=$(cut -d . -f 1 /proc/uptime)
end_of_drawing
expect 1 'went away.*of 200 rows [0-9]* are known to be on the board: 0-' \
    'an adapter that stays away is an error that names the rows'
[ $(($(cut -d . -f 1 /proc/uptime) - since)) -le 20 ]
verdict $? 'it comes within 20 s'
first=$(sed -n 's/.*missing are \([0-9]*\)-199$/\1/p' /tmp/out)
plug_and_settle "$PORT_PULLED" 1
as artist render fig3 --depth 2 --colour dither --bus usb --quiet --rows "${first:-none}:200"
expect 0 '' 'the missing rows are drawn alone'
pull 1
