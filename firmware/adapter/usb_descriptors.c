/* SPDX-License-Identifier: MIT */
/* Device, configuration, strings, HID report, BOS, and the MS OS 2.0 set. */
#include "usb_descriptors.h"

#define LOW(word)  ((word)&0xFF)
#define HIGH(word) ((word) >> 8 & 0xFF)

enum {
    TYPE_DEVICE = 1,
    TYPE_CONFIGURATION = 2,
    TYPE_STRING = 3,
    TYPE_QUALIFIER = 6,
    TYPE_BOS = 15,
    TYPE_HID = 0x21,
    TYPE_REPORT = 0x22,
    CONFIGURATION_BYTES = 64,
    HID_PLACE = 41, /* of the HID descriptor within the configuration's */
    HID_BYTES = 9,
    REPORT_DESCRIPTOR_BYTES = 33,
    BOS_BYTES = 33,
    MICROSOFT_BYTES = 178,
    QUALIFIER_BYTES = 10,
    STRING_SERIAL = 3
};

/* In the tables a line is an item of the specification. */
/* clang-format off */
static const uint8_t device_table[18] = {
    18, TYPE_DEVICE,
    0x01, 0x02, /* USB 2.01: from there on the BOS descriptor is asked for */
    0, 0, 0,    /* the class is the interfaces' */
    64,
    LOW(USB_VENDOR_ID), HIGH(USB_VENDOR_ID),
    LOW(USB_PRODUCT_ID), HIGH(USB_PRODUCT_ID),
    LOW(0x0100), HIGH(0x0100),
    1, 2, STRING_SERIAL,
    1 /* configuration */
};

/* Full speed; at high speed the bulk packets are larger. 100 mA. */
static const uint8_t configuration_table[CONFIGURATION_BYTES] = {
    9, TYPE_CONFIGURATION, CONFIGURATION_BYTES, 0, USB_INTERFACES, 1, 0, 0x80, 50,
    9, 4, USB_BULK_INTERFACE, 0, 2, 0xFF, 0, USB_VERSION, 0,
    7, 5, USB_BULK_OUT, 2, 64, 0, 0,
    7, 5, USB_BULK_IN, 2, 64, 0, 0,
    9, 4, USB_HID_INTERFACE, 0, 2, 3, 0, 0, 0,
    HID_BYTES, TYPE_HID, 0x11, 0x01, 0, 1, TYPE_REPORT, REPORT_DESCRIPTOR_BYTES, 0,
    7, 5, USB_HID_OUT, 3, USB_REPORT_BYTES, 0, 1,
    7, 5, USB_HID_IN, 3, USB_REPORT_BYTES, 0, 1
};

enum { BULK_OUT_SIZE_PLACE = 22, BULK_IN_SIZE_PLACE = 29 }; /* of wMaxPacketSize above */

/* Vendor page FF00h, one collection: 64 bytes in, 64 out, 32 as a feature. */
static const uint8_t report_table[REPORT_DESCRIPTOR_BYTES] = {
    0x06, 0x00, 0xFF,       /* usage page FF00h */
    0x09, 0x01,             /* usage 1 */
    0xA1, 0x01,             /* application collection */
    0x15, 0x00,             /* values from 0 */
    0x26, 0xFF, 0x00,       /* to 255 */
    0x75, 0x08,             /* of 8 bits */
    0x95, USB_REPORT_BYTES, 0x09, 0x02, 0x81, 0x02,
    0x95, USB_REPORT_BYTES, 0x09, 0x03, 0x91, 0x02,
    0x95, USB_FEATURE_BYTES, 0x09, 0x04, 0xB1, 0x02,
    0xC0
};

/* One capability: the platform's that Microsoft defined for MS OS 2.0. */
static const uint8_t bos_table[BOS_BYTES] = {
    5, TYPE_BOS, BOS_BYTES, 0, 1,
    28, 0x10, 5, 0,
    0xDF, 0x60, 0xDD, 0xD8, 0x89, 0x45, 0xC7, 0x4C, /* D8DD60DF-4589-4CC7-9CD2-659D9E648A9F */
    0x9C, 0xD2, 0x65, 0x9D, 0x9E, 0x64, 0x8A, 0x9F,
    0x00, 0x00, 0x03, 0x06, /* Windows 8.1 and later */
    MICROSOFT_BYTES, 0, USB_MICROSOFT_REQUEST, 0
};

