/* SPDX-License-Identifier: MIT */
/* The kernel's side of usbfs and hidraw for one device, as far as libusb and hidapi ask for it. */
#include "mock_adapter.h"

#include <errno.h>
#include <linux/hidraw.h>
#include <linux/usbdevice_fs.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

#define USB_PATH "/devices/pci0000:00/0000:00:14.0/usb1/1-1"
#define HID_PATH USB_PATH "/1-1:1.1/0003:1209:9801.0001"

enum { URBS_MOST = 64, REPLUG_US = 200000, NAME_SIZE = 64, TEXT_SIZE = 8192 };

/* A transfer of usbfs. */
struct urb {
    UMockdevIoctlData *data, *buffer; /* data NULL: the place is free */
    bool is_done;
    uint64_t order; /* of submission, then of completion */
};

/* The one device. The handler runs in a thread of umockdev's: everything is under the mutex. */
static struct {
    pthread_mutex_t mutex;
    UMockdevTestbed *testbed;
    UMockdevIoctlBase *handler;
    struct mock_faults faults;
    struct usb_device device;
    struct board board;
    struct board_bus board_bus;
    struct urb urbs[URBS_MOST];
    uint64_t order;
    unsigned outs;   /* transfers to the device so far */
    unsigned number; /* of the device on its bus: each plugging gives another */
    bool is_gone, is_replugging, is_plugged; /* the last: the testbed has its nodes */
    bool has_hid;                            /* the handler is attached to hidraw0 */
    pthread_t replugger;
    uint8_t again[USB_FRAME_MOST]; /* the reply that comes twice */
    int again_count;
} mock = {.mutex = PTHREAD_MUTEX_INITIALIZER};

bool mock_enter(char **argv) {
    if (getenv("SUPERFRAME_MOCKED") != NULL) {
        return true;
    }
    /* The preloaded library comes before the sanitizer's, which otherwise refuses to start. A crash
     * in one of the libraries' threads is the sanitizer's to report, with its stack: cmocka's
     * handler would leave from it to the test's. */
    const char *options = getenv("ASAN_OPTIONS");
    bool has_options = options != NULL && options[0] != 0;
    char text[512];
    (void)snprintf(text, sizeof text, "verify_asan_link_order=0:detect_leaks=0:handle_segv=2%s%s",
                   has_options ? ":" : "", has_options ? options : "");
    (void)setenv("ASAN_OPTIONS", text, 1);
    (void)setenv("SUPERFRAME_MOCKED", "1", 1);
    (void)setenv("LD_PRELOAD", "libumockdev-preload.so.0", 1);
    (void)execv("/proc/self/exe", argv);
    perror("can't start again under umockdev");
    exit(1);
}

/* ---- Transfers ---------------------------------------------------------------------------------
 */

static void finish(struct urb *urb, int status, int count) {
    struct usbdevfs_urb *fields = (struct usbdevfs_urb *)(void *)urb->data->data;
    struct usbdevfs_urb copy = *fields;
    copy.status = status;
    copy.actual_length = count;
    /* Only these two: the pointers in between are umockdev's to translate. */
    umockdev_ioctl_data_update(urb->data, offsetof(struct usbdevfs_urb, status),
                               (guint8 *)&copy.status, sizeof copy.status);
    umockdev_ioctl_data_update(urb->data, offsetof(struct usbdevfs_urb, actual_length),
                               (guint8 *)&copy.actual_length, sizeof copy.actual_length);
    urb->is_done = true;
    urb->order = ++mock.order;
}

static bool strikes(unsigned *times) {
    if (*times == 0) {
        return false;
    }
    --*times;
    return true;
}

/* What the device says on an IN endpoint, after the faults. */
static int read_device(uint8_t endpoint, uint8_t *bytes, size_t room) {
    if (mock.faults.is_mute) {
        return USB_NOTHING_YET;
    }
    if (mock.again_count > 0) {
        int count = mock.again_count < (int)room ? mock.again_count : (int)room;
        memcpy(bytes, mock.again, (size_t)count);
        mock.again_count = 0;
        return count;
    }
    if (mock.faults.is_short && endpoint == USB_BULK_IN && room > 7) {
        room = 7;
    }
    int count = usb_device_in(&mock.device, endpoint, bytes, room);
    if (count > 0 && strikes(&mock.faults.lost_replies)) {
        return USB_NOTHING_YET;
    }
    if (count > 0 && strikes(&mock.faults.corrupt_replies)) {
        bytes[count > 5 ? 5 : 0] ^= 0x20;
    }
    if (count > 0 && strikes(&mock.faults.double_replies)) {
        memcpy(mock.again, bytes, (size_t)count);
        mock.again_count = count;
    }
    return count;
}

