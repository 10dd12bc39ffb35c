/* SPDX-License-Identifier: MIT */
/* The standard and HID requests, and the two pairs of endpoints in front of the adapter. */
#include "usb_device.h"

#include "usb_descriptors.h"

/* bmRequestType and bRequest as one number; what an int of 16 bits cannot hold is no enum. */
#define GET_DEVICE_STATUS        UINT16_C(0x8000)
#define GET_INTERFACE_STATUS     UINT16_C(0x8100)
#define GET_ENDPOINT_STATUS      UINT16_C(0x8200)
#define GET_DESCRIPTOR           UINT16_C(0x8006)
#define GET_INTERFACE_DESCRIPTOR UINT16_C(0x8106)
#define GET_CONFIGURATION        UINT16_C(0x8008)
#define GET_INTERFACE            UINT16_C(0x810A)
#define HID_GET_REPORT           UINT16_C(0xA101)
#define MICROSOFT_GET            (UINT16_C(0xC000) | USB_MICROSOFT_REQUEST)

enum {
    CLEAR_ENDPOINT_FEATURE = 0x0201,
    SET_ENDPOINT_FEATURE = 0x0203,
    SET_ADDRESS = 0x0005,
    SET_CONFIGURATION = 0x0009,
    SET_INTERFACE = 0x010B,
    HID_SET_REPORT = 0x2109,
    HID_SET_IDLE = 0x210A,
    MICROSOFT_SET_INDEX = 7,
    REPORT_TYPE_OUTPUT = 2,
    REPORT_TYPE_FEATURE = 3
};

void usb_device_init(struct usb_device *device, struct bus *bus, uint16_t base_served,
                     const char *serial, bool is_high_speed) {
    usb_adapter_init(&device->adapter, bus, base_served);
    unsigned i = 0;
    for (; i < USB_SERIAL_MOST && serial[i] != '\0'; i++) {
        device->serial[i] = serial[i];
    }
    device->serial[i] = '\0';
    device->is_high_speed = is_high_speed;
    usb_device_reset(device);
}

void usb_device_reset(struct usb_device *device) {
    device->configuration = 0;
    device->halted = 0;
    device->is_by_hid = false;
    usb_adapter_detach(&device->adapter);
}

/* Returns the bit of an endpoint in halted, 0 if there is no such endpoint. */
static uint8_t bit_of(unsigned endpoint) {
    switch (endpoint) {
    case USB_BULK_OUT:
        return 1;
    case USB_BULK_IN:
        return 2;
    case USB_HID_OUT:
        return 4;
    case USB_HID_IN:
        return 8;
    default:
        return 0;
    }
}

/* Writes the counters, for a look at an adapter that nobody speaks to. */
static int feature_report(const struct usb_device *device, uint8_t *in) {
    const struct usb_adapter *adapter = &device->adapter;
    for (unsigned i = 0; i < USB_FEATURE_BYTES; i++) {
        in[i] = 0;
    }
    in[0] = USB_VERSION;
    usb_put32(in + 4, adapter->session);
    usb_put32(in + 8, adapter->last);
    usb_put32(in + 12, adapter->frames_run);
    usb_put32(in + 16, adapter->duplicates);
    usb_put32(in + 20, adapter->damaged);
    usb_put16(in + 24, adapter->base);
    return USB_FEATURE_BYTES;
}

static int status_bytes(uint8_t *in, unsigned status) {
    usb_put16(in, (uint16_t)status);
    return 2;
}

/* Answers requests about endpoints. wValue 0 is ENDPOINT_HALT, the only feature that endpoints
 * have. */
static int endpoint_request(struct usb_device *device, unsigned request, unsigned value,
                            unsigned endpoint, uint8_t *in) {
    uint8_t bit = bit_of(endpoint);
    bool is_control = (endpoint & 0x7F) == 0;
    if (request == GET_ENDPOINT_STATUS) {
        return bit != 0 || is_control ? status_bytes(in, (device->halted & bit) != 0) : USB_STALL;
    }
    if (value != 0 || bit == 0) {
        return is_control && value == 0 ? 0 : USB_STALL;
    }
    device->halted =
        (uint8_t)(request == SET_ENDPOINT_FEATURE ? device->halted | bit : device->halted & ~bit);
    return 0;
}

