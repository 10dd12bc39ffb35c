# SPDX-License-Identifier: MIT
# Builds, runs and tests superframe; everything that it makes goes under build/.
# `make help` lists the targets, `make V=1` shows whole commands.

# make's own default, cc, may be any compiler.
ifeq ($(origin CC),default)
CC      := gcc
endif
OBJCOPY ?= objcopy
BUILD   ?= build
SCENE   ?= fig3
# Nothing is installed to install something.
SETUP   ?= $(if $(filter install uninstall,$(MAKECMDGOALS)),no,yes)

WARNINGS := -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror
OPTIMISE ?= -O2
DEBUG    ?= -g
# Golden images: no contraction to fused multiply-add, no excess precision.
FLOATING := -ffp-contract=off
# Files of more than 2 GiB where long has 32 bits.
POSIX    := -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64

# ---- What this machine has ----------------------------------------------------------------------

has_package = $(shell pkg-config --exists '$(1)' 2>/dev/null && echo yes)

# f128 takes libquadmath and a compiler with its numbers; QUADMATH=no leaves it out.
ifndef QUADMATH
QUADMATH := $(shell printf 'extern __float128 sqrtq(__float128);\n%s\n' \
    'int main(int n, char **s) { return s && sqrtq(n) > 9; }' | \
    $(CC) -x c - -o /dev/null -lquadmath 2>/dev/null && echo yes || echo no)
endif
ARITHMETICS := fx f32 f64 $(if $(filter yes,$(QUADMATH)),f128)
# For `superframe measure` alone: what fx is measured against.
EXAMPLES    := q16 q16_epsilon
# The folder of an arithmetic, below firmware/real/.
real = $(if $(wildcard firmware/real/$(1)/real.h),$(1),lab/$(1))
# Where gcc keeps quadmath.h: clang links gcc's library but does not look among its headers.
COMPILER_HEADERS = $(dir $(shell $(CC) -print-file-name=include/quadmath.h))

# The ways to an adapter: USB_LIBUSB=no and USB_HIDAPI=no leave one out, USB_HIDAPI=hidapi-libusb
# takes the other flavour.
USB_LIBUSB ?= libusb-1.0
USB_HIDAPI ?= hidapi-hidraw
USB_PACKAGES := $(foreach package,$(USB_LIBUSB) $(USB_HIDAPI),$(if $(call has_package,$(package)),$(package)))
USB_CFLAGS := $(if $(USB_PACKAGES),$(subst -I,-isystem ,$(shell pkg-config --cflags-only-I $(USB_PACKAGES))))
USB_LIBS   := $(if $(USB_PACKAGES),$(shell pkg-config --libs $(USB_PACKAGES)))

# The CPU of `superframe boot`, loaded when a floppy is booted; BOOT_UNICORN=no leaves it out.
BOOT_UNICORN ?= unicorn
BOOT_PACKAGE := $(if $(call has_package,$(BOOT_UNICORN)),$(BOOT_UNICORN))

LIBS := -lpng -lxxhash -ldeflate $(if $(filter yes,$(QUADMATH)),-lquadmath) -lm -lpthread \
        $(USB_LIBS) $(if $(BOOT_PACKAGE),-ldl)

# Streams of rays, for the arithmetics that CPUs have in vectors; fx as it suits vectors, with the
# same bits. Of the sets of instructions that are compiled for, one is taken at run time.
STREAM_REALS := f32 f64 fx
IS_X86_64    := $(filter x86_64%,$(shell $(CC) -dumpmachine))
STREAM_SETS  := plain $(if $(IS_X86_64),avx2 avx512)

# ---- Sources ------------------------------------------------------------------------------------