static void serve_waiting(void) {
    for (;;) {
        struct urb *oldest = NULL;
        for (unsigned i = 0; i < URBS_MOST; i++) {
            struct urb *urb = &mock.urbs[i];
            if (urb->data != NULL && !urb->is_done &&
                (oldest == NULL || urb->order < oldest->order)) {
                oldest = urb;
            }
        }
        if (oldest == NULL) {
            return;
        }
        const struct usbdevfs_urb *fields = (const void *)oldest->data->data;
        uint8_t bytes[USB_FRAME_MOST];
        size_t room = (size_t)fields->buffer_length;
        int count = read_device(fields->endpoint, bytes, room < sizeof bytes ? room : sizeof bytes);
        if (count == USB_NOTHING_YET) {
            return; /* one endpoint is in use at a time: the others have nothing either */
        }
        if (count > 0) {
            umockdev_ioctl_data_update(oldest->buffer, 0, bytes, count);
        }
        finish(oldest, count < 0 ? -EPIPE : 0, count < 0 ? 0 : count);
    }
}

static void *replug(void *context);

/* The cable is pulled: whatever is on its way comes home, and nothing more is taken. */
static void unplug(void) {
    mock.is_gone = true;
    for (unsigned i = 0; i < URBS_MOST; i++) {
        if (mock.urbs[i].data != NULL && !mock.urbs[i].is_done) {
            finish(&mock.urbs[i], -ESHUTDOWN, 0);
        }
    }
    mock.is_replugging = pthread_create(&mock.replugger, NULL, replug, NULL) == 0;
}

static bool write_device(uint8_t endpoint, const uint8_t *bytes, size_t count) {
    mock.outs++;
    if (mock.faults.unplug_after != 0 && mock.outs >= mock.faults.unplug_after) {
        mock.faults.unplug_after = 0;
        unplug();
        return true;
    }
    if (strikes(&mock.faults.stalls)) {
        mock.device.halted |= endpoint == USB_BULK_OUT ? 1 : 4;
    }
    return usb_device_out(&mock.device, endpoint, bytes, count);
}

static int submit(UMockdevIoctlClient *client) {
    struct urb *urb = NULL;
    for (unsigned i = 0; i < URBS_MOST && urb == NULL; i++) {
        urb = mock.urbs[i].data == NULL ? &mock.urbs[i] : NULL;
    }
    if (urb == NULL) {
        return ENOMEM;
    }
    urb->data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                            sizeof(struct usbdevfs_urb), NULL);
    const struct usbdevfs_urb *fields = (const void *)urb->data->data;
    size_t length = (size_t)fields->buffer_length;
    urb->buffer = length == 0 ? NULL
                              : umockdev_ioctl_data_resolve(
                                    urb->data, offsetof(struct usbdevfs_urb, buffer), length, NULL);
    urb->is_done = false;
    urb->order = ++mock.order;
    const uint8_t *bytes = urb->buffer != NULL ? urb->buffer->data : NULL;
    if (fields->type == USBDEVFS_URB_TYPE_CONTROL) {
        uint8_t in[USB_CONTROL_MOST];
        int count = usb_device_control(&mock.device, bytes, bytes + 8, in);
        bool is_in = (bytes[0] & 0x80) != 0;
        if (count > 0 && is_in) {
            umockdev_ioctl_data_update(urb->buffer, 8, in, count);
        }
        finish(urb, count < 0 ? -EPIPE : 0, count < 0 ? 0 : (is_in ? count : (int)length - 8));
    } else if ((fields->endpoint & 0x80) == 0) {
        bool is_taken = write_device(fields->endpoint, bytes, length);
        if (!urb->is_done) {
            finish(urb, is_taken ? 0 : -EPIPE, is_taken ? (int)length : 0);
        }
    }
    return 0;
}

