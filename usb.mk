# SPDX-License-Identifier: MIT
# What is built and measured about USB besides the program; read by Makefile.

# ---- The adapter's firmware: no system, no heap, no library but the compiler's own -------------

ADAPTER_SOURCES := $(filter-out %/usb_encoder.c,$(wildcard hal/usb/*.c)) hal/bus.c
ADAPTER_FLAGS   := -ffreestanding -mcpu=cortex-m0plus -mthumb -Os
# clang makes code for any machine and has the freestanding headers; gcc needs its cross compiler.
ADAPTER_CC      ?= $(if $(shell command -v arm-none-eabi-gcc 2>/dev/null),arm-none-eabi-gcc,clang --target=thumbv6m-none-eabi)

$(BUILD)/adapter/%.o: %.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(ADAPTER_CC) $(WARNINGS) $(ADAPTER_FLAGS) $(INCLUDE_hal) -MMD -MP -c -o $@ $<

.PHONY: adapter
adapter: $(ADAPTER_SOURCES:%.c=$(BUILD)/adapter/%.o) ## Compile the adapter's device logic for a Cortex-M0+, with its size
	sh tests/check_adapter.sh $^

# ---- The real libraries against an emulated kernel: once with each flavour of hidapi -----------

USB_TEST_PROGRAMS := $(if $(call has_package,libusb-1.0 hidapi-hidraw hidapi-libusb umockdev-1.0),$(if $(filter libusb%,$(USB_PACKAGES)),$(if $(filter hidapi%,$(USB_PACKAGES)),$(patsubst %,$(BUILD)/sanitized/tests/usb/%_test,hidapi-hidraw hidapi-libusb))))
UMOCKDEV_CFLAGS   := $(if $(USB_TEST_PROGRAMS),$(subst -I,-isystem ,$(shell pkg-config --cflags-only-I umockdev-1.0)))
UMOCKDEV_LIBS     := $(if $(USB_TEST_PROGRAMS),$(shell pkg-config --libs umockdev-1.0))

$(BUILD)/sanitized/tests/usb/%.o: tests/usb/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) -D_DEFAULT_SOURCE $(POSIX) $(CFLAGS_sanitized) $(INCLUDE_tests) -Itests/usb $(UMOCKDEV_CFLAGS) -MMD -MP -c -o $@ $<

# Not the whole program: libunicorn, where it is linked, has functions of GLib's names.
USB_TEST_OBJECTS := $(patsubst tests/%.c,$(BUILD)/sanitized/tests/%.o,$(wildcard tests/usb/*.c)) $(sanitized_HAL) \
                    $(patsubst %.c,$(BUILD)/sanitized/%.o,$(wildcard emulator/board*.c host/usb_*.c host/usb/libusb*.c) emulator/picture.c emulator/native_screen.c host/usb/hidapi.c)

$(USB_TEST_PROGRAMS): $(BUILD)/sanitized/tests/usb/%_test: $(USB_TEST_OBJECTS)
	$(CC) $(LDFLAGS_sanitized) -o $@ $^ -lcmocka -lusb-1.0 -l$* $(UMOCKDEV_LIBS) -ldeflate -lpthread

# ---- Without the libraries: what says so stands in for them ---------------------------------------

WITHOUT_USB := $(filter-out $(BUILD)/release/host/usb/%.o,$(release_LIBRARY)) $(BUILD)/release/host/main.o \
               $(BUILD)/release/host/usb/no_libusb.o $(BUILD)/release/host/usb/no_hidapi.o

$(BUILD)/superframe_without_usb: $(WITHOUT_USB) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(filter-out $(USB_LIBS),$(LIBS))

# ---- The real kernel: Debian's, in an emulated PC, with virtual adapters plugged in -------------

KERNEL_TEST := $(BUILD)/kernel

.PHONY: test-kernel
test-kernel: $(BUILD)/superframe $(BUILD)/sanitized/superframe $(LIBRARIES) ## Draw over USB and HID through the real Linux USB stack, as an ordinary user
	@sh tests/kernel/fetch.sh $(KERNEL_TEST)/debian
	@$(MAKE) --no-print-directory -s install PREFIX=/usr/local DESTDIR='$(abspath $(KERNEL_TEST))/installed'
	@sh tests/kernel/initramfs.sh $(KERNEL_TEST)/debian/system $(KERNEL_TEST)/installed $(KERNEL_TEST)/guest
	@sh tests/kernel/run.sh $(KERNEL_TEST)/guest $(BUILD)/sanitized/superframe $(BUILD)/superframe

# ---- Bytes on the cable -------------------------------------------------------------------------

$(BUILD)/release/tests/bench/usb_bytes.o: tests/bench/usb_bytes.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(BUILD)/usb_bytes: $(BUILD)/release/tests/bench/usb_bytes.o $(release_HAL) $(release_EMULATOR)
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)

.PHONY: usb-table
usb-table: $(BUILD)/superframe $(BUILD)/usb_bytes ## Write docs/usb-bytes.md: what each scene costs on the cable
	sh tests/bench/usb_bytes.sh $(BUILD)/superframe $(BUILD)/usb_bytes > $(BUILD)/usb-bytes.md
	cp $(BUILD)/usb-bytes.md docs/usb-bytes.md

-include $(ADAPTER_SOURCES:%.c=$(BUILD)/adapter/%.d) $(BUILD)/release/tests/bench/usb_bytes.d $(wildcard $(BUILD)/sanitized/tests/usb/*.d)