/* The MS OS 2.0 set; the registry property's name and value follow as UTF-16. */
static const uint8_t microsoft_table[] = {
    10, 0, 0, 0, 0x00, 0x00, 0x03, 0x06, MICROSOFT_BYTES, 0, /* set header */
    8, 0, 1, 0, 0, 0, 168, 0,                               /* subset of the configuration */
    8, 0, 2, 0, USB_BULK_INTERFACE, 0, 160, 0,              /* subset of the function */
    20, 0, 3, 0,                                            /* compatible id */
    'W', 'I', 'N', 'U', 'S', 'B', 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    132, 0, 4, 0, 7, 0, 42, 0 /* registry property: a list of strings, a name of 42 bytes */
};
/* clang-format on */

static const char guids_name[] = "DeviceInterfaceGUIDs";
static const char guids_value[] = "{5A2F6C1E-98D0-4B0B-9C3B-7D9801C0D0DE}";

static size_t copy(uint8_t *to, const uint8_t *from, size_t count) {
    for (size_t i = 0; i < count; i++) {
        to[i] = from[i];
    }
    return count;
}

/* Widens count letters of ASCII to UTF-16, the 0 at the end too if count says so. Returns the bytes
 * written. */
static size_t widen(uint8_t *to, const char *text, size_t count) {
    for (size_t i = 0; i < count; i++) {
        usb_put16(to + 2 * i, (uint8_t)text[i]);
    }
    return 2 * count;
}

static size_t length_of(const char *text) {
    size_t length = 0;
    while (text[length] != '\0') {
        length++;
    }
    return length;
}

static size_t string_descriptor(const struct usb_device *device, unsigned index, uint8_t *bytes) {
    static const char *const texts[STRING_SERIAL] = {"", "superframe", "SuperFrame adapter"};
    if (index > STRING_SERIAL) {
        return 0;
    }
    if (index == 0) {
        usb_put16(bytes + 2, 0x0409); /* the only language: English */
        bytes[0] = 4;
    } else {
        const char *text = index == STRING_SERIAL ? device->serial : texts[index];
        bytes[0] = (uint8_t)(2 + widen(bytes + 2, text, length_of(text)));
    }
    bytes[1] = TYPE_STRING;
    return bytes[0];
}

static size_t configuration_descriptor(const struct usb_device *device, uint8_t *bytes) {
    size_t count = copy(bytes, configuration_table, sizeof configuration_table);
    if (device->is_high_speed) {
        usb_put16(bytes + BULK_OUT_SIZE_PLACE, 512);
        usb_put16(bytes + BULK_IN_SIZE_PLACE, 512);
    }
    return count;
}

/* Copies the descriptor of what would be at the other speed: one configuration as well. */
static size_t qualifier_descriptor(uint8_t *bytes) {
    static const uint8_t table[QUALIFIER_BYTES] = {
        QUALIFIER_BYTES, TYPE_QUALIFIER, 0x01, 0x02, 0, 0, 0, 64, 1, 0};
    return copy(bytes, table, sizeof table);
}

size_t usb_descriptor(const struct usb_device *device, uint16_t value, uint8_t *bytes) {
    unsigned index = value & 0xFF;
    switch (value >> 8) {
    case TYPE_DEVICE:
        return copy(bytes, device_table, sizeof device_table);
    case TYPE_CONFIGURATION:
        return index == 0 ? configuration_descriptor(device, bytes) : 0;
    case TYPE_STRING:
        return string_descriptor(device, index, bytes);
    case TYPE_QUALIFIER:
        return device->is_high_speed ? qualifier_descriptor(bytes) : 0;
    case TYPE_BOS:
        return copy(bytes, bos_table, sizeof bos_table);
    case TYPE_HID:
        return copy(bytes, configuration_table + HID_PLACE, HID_BYTES);
    case TYPE_REPORT:
        return copy(bytes, report_table, sizeof report_table);
    default:
        return 0;
    }
}

size_t usb_microsoft_descriptor(uint8_t *bytes) {
    size_t count = copy(bytes, microsoft_table, sizeof microsoft_table);
    count += widen(bytes + count, guids_name, sizeof guids_name);
    usb_put16(bytes + count, 2 * (sizeof guids_value + 1));
    count += 2;
    count += widen(bytes + count, guids_value, sizeof guids_value);
    usb_put16(bytes + count, 0); /* a list of strings ends with an empty one */
    return count + 2;
}