static int reap(UMockdevIoctlData *arg) {
    struct urb *first = NULL;
    for (unsigned i = 0; i < URBS_MOST; i++) {
        struct urb *urb = &mock.urbs[i];
        if (urb->data != NULL && urb->is_done && (first == NULL || urb->order < first->order)) {
            first = urb;
        }
    }
    if (first == NULL) {
        return mock.is_gone ? ENODEV : EAGAIN;
    }
    UMockdevIoctlData *place = umockdev_ioctl_data_resolve(arg, 0, sizeof(void *), NULL);
    (void)umockdev_ioctl_data_set_ptr(place, 0, first->data);
    g_object_unref(place);
    g_object_unref(first->data);
    if (first->buffer != NULL) {
        g_object_unref(first->buffer);
    }
    first->data = first->buffer = NULL;
    return 0;
}

static int discard(const UMockdevIoctlData *arg) {
    gulong address;
    memcpy(&address, arg->data, sizeof address);
    for (unsigned i = 0; i < URBS_MOST; i++) {
        struct urb *urb = &mock.urbs[i];
        if (urb->data != NULL && !urb->is_done && urb->data->client_addr == address) {
            finish(urb, -ENOENT, 0);
            return 0;
        }
    }
    return EINVAL;
}

static int put(UMockdevIoctlClient *client, size_t size, const void *bytes, size_t count) {
    UMockdevIoctlData *data =
        umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, NULL);
    uint8_t copy[TEXT_SIZE] = {0};
    memcpy(copy, bytes, count);
    umockdev_ioctl_data_update(data, 0, copy, (gint)size);
    g_object_unref(data);
    return 0;
}

static int clear_halt(UMockdevIoctlClient *client) {
    uint8_t clear[8] = {2, 1}, in[USB_CONTROL_MOST];
    UMockdevIoctlData *data = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                          sizeof(unsigned), NULL);
    clear[4] = data->data[0];
    g_object_unref(data);
    return usb_device_control(&mock.device, clear, NULL, in) == 0 ? 0 : EPIPE;
}

static int report_descriptor(UMockdevIoctlClient *client, bool is_size) {
    static const uint8_t get[8] = {0x81, 6, 0, 0x22, 1, 0, 255, 0};
    uint8_t in[USB_CONTROL_MOST];
    struct hidraw_report_descriptor descriptor;
    int count = usb_device_control(&mock.device, get, NULL, in);
    if (is_size) {
        return put(client, sizeof count, &count, sizeof count);
    }
    memset(&descriptor, 0, sizeof descriptor);
    descriptor.size = (unsigned)count;
    memcpy(descriptor.value, in, (size_t)count);
    return put(client, sizeof descriptor, &descriptor, sizeof descriptor);
}

/* ---- What umockdev hands over
 * -------------------------------------------------------------------- */

/* errno's number, 0: it went well. */
static int do_ioctl(UMockdevIoctlClient *client) {
    static const uint32_t capabilities =
        USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
    gulong request = umockdev_ioctl_client_get_request(client);
    if (request == USBDEVFS_REAPURBNDELAY || request == USBDEVFS_REAPURB) {
        serve_waiting();
        return reap(umockdev_ioctl_client_get_arg(client));
    }
    if (request == USBDEVFS_DISCARDURB) {
        return discard(umockdev_ioctl_client_get_arg(client));
    }
    if (mock.is_gone) {
        return ENODEV;
    }
    switch (request) {
    case USBDEVFS_GET_CAPABILITIES:
        return put(client, sizeof capabilities, &capabilities, sizeof capabilities);
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_RELEASEINTERFACE:
        return 0;
    case USBDEVFS_CLEAR_HALT:
        return clear_halt(client);
    case USBDEVFS_SUBMITURB:
        return submit(client);
    case USBDEVFS_GETDRIVER:
        return ENODATA;
    case HIDIOCGRDESCSIZE:
    case HIDIOCGRDESC:
        return report_descriptor(client, request == HIDIOCGRDESCSIZE);
    default:
        return ENOTTY;
    }
}