HAL_SOURCES      := $(wildcard hal/*.c hal/cable/*.c)
FIRMWARE_SOURCES := $(wildcard firmware/*.c)
ADAPTER_SOURCES  := $(wildcard firmware/adapter/*.c)
TESTKIT_SOURCES  := $(wildcard emulator/testing/*.c)
EMULATOR_SOURCES := $(filter-out $(TESTKIT_SOURCES),$(wildcard emulator/*/*.c))
STREAM_SOURCES   := $(wildcard host/stream/*.c) firmware/solids.c
# Compiled once for each arithmetic beside the firmware.
PER_ARITHMETIC_SOURCES := $(wildcard host/render/per_arithmetic/*.c)
DRIVERS  := $(if $(filter libusb%,$(USB_PACKAGES)),bulk) $(if $(filter hidapi%,$(USB_PACKAGES)),hid)
LEFT_OUT := $(patsubst %,adapter/driver_%,$(filter-out $(DRIVERS),bulk hid)) \
            $(if $(BOOT_PACKAGE),,boot/cpu_unicorn boot/unicorn_library) \
            $(if $(IS_X86_64),,render/instruction_sets_x86_64)
HOST_SOURCES := $(filter-out $(STREAM_SOURCES) $(LEFT_OUT:%=host/%.c) host/command/main.c, \
                $(wildcard host/*/*.c host/lab/*/*.c))
SCENE_FILES  := $(wildcard firmware/scenes/*.scene)
# What this build has of several kinds: header, type, names. host/base/list.sh makes C of a list.
LISTS := commands arithmetics stream_engines instruction_sets usb_backends processors
LIST_commands         := command/command.h command render scenes check compile export tree replay \
                         compare measure paper devices adapter trace boot completion manual help
LIST_arithmetics      := render/arithmetic.h arithmetic $(ARITHMETICS)
LIST_stream_engines   := render/engine.h stream_engine $(foreach real,$(STREAM_REALS),$(STREAM_SETS:%=$(real)_%))
LIST_instruction_sets := render/engine.h instruction_set $(filter-out plain,$(STREAM_SETS))
LIST_usb_backends     := adapter/drivers.h usb_backend $(DRIVERS)
LIST_processors       := boot/cpu.h processor $(if $(BOOT_PACKAGE),unicorn)

INCLUDE_hal      := -Ihal -Ihal/cable
INCLUDE_firmware := $(INCLUDE_hal) -Ifirmware
INCLUDE_emulator := $(INCLUDE_hal) $(patsubst %,-Iemulator/%,board picture trace bus)
INCLUDE_host     := $(INCLUDE_emulator) -Ifirmware -Ifirmware/adapter -Ihost $(USB_CFLAGS)
INCLUDE_tests    := $(INCLUDE_host) -Iemulator/testing -Itests/fixtures -idirafter $(COMPILER_HEADERS)

# ---- How a thing is made ------------------------------------------------------------------------

# A configuration is one build of everything: release for use, library for others' programs,
# sanitized for the tests, fuzzed for the fuzzers, coverage for the count of branches.
CONFIGURATIONS := release sanitized fuzzed
CFLAGS_release   := $(OPTIMISE) $(DEBUG)
CFLAGS_library   := $(OPTIMISE) $(DEBUG) -fPIC
CFLAGS_coverage  := -O0 -g --coverage
CFLAGS_sanitized := -O1 $(DEBUG) -fsanitize=address,undefined -fno-sanitize-recover=all \
                    -fno-omit-frame-pointer
CFLAGS_fuzzed    := $(CFLAGS_sanitized) -fsanitize=fuzzer-no-link,float-cast-overflow
LDFLAGS_sanitized := -fsanitize=address,undefined
LDFLAGS_fuzzed    := -fsanitize=fuzzer,address,undefined

# say WORD: names what is made, where the command itself is not shown.
say = @$(if $(V),:,printf '  %-4s %s\n' '$(1)' '$(@:$(BUILD)/%=%)')
Q  := $(if $(V),,@)

# compile FLAGS: an object of its source; what its folder needs besides stands in FLAGS_folder. What is
# compiled once for each arithmetic is named when it is put together.
define compile
@mkdir -p $(@D)
$(if $(findstring firmware/,$@)$(findstring stream/,$@)$(findstring arithmetic/,$@),,$(call say,CC))
$(Q)$(CC) $(WARNINGS) $(1) $(FLAGS_$(patsubst %/,%,$(dir $<))) -MMD -MP -c -o $@ $<
endef

# link FLAGS,LIBRARIES: a program of the objects and sources before it.
define link
@mkdir -p $(@D)
$(call say,LD)
$(Q)$(CC) $(1) -o $@ $(filter %.c %.o %.a,$^) $(2)
endef

# combine SYMBOLS: one object of several, of which only those symbols leave.
define combine
$(call say,JOIN)
$(Q)$(CC) -r -nostdlib -o $@ $(filter %.o,$^)
$(Q)$(if $(1),$(OBJCOPY) $(1:%=--keep-global-symbol=%) $@)
endef

# objects CONFIGURATION: whatever lies in the project, by the top folder's include path.
define objects
$$(BUILD)/$(1)/%.o: %.c $$(BUILD)/flags | setup
	$$(call compile,$$(POSIX) $$(CFLAGS_$(1)) $$(INCLUDE_$$(firstword $$(subst /, ,$$<))))

$$(BUILD)/$(1)/%.o: $$(BUILD)/%.c $$(BUILD)/flags
	$$(call compile,$$(CFLAGS_$(1)) $$(INCLUDE_host))
endef

# image CONFIGURATION,ARITHMETIC: the firmware, chosen by the include path; one symbol leaves it.
define image
$(1)_$(2)_FIRMWARE := $$(FIRMWARE_SOURCES:%.c=$$(BUILD)/$(1)/$(2)/%.o)

$$(BUILD)/$(1)/$(2)/%.o: %.c $$(BUILD)/flags | setup
	$$(call compile,$$(if $$(filter firmware%,$$<),-ffreestanding) $$(FLOATING) $$(CFLAGS_$(1)) \
	    -Ifirmware/real/$$(call real,$(2)) -Ifirmware/features/full $$(INCLUDE_$$(firstword $$(subst /, ,$$<))))

$$(BUILD)/$(1)/image_$(2).o: $$($(1)_$(2)_FIRMWARE) \
    $$(PER_ARITHMETIC_SOURCES:%.c=$$(BUILD)/$(1)/$(2)/%.o) $$(BUILD)/sources
	$$(call combine,arithmetic_$(2))

# The firmware without what the host adds to it: tests/check_symbols.sh reads this.
$$(BUILD)/$(1)/firmware_$(2).o: $$($(1)_$(2)_FIRMWARE) $$(BUILD)/sources
	$$(call combine)
endef

# Nothing here changes a result: no trap is waited for, no errno is read, no infinity is made in a
# lane that counts (strict/real.h), and no sign of a zero is asked for.
# No operand is to be skipped: in lanes, & is what && is elsewhere.
STREAM_FLAGS := -O3 -fno-trapping-math -fno-math-errno -ffinite-math-only -fno-signed-zeros \
                -Wno-bitwise-instead-of-logical
# Two of gcc's passes make branches in loops that are to be vectors: they thread jumps through
# choices that hang together, and, in some files, look for partial redundancies. A third calls memcpy
# for loops that are too short for it.
ifeq ($(findstring clang,$(shell $(CC) --version)),)
STREAM_FLAGS += -fno-thread-jumps -fno-tree-loop-distribute-patterns
STREAM_FLAGS_search_solids   := -fno-tree-pre
STREAM_FLAGS_search_quadrics := -fno-tree-pre
STREAM_FLAGS_boundaries      := -fno-tree-pre
endif
FLAGS_avx2   := -march=x86-64-v3
FLAGS_avx512 := -march=x86-64-v4 -mprefer-vector-width=512

# stream CONFIGURATION,ARITHMETIC,SET: one engine.
define stream
$$(BUILD)/$(1)/stream/$(2)_$(3)/%.o: %.c $$(BUILD)/flags | setup
	$$(call compile,$$(FLOATING) $$(CFLAGS_$(1)) $$(STREAM_FLAGS) $$(STREAM_FLAGS_$$(*F)) $$(FLAGS_$(3)) \
	    -Ifirmware/real/$(2:fx=fx_vector) -Ihost/stream/sets/$(3) -Ifirmware/features/full $$(INCLUDE_host))

$$(BUILD)/$(1)/stream_$(2)_$(3).o: $$(STREAM_SOURCES:%.c=$$(BUILD)/$(1)/stream/$(2)_$(3)/%.o) $$(BUILD)/sources
	$$(call combine,stream_engine_$(2)_$(3))
endef

define whole
$(1)_HAL      := $$(patsubst %.c,$$(BUILD)/$(1)/%.o,$$(HAL_SOURCES) $$(ADAPTER_SOURCES))
$(1)_EMULATOR := $$(EMULATOR_SOURCES:%.c=$$(BUILD)/$(1)/%.o)
$(1)_HOST     := $$(HOST_SOURCES:%.c=$$(BUILD)/$(1)/%.o)
$(1)_IMAGES   := $$(patsubst %,$$(BUILD)/$(1)/image_%.o,$$(ARITHMETICS) $$(EXAMPLES)) \
                 $$(foreach real,$$(STREAM_REALS),$$(STREAM_SETS:%=$$(BUILD)/$(1)/stream_$$(real)_%.o)) \
                 $$(LISTS:%=$$(BUILD)/$(1)/lists/%.o) $$(BUILD)/$(1)/builtin_scenes.o
$(1)_LIBRARY  := $$($(1)_IMAGES) $$($(1)_HAL) $$($(1)_EMULATOR) $$($(1)_HOST)

$$(foreach arithmetic,$$(ARITHMETICS) $$(EXAMPLES),$$(eval $$(call image,$(1),$$(arithmetic))))
$$(foreach real,$$(STREAM_REALS),$$(foreach set,$$(STREAM_SETS),$$(eval $$(call stream,$(1),$$(real),$$(set)))))

$$(BUILD)/$(1)/superframe: $$(BUILD)/$(1)/host/command/main.o $$($(1)_LIBRARY) $$(BUILD)/sources
	$$(call link,$$(LDFLAGS_$(1)),$$(LIBS))
endef

# tool PROGRAM,SOURCES: a program of the tests, with all of the project in it.
define tool
$$(BUILD)/$(1): $$(patsubst %.c,$$(BUILD)/release/%.o,$(2)) $$(release_LIBRARY) $$(BUILD)/sources
	$$(call link,,$$(LIBS))
endef

all: $(BUILD)/superframe ## Build the program (the default)

$(BUILD)/superframe: $(BUILD)/release/superframe
	@cp $< $@.new && mv -f $@.new $@

.DELETE_ON_ERROR:
# Objects are kept; .SECONDARY would leave out one that is missing where what needs it is newer.
.PRECIOUS: %.o %.c

$(foreach configuration,$(CONFIGURATIONS),$(eval $(call whole,$(configuration))))
$(foreach configuration,$(CONFIGURATIONS) library coverage,$(eval $(call objects,$(configuration))))

# Compiler and flags of the last build: when they change, everything is compiled again.
$(BUILD)/flags: FORCE | setup
	@mkdir -p $(@D)
	@echo '$(subst ','\'',$(CC) $(WARNINGS) $(FLOATING) $(CFLAGS_library) $(CFLAGS_fuzzed) $(STREAM_FLAGS))' > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# The list of sources: when a file goes away, what was linked from it is linked again.
$(BUILD)/sources: FORCE
	@mkdir -p $(@D)
	@echo $(HAL_SOURCES) $(EMULATOR_SOURCES) $(FIRMWARE_SOURCES) $(HOST_SOURCES) > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# The built-in scenes' texts, as byte arrays, and the lists.
$(BUILD)/builtin_scenes.c: host/scene/embed.sh $(SCENE_FILES)
	@mkdir -p $(@D)
	@sh $< $(SCENE_FILES) > $@.new && mv $@.new $@

$(LISTS:%=$(BUILD)/lists/%.c): $(BUILD)/lists/%.c: host/base/list.sh FORCE
	@mkdir -p $(@D)
	@sh $< $* $(LIST_$*) > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

FORCE:

# ---- The library --------------------------------------------------------------------------------

PREFIX  ?= /usr/local
LIBDIR  ?= $(PREFIX)/lib
DESTDIR ?=
INSTALL ?= install
VERSION := $(shell sed -n 's/^.define SUPERFRAME_VERSION "\(.*\)"/\1/p' host/command/command.h)
SONAME  := libsuperframe.so.$(firstword $(subst ., ,$(VERSION)))
# What a program that uses the library may include: all but the emulator's own.
PUBLIC_HEADERS := emulator/testing/testing.h $(filter-out %_internal.h, \
                  $(wildcard hal/*.h hal/cable/*.h firmware/adapter/*.h emulator/board/*.h) \
                  $(wildcard emulator/picture/*.h emulator/trace/*.h emulator/bus/*.h))
LIBRARIES := $(addprefix $(BUILD)/library/,libsuperframe.a libsuperframe-testing.a $(SONAME))
LIBRARY_OBJECTS := $(patsubst %.c,$(BUILD)/library/%.o,$(HAL_SOURCES) $(ADAPTER_SOURCES) $(EMULATOR_SOURCES))

$(BUILD)/library/libsuperframe.a: $(LIBRARY_OBJECTS) $(BUILD)/sources
$(BUILD)/library/libsuperframe-testing.a: $(TESTKIT_SOURCES:%.c=$(BUILD)/library/%.o)
$(BUILD)/library/%.a:
	$(call say,AR)
	@rm -f $@
	$(Q)$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/library/$(SONAME): $(LIBRARY_OBJECTS) $(BUILD)/sources
	$(call link,-shared -Wl$(comma)-soname$(comma)$(SONAME) -Wl$(comma)-z$(comma)defs,-lpng -lxxhash -ldeflate)
comma := ,

library: $(LIBRARIES) ## Build libsuperframe, static and shared, and its test kit

# What is installed, as FILE:FOLDER:MODE.
BIN := $(PREFIX)/bin
INSTALLED := $(BUILD)/superframe:$(BIN):755 \
    $(foreach library,$(LIBRARIES),$(library):$(LIBDIR):$(if $(filter %.a,$(library)),644,755)) \
    $(PUBLIC_HEADERS:%=%:$(PREFIX)/include/superframe:644) \
    $(patsubst %,$(BUILD)/%.pc:$(LIBDIR)/pkgconfig:644,superframe superframe-testing) \
    host/adapter/70-superframe.rules:$(PREFIX)/lib/udev/rules.d:644 \
    $(patsubst %,%:$(PREFIX)/share/man/man1:644,$(BUILD)/superframe.1 $(wildcard docs/*.1)) \
    $(patsubst %,%:$(PREFIX)/share/man/man3:644,$(wildcard docs/*.3)) \
    $(BUILD)/completion/superframe:$(PREFIX)/share/bash-completion/completions:644 \
    $(BUILD)/completion/_superframe:$(PREFIX)/share/zsh/site-functions:644 \
    $(BUILD)/completion/superframe.fish:$(PREFIX)/share/fish/vendor_completions.d:644
COMPLETIONS := $(addprefix $(BUILD)/completion/,superframe _superframe superframe.fish)

$(BUILD)/completion/superframe: SHELL_NAME := bash
$(BUILD)/completion/_superframe: SHELL_NAME := zsh
$(BUILD)/completion/superframe.fish: SHELL_NAME := fish
$(COMPLETIONS): $(BUILD)/superframe
	@mkdir -p $(@D)
	@$< completion $(SHELL_NAME) > $@

$(BUILD)/%.pc: emulator/testing/%.pc.in FORCE
	@mkdir -p $(@D)
	@sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@LIBDIR@|$(LIBDIR)|' -e 's|@VERSION@|$(VERSION)|' $< > $@

$(BUILD)/superframe.1: docs/superframe.roff $(BUILD)/superframe
	@{ $(BUILD)/superframe manual && cat $<; } > $@

install: $(BUILD)/superframe $(BUILD)/superframe.1 $(COMPLETIONS) $(LIBRARIES) $(BUILD)/superframe.pc $(BUILD)/superframe-testing.pc ## Install command, library, test kit and man pages (PREFIX=/usr/local LIBDIR= DESTDIR=)
	@set -e; for entry in $(INSTALLED); do \
	    file=$${entry%%:*}; mode=$${entry##*:}; folder='$(DESTDIR)'$${entry#*:}; folder=$${folder%:*}; \
	    $(INSTALL) -d "$$folder"; $(INSTALL) -m $$mode $$file "$$folder"; done
	@ln -sf $(SONAME) '$(DESTDIR)$(LIBDIR)/libsuperframe.so'

uninstall: ## Remove what `make install` put there
	@for entry in $(INSTALLED); do \
	    folder='$(DESTDIR)'$${entry#*:}; file=$${entry%%:*}; rm -f "$${folder%:*}/$${file##*/}"; done
	@rm -f '$(DESTDIR)$(LIBDIR)/libsuperframe.so'
	@rmdir '$(DESTDIR)$(PREFIX)/include/superframe' 2> /dev/null || true

