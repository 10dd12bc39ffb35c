# SPDX-License-Identifier: MIT
# Builds, runs and tests superframe; everything that it makes goes under build/.
# `make help` lists the targets.

# make's own default, cc, may be any compiler.
ifeq ($(origin CC),default)
CC      := gcc
endif
OBJCOPY ?= objcopy
BUILD   ?= build
SCENE   ?= fig3
SETUP   ?= yes

WARNINGS := -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror
OPTIMISE ?= -O2
DEBUG    ?= -g

# Golden images: no contraction to fused multiply-add, no excess precision.
FLOATING := -ffp-contract=off

# f128 takes libquadmath and a compiler with its numbers; QUADMATH=no leaves it out.
ifndef QUADMATH
QUADMATH    := $(shell echo 'extern __float128 sqrtq(__float128); int main(int n, char **s) { return s && sqrtq(n) > 9; }' | $(CC) -x c - -o /dev/null -lquadmath 2>/dev/null && echo yes || echo no)
endif
ARITHMETICS := fx f32 f64 $(if $(filter yes,$(QUADMATH)),f128)
MISSING     := $(if $(filter yes,$(QUADMATH)),,f128)
# For `superframe measure` alone: what fx is measured against.
EXAMPLES    := q16 q16_epsilon

# A configuration is one build of everything: release for use, sanitized for the tests, fuzzed for
# the fuzzers.
CONFIGURATIONS := release sanitized fuzzed
CFLAGS_release   := $(OPTIMISE) $(DEBUG)
CFLAGS_sanitized := -O1 $(DEBUG) -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
CFLAGS_fuzzed    := -O1 $(DEBUG) -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer
LDFLAGS_release   :=
LDFLAGS_sanitized := -fsanitize=address,undefined
LDFLAGS_fuzzed    := -fsanitize=fuzzer,address,undefined