static gboolean handle_ioctl(UMockdevIoctlBase *handler, UMockdevIoctlClient *client,
                             gpointer unused) {
    (void)handler;
    (void)unused;
    (void)pthread_mutex_lock(&mock.mutex);
    int error = do_ioctl(client);
    (void)pthread_mutex_unlock(&mock.mutex);
    umockdev_ioctl_client_complete(client, error == 0 ? 0 : -1, error);
    return TRUE;
}

static gboolean handle_read(UMockdevIoctlBase *handler, UMockdevIoctlClient *client,
                            gpointer unused) {
    UMockdevIoctlData *arg = umockdev_ioctl_client_get_arg(client);
    uint8_t report[USB_REPORT_BYTES];
    (void)handler;
    (void)unused;
    (void)pthread_mutex_lock(&mock.mutex);
    int count = mock.is_gone ? -ENODEV : read_device(USB_HID_IN, report, sizeof report);
    (void)pthread_mutex_unlock(&mock.mutex);
    if (count > 0) {
        umockdev_ioctl_data_update(arg, 0, report, count);
        umockdev_ioctl_client_complete(client, count, 0);
    } else {
        umockdev_ioctl_client_complete(client, -1, count == -ENODEV ? ENODEV : EAGAIN);
    }
    return TRUE;
}

static gboolean handle_write(UMockdevIoctlBase *handler, UMockdevIoctlClient *client,
                             gpointer unused) {
    const UMockdevIoctlData *arg = umockdev_ioctl_client_get_arg(client);
    (void)handler;
    (void)unused;
    (void)pthread_mutex_lock(&mock.mutex);
    int error = mock.is_gone ? ENODEV : 0;
    if (error == 0 && !write_device(USB_HID_OUT, arg->data + 1, (size_t)arg->data_len - 1)) {
        error = EPIPE;
    }
    (void)pthread_mutex_unlock(&mock.mutex);
    umockdev_ioctl_client_complete(client, error == 0 ? arg->data_len : -1, error);
    return TRUE;
}

/* ---- Plugging
 * -------------------------------------------------------------------------------------- */

static void node_name(char name[NAME_SIZE]) {
    (void)snprintf(name, NAME_SIZE, "/dev/bus/usb/001/%03u", mock.number);
}

static void describe_hex(char *text) {
    static const uint8_t requests[2][8] = {{0x80, 6, 0, 1, 0, 0, 18, 0},
                                           {0x80, 6, 0, 2, 0, 0, 255, 0}};
    uint8_t in[USB_CONTROL_MOST];
    for (unsigned i = 0; i < 2; i++) {
        int count = usb_device_control(&mock.device, requests[i], NULL, in);
        for (int j = 0; j < count; j++) {
            text += sprintf(text, "%02X", in[j]);
        }
    }
}

static void add_to_testbed(void) {
    static const uint8_t set_configuration[8] = {0, 9, 1, 0, 0, 0, 0, 0};
    char name[NAME_SIZE], hex[1024], text[TEXT_SIZE];
    uint8_t in[USB_CONTROL_MOST];
    GError *error = NULL;
    mock.number++;
    node_name(name);
    describe_hex(hex);
    (void)snprintf(text, sizeof text,
                   "P: " USB_PATH "\nN: %s\nE: DEVNAME=%s\nE: DEVTYPE=usb_device\n"
                   "E: BUSNUM=001\nE: DEVNUM=%03u\nE: PRODUCT=1209/9801/100\nE: SUBSYSTEM=usb\n"
                   "A: busnum=1\\n\nA: devnum=%u\\n\nA: bConfigurationValue=1\\n\n"
                   "A: speed=480\\n\nA: idVendor=1209\\n\nA: idProduct=9801\\n\n"
                   "A: serial=MOCK\\n\nH: descriptors=%s\n\n"
                   "P: " USB_PATH "/1-1:1.1\nE: DEVTYPE=usb_interface\nE: SUBSYSTEM=usb\n"
                   "A: bInterfaceNumber=01\\n\n\n"
                   "P: " HID_PATH "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:00001209:00009801\n"
                   "E: HID_NAME=superframe SuperFrame adapter\nE: HID_UNIQ=MOCK\n\n"
                   "P: " HID_PATH "/hidraw/hidraw0\nN: hidraw0=00\nE: DEVNAME=/dev/hidraw0\n"
                   "E: SUBSYSTEM=hidraw\nL: device=../../../0003:1209:9801.0001\n",
                   name + 5, name, mock.number, mock.number, hex);
    /* Before there is a node: whoever opens one that nobody answers for is ended by umockdev. */
    if (!umockdev_testbed_attach_ioctl(mock.testbed, name, mock.handler, &error) ||
        (!mock.has_hid &&
         !umockdev_testbed_attach_ioctl(mock.testbed, "/dev/hidraw0", mock.handler, &error)) ||
        !umockdev_testbed_add_from_string(mock.testbed, text, &error)) {
        (void)fprintf(stderr, "umockdev: %s\n", error->message);
        exit(1);
    }
    (void)usb_device_control(&mock.device, set_configuration, NULL, in);
    mock.is_plugged = mock.has_hid = true;
}