static int class_request(struct usb_device *device, unsigned request, unsigned value,
                         unsigned length, const uint8_t *data, uint8_t *in) {
    if (request == HID_GET_REPORT && value >> 8 == REPORT_TYPE_FEATURE) {
        return feature_report(device, in);
    }
    if (request == HID_SET_REPORT && value >> 8 == REPORT_TYPE_OUTPUT) {
        return usb_device_out(device, USB_HID_OUT, data, length) ? 0 : USB_STALL;
    }
    return request == HID_SET_IDLE ? 0 : USB_STALL;
}

int usb_device_control(struct usb_device *device, const uint8_t setup[8], const uint8_t *data,
                       uint8_t *in) {
    unsigned request = (unsigned)setup[0] << 8 | setup[1];
    unsigned value = usb_get16(setup + 2), index = usb_get16(setup + 4);
    unsigned length = usb_get16(setup + 6);
    size_t count;
    int answer;
    switch (request) {
    case GET_DESCRIPTOR:
    case GET_INTERFACE_DESCRIPTOR:
        count = usb_descriptor(device, (uint16_t)value, in);
        answer = count > 0 ? (int)count : USB_STALL;
        break;
    case MICROSOFT_GET:
        answer = index == MICROSOFT_SET_INDEX ? (int)usb_microsoft_descriptor(in) : USB_STALL;
        break;
    case GET_DEVICE_STATUS:
    case GET_INTERFACE_STATUS:
        answer = status_bytes(in, 0);
        break;
    case GET_ENDPOINT_STATUS:
    case CLEAR_ENDPOINT_FEATURE:
    case SET_ENDPOINT_FEATURE:
        answer = endpoint_request(device, request, value, index & 0xFF, in);
        break;
    case GET_CONFIGURATION:
    case GET_INTERFACE:
        in[0] = request == GET_CONFIGURATION ? device->configuration : 0;
        answer = 1;
        break;
    case SET_ADDRESS:
        return 0; /* the USB block does it */
    case SET_CONFIGURATION:
        if (value > 1) {
            return USB_STALL;
        }
        usb_device_reset(device);
        device->configuration = (uint8_t)value;
        return 0;
    case SET_INTERFACE:
        return value == 0 && index < USB_INTERFACES ? 0 : USB_STALL;
    default:
        answer = class_request(device, request, value, length, data, in);
        break;
    }
    /* As unsigned: an int of 16 bits does not hold every wLength. */
    return answer > 0 && (unsigned)answer > length ? (int)length : answer;
}

static bool is_ready(const struct usb_device *device, uint8_t endpoint) {
    uint8_t bit = bit_of(endpoint);
    return bit != 0 && device->configuration != 0 && (device->halted & bit) == 0;
}

bool usb_device_out(struct usb_device *device, uint8_t endpoint, const uint8_t *bytes,
                    size_t count) {
    if (!is_ready(device, endpoint)) {
        return false;
    }
    if (endpoint == USB_HID_OUT) {
        count = usb_report_length(bytes, count);
    }
    if (count == 0) {
        return true;
    }
    if (endpoint == USB_HID_OUT) {
        bytes++; /* behind the length; where no byte came there is none */
    }
    bool is_by_hid = endpoint == USB_HID_OUT;
    if (is_by_hid != device->is_by_hid) {
        /* Another program at the other interface: it begins with a frame of its own. */
        usb_adapter_detach(&device->adapter);
        device->is_by_hid = is_by_hid;
    }
    if (usb_adapter_receive(&device->adapter, bytes, count) < count) {
        device->halted |= bit_of(endpoint);
        return false;
    }
    return true;
}

int usb_device_in(struct usb_device *device, uint8_t endpoint, uint8_t *bytes, size_t room) {
    bool is_by_hid = endpoint == USB_HID_IN;
    if (!is_ready(device, endpoint) || (is_by_hid && room < USB_REPORT_BYTES)) {
        return USB_STALL;
    }
    if (device->is_by_hid != is_by_hid || device->adapter.output_count == 0) {
        return USB_NOTHING_YET;
    }
    if (!is_by_hid) {
        return (int)usb_adapter_fetch(&device->adapter, bytes, room < 16384 ? room : 16384);
    }
    uint8_t stream[USB_REPORT_STREAM_BYTES];
    size_t count = usb_adapter_fetch(&device->adapter, stream, sizeof stream);
    (void)usb_report_pack(bytes, stream, count);
    return USB_REPORT_BYTES;
}
