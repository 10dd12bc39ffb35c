/* SPDX-License-Identifier: MIT */
/* What usb_requests.sh has Frama-C's Eva read where int has 16 bits: an answer is as long as the
 * device has it, and no longer than asked for, whatever wLength is. */
#include "usb_device.h"

/* Of a request, and of the device's answer to it. */
struct question {
    uint8_t type, request, value_high;
    unsigned bytes;
};

static const struct question questions[] = {
    {0x80, 6, 1, 18},                /* the device descriptor */
    {0x80, 6, 2, 64},                /* the configuration */
    {0x80, 0, 0, 2},                 /* the status */
    {0xA1, 1, 3, USB_FEATURE_BYTES}, /* the counters */
};
static const uint16_t lengths[] = {0, 1, 2, 17, 18, 19, 63, 64, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF};

enum { QUESTIONS = 4, LENGTHS = 12 };

static struct usb_device device;

void ask_all(void) {
    static struct bus bus;
    uint8_t in[USB_CONTROL_MOST];
    usb_device_init(&device, &bus, 0x00D0, "ABC", false);
    for (unsigned i = 0; i < QUESTIONS; i++) {
        for (unsigned j = 0; j < LENGTHS; j++) {
            const struct question *question = &questions[i];
            uint16_t length = lengths[j];
            const uint8_t setup[8] = {
                question->type,  question->request,     0, question->value_high, 0, 0,
                (uint8_t)length, (uint8_t)(length >> 8)};
            int answer = usb_device_control(&device, setup, 0, in);
            unsigned allowed = length < question->bytes ? length : question->bytes;
            /*@ assert answer == allowed; */
        }
    }
}