static void remove_from_testbed(void) {
    /* The handler stays attached: letting go of it would abort a call that is under way. */
    umockdev_testbed_uevent(mock.testbed, "/sys" USB_PATH, "remove");
    umockdev_testbed_remove_device(mock.testbed, "/sys" HID_PATH "/hidraw/hidraw0");
    umockdev_testbed_remove_device(mock.testbed, "/sys" HID_PATH);
    umockdev_testbed_remove_device(mock.testbed, "/sys" USB_PATH "/1-1:1.1");
    umockdev_testbed_remove_device(mock.testbed, "/sys" USB_PATH);
    mock.is_plugged = false;
}

static void power_on(void) {
    struct board_desc desc = board_default_desc(BOARD_1987);
    (void)board_init(&mock.board, &desc);
    board_bus_init(&mock.board_bus, &mock.board);
    usb_device_init(&mock.device, &mock.board_bus.bus, 0, "MOCK", true);
}

static void *replug(void *context) {
    (void)usleep(REPLUG_US);
    remove_from_testbed();
    (void)pthread_mutex_lock(&mock.mutex);
    bool comes_back = !mock.faults.is_lost_for_good;
    usb_device_reset(&mock.device);
    if (mock.faults.forgets) {
        power_on();
    }
    (void)pthread_mutex_unlock(&mock.mutex);
    if (comes_back) {
        (void)usleep(REPLUG_US);
        add_to_testbed();
        (void)pthread_mutex_lock(&mock.mutex);
        mock.is_gone = false;
        (void)pthread_mutex_unlock(&mock.mutex);
        umockdev_testbed_uevent(mock.testbed, "/sys" USB_PATH, "add");
    }
    return context;
}

void mock_set_faults(const struct mock_faults *faults) {
    (void)pthread_mutex_lock(&mock.mutex);
    mock.faults = *faults;
    mock.outs = 0;
    (void)pthread_mutex_unlock(&mock.mutex);
}

void mock_plug(const struct mock_faults *faults) {
    mock.testbed = umockdev_testbed_new();
    mock.handler = umockdev_ioctl_base_new();
    (void)g_signal_connect(mock.handler, "handle-ioctl", G_CALLBACK(handle_ioctl), NULL);
    (void)g_signal_connect(mock.handler, "handle-read", G_CALLBACK(handle_read), NULL);
    (void)g_signal_connect(mock.handler, "handle-write", G_CALLBACK(handle_write), NULL);
    mock.is_gone = mock.is_replugging = mock.has_hid = false;
    mock.again_count = 0;
    power_on();
    mock_set_faults(faults);
    add_to_testbed();
}

void mock_remove(void) {
    if (mock.is_replugging) {
        (void)pthread_join(mock.replugger, NULL);
        mock.is_replugging = false;
    }
    if (mock.is_plugged) {
        remove_from_testbed();
    }
    memset(mock.urbs, 0, sizeof mock.urbs);
    g_clear_object(&mock.testbed);
    g_clear_object(&mock.handler);
}

const struct board *mock_board(void) {
    return &mock.board;
}

struct usb_adapter mock_state(void) {
    (void)pthread_mutex_lock(&mock.mutex);
    struct usb_adapter state = mock.device.adapter;
    (void)pthread_mutex_unlock(&mock.mutex);
    return state;
}
