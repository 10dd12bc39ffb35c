# SPDX-License-Identifier: MIT
# The library, its test kit, and where everything is installed; read by Makefile.

PREFIX  ?= /usr/local
DESTDIR ?=
INSTALL ?= install
VERSION := $(shell sed -n 's/^.define SUPERFRAME_VERSION "\(.*\)"/\1/p' host/command.h)
SONAME  := libsuperframe.so.$(firstword $(subst ., ,$(VERSION)))

TESTKIT_SOURCES := $(wildcard emulator/testing/*.c)
INCLUDE_testkit := $(INCLUDE_emulator) -Iemulator/testing
# What a program that uses the library may include: all but the emulator's own.
PUBLIC_HEADERS := $(filter-out %_internal.h,$(wildcard hal/*.h hal/usb/*.h emulator/*.h)) emulator/testing/testing.h

LIBRARY_OBJECTS := $(HAL_SOURCES:%.c=$(BUILD)/library/%.o) $(EMULATOR_SOURCES:%.c=$(BUILD)/library/%.o)
TESTKIT_OBJECTS := $(TESTKIT_SOURCES:%.c=$(BUILD)/library/%.o)
LIBRARIES := $(BUILD)/library/libsuperframe.a $(BUILD)/library/$(SONAME) $(BUILD)/library/libsuperframe-testing.a

# One set of objects for the static and the shared library.
$(BUILD)/library/%.o: %.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) -fPIC $(INCLUDE_testkit) -MMD -MP -c -o $@ $<

$(BUILD)/library/libsuperframe.a: $(LIBRARY_OBJECTS) $(BUILD)/sources
	@rm -f $@
	$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/library/libsuperframe-testing.a: $(TESTKIT_OBJECTS)
	@rm -f $@
	$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/library/$(SONAME): $(LIBRARY_OBJECTS) $(BUILD)/sources
	$(CC) -shared -Wl,-soname,$(SONAME) -Wl,-z,defs -o $@ $(filter %.o,$^) -lpng -lxxhash -ldeflate

.PHONY: library
library: $(LIBRARIES) ## Build libsuperframe, static and shared, and its test kit

.PHONY: install
install: $(BUILD)/superframe $(LIBRARIES) ## Install command, library, test kit and man pages (PREFIX=/usr/local DESTDIR=)
	$(INSTALL) -d '$(DESTDIR)$(PREFIX)/bin' '$(DESTDIR)$(PREFIX)/lib/pkgconfig' '$(DESTDIR)$(PREFIX)/include/superframe' '$(DESTDIR)$(PREFIX)/share/man/man1' '$(DESTDIR)$(PREFIX)/share/man/man3' '$(DESTDIR)$(PREFIX)/lib/udev/rules.d'
	$(INSTALL) -m 755 $(BUILD)/superframe '$(DESTDIR)$(PREFIX)/bin'
	$(INSTALL) -m 644 $(filter %.a,$(LIBRARIES)) '$(DESTDIR)$(PREFIX)/lib'
	$(INSTALL) -m 755 $(BUILD)/library/$(SONAME) '$(DESTDIR)$(PREFIX)/lib'
	ln -sf $(SONAME) '$(DESTDIR)$(PREFIX)/lib/libsuperframe.so'
	$(INSTALL) -m 644 $(PUBLIC_HEADERS) '$(DESTDIR)$(PREFIX)/include/superframe'
	for name in superframe superframe-testing; do sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' emulator/testing/$$name.pc.in > '$(DESTDIR)$(PREFIX)/lib/pkgconfig/'$$name.pc && chmod 644 '$(DESTDIR)$(PREFIX)/lib/pkgconfig/'$$name.pc || exit 1; done
	$(INSTALL) -m 644 host/usb/70-superframe.rules '$(DESTDIR)$(PREFIX)/lib/udev/rules.d'
	$(INSTALL) -m 644 docs/*.1 '$(DESTDIR)$(PREFIX)/share/man/man1'
	$(INSTALL) -m 644 docs/*.3 '$(DESTDIR)$(PREFIX)/share/man/man3'

# Where tests/check_install.sh builds the examples: nothing of an earlier install is left in it.
FRESH_PREFIX := $(abspath $(BUILD))/prefix
.PHONY: fresh-prefix
fresh-prefix: $(BUILD)/superframe $(LIBRARIES)
	@rm -rf '$(FRESH_PREFIX)'
	@$(MAKE) --no-print-directory -s install PREFIX='$(FRESH_PREFIX)' DESTDIR=

-include $(LIBRARY_OBJECTS:.o=.d) $(TESTKIT_OBJECTS:.o=.d)