HAL_SOURCES      := $(wildcard hal/*.c) $(wildcard hal/usb/*.c)
EMULATOR_SOURCES := $(wildcard emulator/*.c)
FIRMWARE_SOURCES := $(wildcard firmware/*.c)
# Compiled once for each arithmetic beside the firmware, on the host only.
PER_ARITHMETIC_SOURCES := $(wildcard host/arithmetic/*.c)
HOST_SOURCES     := $(wildcard host/*.c)

# The ways to an adapter: a library that is not there is replaced by a file that says so.
# USB_LIBUSB=no and USB_HIDAPI=no leave it out; USB_HIDAPI=hidapi-libusb takes the other flavour.
USB_LIBUSB ?= libusb-1.0
USB_HIDAPI ?= hidapi-hidraw
ifneq ($(filter test test-kernel,$(MAKECMDGOALS)),)
# The tests speak to the real libraries: they must be there before it is asked which are.
setup_of_usb := $(shell CC='$(CC)' SETUP='$(SETUP)' sh setup.sh usb >&2)
endif
has_package = $(shell pkg-config --exists '$(1)' 2>/dev/null && echo yes)
USB_PACKAGES := $(foreach package,$(USB_LIBUSB) $(USB_HIDAPI),$(if $(call has_package,$(package)),$(package)))
HOST_SOURCES += $(if $(filter libusb%,$(USB_PACKAGES)),$(wildcard host/usb/libusb*.c),host/usb/no_libusb.c) \
                $(if $(filter hidapi%,$(USB_PACKAGES)),host/usb/hidapi.c,host/usb/no_hidapi.c)
USB_CFLAGS := $(if $(USB_PACKAGES),$(subst -I,-isystem ,$(shell pkg-config --cflags-only-I $(USB_PACKAGES))))
USB_LIBS   := $(if $(USB_PACKAGES),$(shell pkg-config --libs $(USB_PACKAGES)))

# The CPU of `superframe boot`; BOOT_UNICORN=no leaves it out. Goals that need it install it before
# make asks whether it is there.
BOOT_UNICORN ?= unicorn
ifneq ($(filter test targets size size-keep,$(MAKECMDGOALS)),)
BOOT_SETUP   := $(shell CC='$(CC)' SETUP='$(SETUP)' sh setup.sh quick >&2)
endif
BOOT_PACKAGE := $(if $(call has_package,$(BOOT_UNICORN)),$(BOOT_UNICORN))
HOST_SOURCES += $(if $(BOOT_PACKAGE),host/processor/unicorn.c host/processor/unicorn_library.c,host/processor/no_unicorn.c)
# It is loaded when a floppy is booted, not linked: see host/processor/unicorn_library.h.
BOOT_LIBS    := $(if $(BOOT_PACKAGE),-ldl)
# Streams of rays, for the arithmetics that CPUs have in vectors: the sets of instructions that are
# compiled for, one of which is taken at run time.
STREAM_REALS   := f32 f64 fx
# fx as it suits vectors: the same bits.
STREAM_REAL_f32 := f32
STREAM_REAL_f64 := f64
STREAM_REAL_fx  := fx_vector
ifneq ($(filter x86_64%,$(shell $(CC) -dumpmachine)),)
STREAM_SETS    := plain avx2 avx512
HOST_SOURCES   += host/engines/x86_64.c
else
STREAM_SETS    := plain
HOST_SOURCES   += host/engines/portable.c
endif
STREAM_SOURCES := $(wildcard host/stream/*.c) firmware/solids.c
# Nothing here changes a result: no trap is waited for, no errno is read, no infinity is made in a
# lane that counts (strict/real.h), and no sign of a zero is asked for.
# No operand is to be skipped: in lanes, & is what && is elsewhere.
STREAM_FLAGS   := -O3 -fno-trapping-math -fno-math-errno -ffinite-math-only -fno-signed-zeros -Wno-bitwise-instead-of-logical
# Two of gcc's passes make branches in loops that are to be vectors: they thread jumps through
# choices that hang together, and, in some files, look for partial redundancies. A third calls memcpy
# for loops that are too short for it.
ifeq ($(findstring clang,$(shell $(CC) --version)),)
STREAM_FLAGS   += -fno-thread-jumps -fno-tree-loop-distribute-patterns
STREAM_FLAGS_search_solids   := -fno-tree-pre
STREAM_FLAGS_search_quadrics := -fno-tree-pre
STREAM_FLAGS_borders         := -fno-tree-pre
endif
FLAGS_plain    :=
FLAGS_avx2     := -march=x86-64-v3
FLAGS_avx512   := -march=x86-64-v4 -mprefer-vector-width=512
TEST_SOURCES     := $(wildcard tests/*_test.c)
REAL_TEST_SOURCES := $(wildcard tests/real/*_test.c)
SCENE_FILES      := $(wildcard firmware/scenes/*.scene)

INCLUDE_hal      := -Ihal -Ihal/usb
INCLUDE_emulator := -Ihal -Ihal/usb -Iemulator
INCLUDE_firmware := -Ihal -Ifirmware
INCLUDE_host     := -Ihal -Ihal/usb -Iemulator -Ifirmware -Ihost
INCLUDE_tests    := -Ihal -Ihal/usb -Iemulator -Ifirmware -Ihost -Itests

# Where gcc keeps quadmath.h: clang links gcc's library but does not look among its headers.
COMPILER_HEADERS = $(dir $(shell $(CC) -print-file-name=include/quadmath.h))

# Files of more than 2 GiB where long has 32 bits.
POSIX   := -D_POSIX_C_SOURCE=200809L -D_FILE_OFFSET_BITS=64
LIBS    := -lpng -lconfig -lxxhash -ldeflate $(if $(filter yes,$(QUADMATH)),-lquadmath) -lm -lpthread $(USB_LIBS) $(BOOT_LIBS)

.PHONY: all
all: $(BUILD)/superframe ## Build the program (the default)

$(BUILD)/superframe: $(BUILD)/release/superframe
	@cp $< $@.new && mv -f $@.new $@

.DELETE_ON_ERROR:
.SECONDARY:

# Compiler and flags of the last build: when they change, everything is compiled again.
$(BUILD)/flags: FORCE | setup
	@mkdir -p $(@D)
	@echo '$(subst ','\'',$(CC) $(WARNINGS) $(FLOATING) $(foreach configuration,$(CONFIGURATIONS),$(CFLAGS_$(configuration))) $(STREAM_FLAGS) $(STREAM_FLAGS_borders) $(FLAGS_avx2) $(FLAGS_avx512))' > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# The list of sources: when a file goes away, what was linked from it is linked again.
$(BUILD)/sources: FORCE
	@mkdir -p $(@D)
	@echo $(HAL_SOURCES) $(EMULATOR_SOURCES) $(FIRMWARE_SOURCES) $(PER_ARITHMETIC_SOURCES) $(HOST_SOURCES) > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

.PHONY: FORCE
FORCE:

# ---- One set of rules for each configuration ------------------------------------------------

define configuration_rules
$(1)_HAL      := $$(HAL_SOURCES:%.c=$$(BUILD)/$(1)/%.o)
$(1)_EMULATOR := $$(EMULATOR_SOURCES:%.c=$$(BUILD)/$(1)/%.o)
$(1)_HOST     := $$(filter-out %/host/main.o,$$(HOST_SOURCES:%.c=$$(BUILD)/$(1)/%.o))
$(1)_SCENES   := $$(BUILD)/$(1)/builtin_scenes.o
$(1)_IMAGES   := $$(patsubst %,$$(BUILD)/$(1)/image_%.o,$$(ARITHMETICS) $$(EXAMPLES)) $$(BUILD)/$(1)/arithmetics.o
$(1)_STREAMS  := $$(foreach real,$$(STREAM_REALS),$$(STREAM_SETS:%=$$(BUILD)/$(1)/stream_$$(real)_%.o))
$(1)_LIBRARY  := $$($(1)_STREAMS) $$($(1)_HAL) $$($(1)_EMULATOR) $$($(1)_HOST) $$($(1)_IMAGES) $$($(1)_SCENES)

$$(BUILD)/$(1)/hal/%.o: hal/%.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(POSIX) $$(CFLAGS_$(1)) $$(INCLUDE_hal) -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/emulator/%.o: emulator/%.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(POSIX) $$(CFLAGS_$(1)) $$(INCLUDE_emulator) -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/host/%.o: host/%.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(POSIX) $$(CFLAGS_$(1)) $$(INCLUDE_host) $$(USB_CFLAGS) -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/builtin_scenes.o: $$(BUILD)/builtin_scenes.c host/builtin_scenes.h $$(BUILD)/flags
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(CFLAGS_$(1)) -Ihost -c -o $$@ $$<

$$(BUILD)/$(1)/arithmetics.o $$(BUILD)/$(1)/arithmetics_without_f128.o: $$(BUILD)/$(1)/%.o: $$(BUILD)/%.c $$(BUILD)/flags
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(CFLAGS_$(1)) -Ifirmware -Ihost -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/superframe: $$(BUILD)/$(1)/host/main.o $$($(1)_LIBRARY) $$(BUILD)/sources
	$$(CC) $$(LDFLAGS_$(1)) -o $$@ $$(filter %.o,$$^) $$(LIBS)

$$(foreach arithmetic,$$(ARITHMETICS) $$(EXAMPLES),$$(eval $$(call image_rules,$(1),$$(arithmetic))))
$$(foreach real,$$(STREAM_REALS),$$(foreach set,$$(STREAM_SETS),$$(eval $$(call stream_rules,$(1),$$(real),$$(set)))))
endef

# One stream engine: one arithmetic and one set of instructions, both chosen by the include path.
define stream_rules
$$(BUILD)/$(1)/stream/$(2)_$(3)/%.o: %.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(FLOATING) $$(CFLAGS_$(1)) $$(STREAM_FLAGS) $$(STREAM_FLAGS_$$(*F)) $$(FLAGS_$(3)) -Ifirmware/real/$$(STREAM_REAL_$(2)) -Ihost/stream/sets/$(3) -Ifirmware/features/full $$(INCLUDE_host) -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/stream_$(2)_$(3).o: $$(STREAM_SOURCES:%.c=$$(BUILD)/$(1)/stream/$(2)_$(3)/%.o) $$(BUILD)/sources
	$$(CC) -r -nostdlib -o $$@ $$(filter %.o,$$^)
	$$(OBJCOPY) --keep-global-symbol=stream_$(2)_$(3) $$@
endef

# One image of the firmware: one arithmetic, chosen by the include path; one symbol leaves it.
define image_rules
$(1)_$(2)_OBJECTS := $$(FIRMWARE_SOURCES:%.c=$$(BUILD)/$(1)/$(2)/%.o) \
                     $$(PER_ARITHMETIC_SOURCES:%.c=$$(BUILD)/$(1)/$(2)/%.o)

$$(BUILD)/$(1)/$(2)/firmware/%.o: firmware/%.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) -ffreestanding $$(FLOATING) $$(CFLAGS_$(1)) -Ifirmware/real/$(2) -Ifirmware/features/full $$(INCLUDE_firmware) -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/$(2)/host/%.o: host/%.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(FLOATING) $$(CFLAGS_$(1)) -Ifirmware/real/$(2) -Ifirmware/features/full $$(INCLUDE_host) -MMD -MP -c -o $$@ $$<

$$(BUILD)/$(1)/image_$(2).o: $$($(1)_$(2)_OBJECTS) $$(BUILD)/sources
	$$(CC) -r -nostdlib -o $$@ $$(filter %.o,$$^)
	$$(OBJCOPY) --keep-global-symbol=arithmetic_$(2) $$@

# The firmware without what the host adds to it: tests/check_symbols.sh reads this.
$$(BUILD)/$(1)/firmware_$(2).o: $$(FIRMWARE_SOURCES:%.c=$$(BUILD)/$(1)/$(2)/%.o) $$(BUILD)/sources
	$$(CC) -r -nostdlib -o $$@ $$(filter %.o,$$^)
endef

$(foreach configuration,$(CONFIGURATIONS),$(eval $(call configuration_rules,$(configuration))))

# The built-in scenes' texts, as byte arrays.
$(BUILD)/builtin_scenes.c: host/embed_scenes.sh $(SCENE_FILES)
	@mkdir -p $(@D)
	sh host/embed_scenes.sh $(SCENE_FILES) > $@.tmp && mv $@.tmp $@

# The arithmetics of this build.
$(BUILD)/arithmetics.c: host/list_arithmetics.sh FORCE
	@mkdir -p $(@D)
	@sh host/list_arithmetics.sh $(ARITHMETICS) -- $(MISSING) > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

# ---- Without libquadmath: f128 is left out ----------------------------------------------------

$(BUILD)/arithmetics_without_f128.c: host/list_arithmetics.sh
	@mkdir -p $(@D)
	sh host/list_arithmetics.sh $(filter-out f128,$(ARITHMETICS)) -- f128 > $@

WITHOUT_F128 := $(filter-out %/arithmetics.o %/image_f128.o,$(release_LIBRARY)) $(BUILD)/release/host/main.o \
                $(BUILD)/release/arithmetics_without_f128.o

$(BUILD)/superframe_without_f128: $(WITHOUT_F128) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(filter-out -lquadmath,$(LIBS))

# ---- The library, and what is measured of it ------------------------------------------------

include install.mk
include firmware/targets/targets.mk
include usb.mk
include tests/fuzz/fuzz.mk
include tests/measures.mk
include tests/cost/cost.mk
include tests/proofs/proofs.mk
include tests/relations/relations.mk
include tests/pov/pov.mk
include tests/bench/bench.mk
include tests/accuracy/accuracy.mk

# ---- Running --------------------------------------------------------------------------------

.PHONY: run
run: $(BUILD)/superframe ## Render fig3 (or SCENE=...) to build/out/fig3.png
	@mkdir -p $(BUILD)/out
	$(BUILD)/superframe render $(SCENE) -o $(BUILD)/out/$(notdir $(basename $(SCENE))).png
	@echo "The picture is $(BUILD)/out/$(notdir $(basename $(SCENE))).png"

.PHONY: paper
paper: $(BUILD)/superframe ## Make every figure of the paper, and measure its claims, in build/paper
	$(BUILD)/superframe paper -o $(BUILD)/paper --jobs 2
	@echo "The page is $(BUILD)/paper/index.html"

# ---- Testing --------------------------------------------------------------------------------

# The suites that hold something against f128; those of tests/real/ are held against libquadmath.
SUITES_OF_F128 := $(patsubst %,tests/%_test.c,accuracy command extremes_optics extremes_place extremes_shapes extremes_walls leak optics_laws tail worked_example)
ifneq ($(QUADMATH),yes)
TEST_SKIPPED := $(SUITES_OF_F128) $(REAL_TEST_SOURCES)
TEST_SOURCES := $(filter-out $(TEST_SKIPPED),$(TEST_SOURCES))
REAL_TEST_SOURCES :=
endif
TEST_PROGRAMS := $(TEST_SOURCES:tests/%.c=$(BUILD)/sanitized/tests/%)
REAL_TEST_PROGRAMS := $(foreach arithmetic,$(ARITHMETICS),$(REAL_TEST_SOURCES:tests/real/%.c=$(BUILD)/sanitized/tests/real/%_$(arithmetic)))

$(BUILD)/sanitized/tests/%_test.o: tests/%_test.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_sanitized) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(TEST_PROGRAMS): %: %.o $(sanitized_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_sanitized) -o $@ $(filter %.o,$^) -lcmocka $(LIBS)

# The test kit is no part of the program: its own suites alone are linked with it.
TESTKIT_TESTS := $(BUILD)/sanitized/tests/testkit_test $(BUILD)/sanitized/tests/testkit_writes_test
$(BUILD)/sanitized/emulator/testing/%.o: emulator/testing/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_sanitized) $(INCLUDE_testkit) -MMD -MP -c -o $@ $<
$(TESTKIT_TESTS:%=%.o): INCLUDE_tests += -Iemulator/testing
$(TESTKIT_TESTS): $(TESTKIT_SOURCES:%.c=$(BUILD)/sanitized/%.o)

define real_test_rules
$$(BUILD)/sanitized/tests/real/%_test_$(1).o: tests/real/%_test.c $$(BUILD)/flags | setup
	@mkdir -p $$(@D)
	$$(CC) $$(WARNINGS) $$(POSIX) $$(FLOATING) $$(CFLAGS_sanitized) -Ifirmware/real/$(1) $$(INCLUDE_tests) -Itests/real -idirafter $$(COMPILER_HEADERS) -MMD -MP -c -o $$@ $$<

$$(BUILD)/sanitized/tests/real/%_test_$(1): $$(BUILD)/sanitized/tests/real/%_test_$(1).o
	$$(CC) $$(LDFLAGS_sanitized) -o $$@ $$< -lcmocka $$(LIBS)
endef
$(foreach arithmetic,$(ARITHMETICS),$(eval $(call real_test_rules,$(arithmetic))))

FIRMWARE_IMAGES := $(BUILD)/release/firmware_fx.o $(BUILD)/release/firmware_f32.o $(BUILD)/release/firmware_f64.o
TEST_SCRIPTS := tests/float_matrix.sh \
                tests/trace_hash_matrix.sh \
                tests/check_includes.sh \
                tests/check_symbols.sh \
                tests/check_recursion.sh \
                tests/check_adapter.sh \
                tests/check_fuzz.sh \
                tests/check_usb_bytes.sh \
                tests/check_without_usb.sh \
                tests/check_without_f128.sh \
                tests/check_install.sh \
                tests/check_measure.sh \
                tests/targets/quick_test.sh \
                tests/targets/minimal_test.sh \
                tests/targets/probe_test.sh \
                tests/check_porting.sh \
                tests/check_32_bits.sh \
                tests/check_bench.sh \
                tests/check_manual.sh \
                tests/check_hashes.sh \
                tests/check_uninitialised.sh \
                tests/check_mutants.sh \
                tests/relations/relations_test.sh

.PHONY: test
test: $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(BUILD)/superframe $(BUILD)/sanitized/superframe $(FIRMWARE_IMAGES) strict fresh-prefix $(BUILD)/usb_bytes $(BUILD)/superframe_without_usb $(BUILD)/superframe_without_f128 $(USB_TEST_PROGRAMS) $(BENCH_TOOLS) $(FUZZERS) $(RELATIONS) ## Run every test (under the address and undefined-behaviour sanitizers)
	@$(if $(TEST_SKIPPED),echo 'skipped without libquadmath: $(TEST_SKIPPED)')
	@sh tests/run.sh $(BUILD) $(TEST_SCRIPTS) $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS)

# ---- Measuring ------------------------------------------------------------------------------

$(BUILD)/release/accuracy: $(BUILD)/release/tests/accuracy/accuracy.o $(release_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)

# Pictures in f128 take minutes: they are kept for as long as the image that made them.
$(BUILD)/accuracy/made_by: $(BUILD)/release/image_f128.o
	@rm -rf $(@D) && mkdir -p $(@D) && touch $@

.PHONY: accuracy
accuracy: $(BUILD)/release/accuracy $(BUILD)/accuracy/made_by ## Whole frames of every built-in scene against f128 (SCENES=... for some)
	$< $(BUILD)/accuracy $(SCENES)

# ---- Checks that run nothing ----------------------------------------------------------------

.PHONY: strict
strict: | setup ## Compile the firmware with one opaque type for each role: no raw arithmetic passes
	$(CC) $(WARNINGS) -ffreestanding -Ifirmware/real/strict -Ifirmware/features/full $(INCLUDE_firmware) -fsyntax-only $(FIRMWARE_SOURCES)

# Everything is read as it is compiled; the firmware in fixed and in floating point, where the ranges
# of divisors are proved in comments, which the analyser can't read.
TIDY := clang-tidy --quiet
.PHONY: lint lint-style lint-cppcheck lint-tidy
lint: lint-style lint-cppcheck lint-tidy ## Read the source with clang-tidy and cppcheck, and check its style

lint-style: | setup
	@sh tests/check_style.sh

lint-cppcheck: | setup
	cppcheck --quiet --std=c99 --enable=warning,performance,portability --suppressions-list=tests/cppcheck_suppressions.txt --error-exitcode=1 $(INCLUDE_host) -Ifirmware/real/fx -Ifirmware/features/full -Iemulator/testing hal emulator host firmware

lint-tidy: | setup
	@printf '%s\n' $(HAL_SOURCES) $(EMULATOR_SOURCES) $(HOST_SOURCES) $(TESTKIT_SOURCES) | xargs -P 2 -n 8 sh -c '$(TIDY) "$$@" -- -std=c99 $(POSIX) $(INCLUDE_host) $(USB_CFLAGS) -Iemulator/testing' tidy
	@printf '%s\n' fx f64 | xargs -P 2 -I % $(TIDY) --checks=-clang-analyzer-core.DivideZero $(FIRMWARE_SOURCES) $(PER_ARITHMETIC_SOURCES) -- -std=c99 -Ifirmware/real/% -Ifirmware/features/full $(INCLUDE_host)
	@printf '%s\n' fx_vector f64 | xargs -P 2 -I % $(TIDY) --checks=-clang-analyzer-core.DivideZero $(wildcard host/stream/*.c) -- -std=c99 -Ifirmware/real/% -Ihost/stream/sets/plain -Ifirmware/features/full $(INCLUDE_host)

# ---- The machine ----------------------------------------------------------------------------

# The groups of setup.sh that a goal needs, besides `build`. All are installed in one go, before
# anything is compiled.
SETUP_FOR_test := test quick
SETUP_FOR_test-kernel := test usb kernel
SETUP_FOR_lint := lint
SETUP_FOR_paper := paper
SETUP_FOR_measure := paper
SETUP_FOR_library := test
SETUP_FOR_install := test
SETUP_FOR_coverage := test coverage
SETUP_FOR_fuzz := test
SETUP_FOR_mutants := test
SETUP_FOR_lint-style := lint
SETUP_FOR_lint-cppcheck := lint
SETUP_FOR_lint-tidy := lint
SETUP_GROUPS   := $(sort build $(foreach goal,$(MAKECMDGOALS),$(SETUP_FOR_$(goal))) \
                         $(if $(findstring /tests/,$(MAKECMDGOALS)),test))

# Whatever is compiled waits for it by an order-only prerequisite: it is looked at each time, which
# takes milliseconds, and nothing is rebuilt for it.
.PHONY: setup
setup: ## Install what the build lacks (SETUP=no only lists it)
	@CC='$(CC)' SETUP='$(SETUP)' sh setup.sh $(SETUP_GROUPS)

.PHONY: clean
clean: ## Remove everything that was built
	rm -rf $(BUILD)

.PHONY: help
help: ## List the targets
	@sed -n 's/^\([a-zA-Z0-9_-]*\):.*## \(.*\)/  \1\t\2/p' $(MAKEFILE_LIST) | expand -t 22

-include $(shell find $(CONFIGURATIONS:%=$(BUILD)/%) -name '*.d' 2>/dev/null)