# ---- Running ------------------------------------------------------------------------------------

run: $(BUILD)/superframe ## Render fig3 (or SCENE=...) to build/out/fig3.png
	@mkdir -p $(BUILD)/out
	$(BUILD)/superframe render $(SCENE) -o $(BUILD)/out/$(notdir $(basename $(SCENE))).png
	@echo "The picture is $(BUILD)/out/$(notdir $(basename $(SCENE))).png"

paper: $(BUILD)/superframe ## Make every figure of the paper, and measure its claims, in build/paper
	$(BUILD)/superframe paper -o $(BUILD)/paper --jobs 2
	@echo "The page is $(BUILD)/paper/index.html"

include firmware/targets/targets.mk
include tests/measures.mk
include tests/tests.mk

# ---- The machine --------------------------------------------------------------------------------

# The groups of setup.sh that a goal needs besides `build`, as goal=group,group.
SETUP_GROUPS := test=test,quick,usb quick=test test-kernel=test,usb,kernel fuzz=test mutants=test,usb \
    lint=lint lint-style=lint lint-cppcheck=lint lint-tidy=lint prove=prove coverage=test,coverage \
    paper=paper measure=paper bench-check=count bench-instructions-keep=count cost-check=quick \
    pc98=pc98 pc98-probe=pc98 wasm=quick targets=quick,targets size=quick,targets \
    size-keep=quick,targets minimal-table=quick
groups_of = $(subst $(comma), ,$(patsubst $(1)=%,%,$(filter $(1)=%,$(SETUP_GROUPS))))

# Whatever is compiled waits for it by an order-only prerequisite: it is looked at each time, which
# takes milliseconds, and nothing is rebuilt for it. All is installed in one go, before anything is
# compiled.
setup: ## Install what the build lacks (SETUP=no only lists it)
	@CC='$(CC)' SETUP='$(SETUP)' sh setup.sh build \
	    $(sort $(foreach goal,$(MAKECMDGOALS),$(call groups_of,$(goal))) $(if $(findstring /tests/,$(MAKECMDGOALS)),test))

clean: ## Remove everything that was built
	rm -rf $(BUILD)

# Whatever `make help` lists is no file.
.PHONY: $(shell sed -n 's/^\([a-z0-9-]*\):.*## .*/\1/p' $(MAKEFILE_LIST)) FORCE run-tests fresh-prefix \
        lint-style lint-cppcheck lint-tidy

help: ## List the targets
	@sed -n 's/^\([a-zA-Z0-9_-]*\):.*## \(.*\)/  \1\t\2/p' $(MAKEFILE_LIST) | expand -t 22

-include $(shell find $(addprefix $(BUILD)/,$(CONFIGURATIONS) library coverage adapter) -name '*.d' 2>/dev/null)
