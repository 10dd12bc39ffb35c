# SPDX-License-Identifier: MIT
# What holds the program to what it should be; read by Makefile.

# ---- Suites -------------------------------------------------------------------------------------

# The suites that hold something against f128; those of tests/real/ are held against libquadmath.
SUITES_OF_F128 := program/command $(addprefix laws/,accuracy extremes_optics extremes_place extremes_shapes \
                  extremes_walls leak optics_laws tail worked_example)
# unit/ mirrors the folders of the source; laws/ holds what rays and pictures obey, program/ the command.
SUITES      := $(patsubst tests/%.c,%,$(wildcard $(patsubst %,tests/%/*_test.c,unit/* unit/host/* laws program)))
REAL_SUITES := $(patsubst tests/%.c,%,$(wildcard tests/real/*_test.c))
ifneq ($(QUADMATH),yes)
TEST_SKIPPED := $(SUITES_OF_F128:%=%_test) $(REAL_SUITES)
SUITES       := $(filter-out $(TEST_SKIPPED),$(SUITES))
REAL_SUITES  :=
endif
TEST_PROGRAMS := $(SUITES:%=$(BUILD)/sanitized/tests/%)
REAL_TEST_PROGRAMS := $(foreach arithmetic,$(ARITHMETICS),$(REAL_SUITES:%=$(BUILD)/sanitized/tests/%_$(arithmetic)))

$(TEST_PROGRAMS): %: %.o $(sanitized_LIBRARY) $(BUILD)/sources
	$(call link,$(LDFLAGS_sanitized),-lcmocka $(LIBS))

# The test kit is no part of the program: its own suites alone are linked with it.
$(patsubst %,$(BUILD)/sanitized/tests/unit/emulator/%_test,testkit testkit_writes): $(TESTKIT_SOURCES:%.c=$(BUILD)/sanitized/%.o)

define real_suites
$$(BUILD)/sanitized/tests/real/%_test_$(1).o: tests/real/%_test.c $$(BUILD)/flags | setup
	$$(call compile,$$(POSIX) $$(FLOATING) $$(CFLAGS_sanitized) -Ifirmware/real/$(1) $$(INCLUDE_tests) -Itests/real)

$$(BUILD)/sanitized/tests/real/%_test_$(1): $$(BUILD)/sanitized/tests/real/%_test_$(1).o
	$$(call link,$$(LDFLAGS_sanitized),-lcmocka $$(LIBS))
endef
$(foreach arithmetic,$(ARITHMETICS),$(eval $(call real_suites,$(arithmetic))))

# The real libraries against an emulated kernel, once with each flavour of hidapi. Not the whole
# program: libunicorn, where it is linked, has functions of GLib's names.
USB_FLAVOURS := $(if $(filter 2,$(words $(USB_PACKAGES))),$(if $(call has_package,umockdev-1.0),hidapi-hidraw hidapi-libusb))
USB_TEST_PROGRAMS := $(USB_FLAVOURS:%=$(BUILD)/sanitized/tests/usb/%_test)
UMOCKDEV_LIBS   := $(if $(USB_FLAVOURS),$(shell pkg-config --libs umockdev-1.0))
FLAGS_tests/usb := -D_DEFAULT_SOURCE \
                   $(if $(USB_FLAVOURS),$(subst -I,-isystem ,$(shell pkg-config --cflags-only-I umockdev-1.0)))
USB_TEST_SOURCES := $(wildcard tests/usb/*.c emulator/board/*.c) emulator/picture/picture.c \
                    emulator/picture/native_screen.c host/adapter/driver_bulk.c host/adapter/driver_hid.c \
                    $(patsubst %,host/adapter/%.c,bus drivers session verify)

$(USB_TEST_PROGRAMS): $(BUILD)/sanitized/tests/usb/%_test: $(USB_TEST_SOURCES:%.c=$(BUILD)/sanitized/%.o) $(sanitized_HAL)
	$(call link,$(LDFLAGS_sanitized),-lcmocka -lusb-1.0 -l$* $(UMOCKDEV_LIBS) -ldeflate -lpthread)

# ---- Programs without something -----------------------------------------------------------------

WITHOUT_USB  := $(filter-out %/driver_bulk.o %/driver_hid.o %/lists/usb_backends.o,$(release_LIBRARY)) \
                $(BUILD)/release/host/command/main.o $(BUILD)/release/lists_without/usb_backends.o
WITHOUT_F128 := $(filter-out %/lists/arithmetics.o %/image_f128.o,$(release_LIBRARY)) \
                $(BUILD)/release/host/command/main.o $(BUILD)/release/lists_without/arithmetics.o

$(BUILD)/superframe_without_usb: $(WITHOUT_USB) $(BUILD)/sources
	$(call link,,$(filter-out $(USB_LIBS),$(LIBS)))

$(BUILD)/superframe_without_f128: $(WITHOUT_F128) $(BUILD)/sources
	$(call link,,$(filter-out -lquadmath,$(LIBS)))

$(LISTS:%=$(BUILD)/lists_without/%.c): $(BUILD)/lists_without/%.c: host/base/list.sh
	@mkdir -p $(@D)
	@sh $< $* $(filter-out f128 bulk hid,$(LIST_$*)) > $@

# ---- Fuzzers, relations, POV-Ray ----------------------------------------------------------------

# Only clang brings libFuzzer, whatever compiler the caller has chosen.
$(BUILD)/fuzzed/%: private override CC := clang

# A fuzzer takes from this library what it calls. A processor needs Unicorn.
FUZZED_HOST    := $(filter $(patsubst %,host/%/%.c,base scene compiler adapter) host/boot/%,$(HOST_SOURCES))
FUZZED_OBJECTS := $(fuzzed_HAL) $(fuzzed_EMULATOR) $(FUZZED_HOST:%.c=$(BUILD)/fuzzed/%.o) \
                  $(patsubst %,$(BUILD)/fuzzed/%.o,image_fx image_f32 builtin_scenes lists/processors)
FUZZERS := $(patsubst tests/fuzz/%.c,$(BUILD)/fuzzed/%,$(wildcard tests/fuzz/*_fuzz.c))
FUZZERS := $(if $(BOOT_PACKAGE),$(FUZZERS),$(filter-out %/boot_fuzz,$(FUZZERS)))

$(BUILD)/fuzzed/library.a: $(FUZZED_OBJECTS) $(BUILD)/sources
	$(call say,AR)
	@rm -f $@
	$(Q)$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/fuzzed/scene_fuzz: $(BUILD)/fuzzed/tests/fuzz/scene_mutator.o
$(FUZZERS): $(BUILD)/fuzzed/%: $(BUILD)/fuzzed/tests/fuzz/%.o $(BUILD)/fuzzed/library.a
	$(call link,$(LDFLAGS_fuzzed),$(LIBS))

RELATIONS := $(BUILD)/release/relations/relations
$(eval $(call tool,release/relations/relations,$(wildcard tests/relations/*.c)))
FLAGS_tests/relations := -Itests/relations
$(eval $(call tool,release/tests/pov/pov_check,tests/pov/pov_check.c))
# Generated scenes that are held against POV-Ray, beside those of the table in check.sh.
GENERATED ?= 100

fuzz: $(FUZZERS) ## Fuzz each reader of foreign bytes for SECONDS=600, or FUZZER=scene alone
	@BUILD=$(BUILD) sh tests/check_fuzz.sh $(or $(SECONDS),600) $(FUZZER)

relations: $(RELATIONS) ## Hold relations on generated scenes (SEEDS=A:B, RELATION=name, SECONDS=limit)
	@$(RELATIONS) $(BUILD)/relations SEEDS=$(or $(SEEDS),0:300) SECONDS=$(or $(SECONDS),3600) $(RELATION:%=RELATION=%)

# Where povray is not there and can't be installed, the check says so and is skipped.
pov: $(BUILD)/release/tests/pov/pov_check $(BUILD)/superframe $(RELATIONS) ## Hold exported scenes against POV-Ray: pictures and ray counts
	@CC='$(CC)' SETUP='$(SETUP)' sh setup.sh pov || true
	@sh tests/pov/check.sh $(BUILD)
	@sh tests/pov/generated.sh $(BUILD) $(GENERATED)

# ---- All of them --------------------------------------------------------------------------------

TEST_SCRIPTS := $(addprefix tests/,float_matrix.sh trace_hash_matrix.sh check_includes.sh check_cycles.sh check_paths.sh check_changing.sh check_symbols.sh \
    check_recursion.sh check_adapter.sh check_fuzz.sh check_usb_bytes.sh check_without_usb.sh \
    check_without_f128.sh check_install.sh check_measure.sh targets/quick_test.sh targets/minimal_test.sh \
    targets/probe_test.sh check_porting.sh check_32_bits.sh check_bench.sh check_manual.sh check_scene_page.sh check_completion.sh check_hashes.sh \
    check_uninitialised.sh check_mutants.sh relations/relations_test.sh)
FIRMWARE_IMAGES := $(patsubst %,$(BUILD)/release/firmware_%.o,fx f32 f64)
# `make quick` leaves these to `make test`: each takes more than two seconds.
SLOW_SUITES := program/command program/trace_command unit/host/lab/measure% unit/host/lab/paper% \
    unit/host/stream/stream unit/host/validate/validate unit/firmware/usb_% unit/host/adapter/usb_% unit/hal/usb_% \
    $(addprefix unit/host/compiler/,compiled_points coincident_surfaces dead_things fused_solids) \
    $(addprefix unit/host/render/,ray_tree render_counts) \
    $(addprefix laws/,accuracy asked_error csg_laws extremes_% leak patterns tail)

# The packages first: which of them are there decides what is built.
test: setup ## Run every test (under the address and undefined-behaviour sanitizers)
	@$(MAKE) --no-print-directory run-tests

run-tests: $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS) $(BUILD)/superframe \
    $(BUILD)/sanitized/superframe $(FIRMWARE_IMAGES) strict fresh-prefix $(BUILD)/usb_bytes \
    $(BUILD)/superframe_without_usb $(BUILD)/superframe_without_f128 $(BENCH_TOOLS) $(FUZZERS) $(RELATIONS)
	@$(if $(TEST_SKIPPED),echo 'skipped without libquadmath: $(TEST_SKIPPED)')
	@$(if $(USB_FLAVOURS),,echo 'skipped without libusb, both hidapi and umockdev: tests/usb')
	@$(if $(BOOT_PACKAGE),,echo 'skipped without Unicorn: boot_fuzz')
	@sh tests/run.sh $(BUILD) $(TEST_SCRIPTS) $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS)

QUICK_PROGRAMS := $(filter-out $(SLOW_SUITES:%=$(BUILD)/sanitized/tests/%_test),$(TEST_PROGRAMS))
quick: $(QUICK_PROGRAMS) $(BUILD)/superframe $(BUILD)/sanitized/superframe strict ## Run what is quick of the tests
	@sh tests/run.sh $(BUILD) tests/check_includes.sh tests/check_hashes.sh $(QUICK_PROGRAMS)

# Where tests/check_install.sh builds the examples: nothing of an earlier install is left in it.
fresh-prefix: $(BUILD)/superframe $(LIBRARIES)
	@rm -rf $(BUILD)/prefix
	@$(MAKE) --no-print-directory -s install PREFIX='$(abspath $(BUILD))/prefix' DESTDIR=

strict: | setup ## Compile the firmware with one opaque type for each role: no raw arithmetic passes
	$(Q)$(CC) $(WARNINGS) -ffreestanding -Ifirmware/real/strict -Ifirmware/features/full $(INCLUDE_firmware) \
	    -fsyntax-only $(FIRMWARE_SOURCES)

# ---- Read, not run ------------------------------------------------------------------------------

# Everything is read as it is compiled; the firmware in fixed and in floating point, where the ranges
# of divisors are proved in comments, which the analyser can't read.
TIDY := clang-tidy --quiet
TIDY_FULL := -Ifirmware/features/full $(INCLUDE_host)
lint: lint-style lint-cppcheck lint-tidy ## Read the source with clang-tidy and cppcheck, and check its style

lint-style: | setup
	@sh tests/check_style.sh
	@sh tests/check_english.sh

lint-cppcheck: | setup
	cppcheck --quiet --std=c99 --enable=warning,performance,portability --error-exitcode=1 \
	    --suppressions-list=tests/cppcheck_suppressions.txt $(INCLUDE_host) -Ifirmware/real/fx \
	    -Ifirmware/features/full -Iemulator/testing hal emulator host firmware

lint-tidy: | setup
	@printf '%s\n' $(HAL_SOURCES) $(ADAPTER_SOURCES) $(EMULATOR_SOURCES) $(HOST_SOURCES) $(TESTKIT_SOURCES) | \
	    xargs -P 2 -n 8 sh -c '$(TIDY) "$$@" -- -std=c99 $(POSIX) $(INCLUDE_host) -Iemulator/testing' tidy
	@printf '%s\n' fx f64 | xargs -P 2 -I % $(TIDY) --checks=-clang-analyzer-core.DivideZero \
	    $(FIRMWARE_SOURCES) $(PER_ARITHMETIC_SOURCES) -- -std=c99 -Ifirmware/real/% $(TIDY_FULL)
	@printf '%s\n' fx_vector f64 | xargs -P 2 -I % $(TIDY) --checks=-clang-analyzer-core.DivideZero \
	    $(wildcard host/stream/*.c) -- -std=c99 -Ifirmware/real/% -Ihost/stream/sets/plain $(TIDY_FULL)

# ---- Proofs -------------------------------------------------------------------------------------

# Every PROOF_STEP-th argument is tried (a power of two to 65536): 1 is a proof, more is a sample.
PROOF_STEP ?= 1
PROOF_FLAGS := -O3 -Ifirmware/real/fx $(INCLUDE_firmware)

# Undefined behaviour in root and reciprocal, which Eva takes as given, ends the trial.
$(BUILD)/proofs/root_exhaustive: tests/real/root_exhaustive.c $(wildcard firmware/real/fixed*.h) | setup
	$(call link,$(WARNINGS) $(PROOF_FLAGS) -fsanitize=undefined -fno-sanitize-recover=all,-lpthread)

$(BUILD)/proofs/exponential_exhaustive: tests/proofs/exponential_exhaustive.c $(wildcard firmware/real/fixed*.h) | setup
	$(call link,$(WARNINGS) $(PROOF_FLAGS) -idirafter $(COMPILER_HEADERS),-lquadmath -lpthread)

prove: $(BUILD)/proofs/root_exhaustive $(BUILD)/proofs/exponential_exhaustive ## Prove ranges and errors of fixed point (Frama-C, Gappa, exhaustive trial), and the adapter's answers
	sh tests/proofs/ranges.sh $(BUILD)/proofs/ranges
	sh tests/proofs/bounds.sh
	sh tests/proofs/usb_requests.sh $(BUILD)/proofs
	timeout -k 5 600 $(BUILD)/proofs/exponential_exhaustive 2 $(PROOF_STEP)
	timeout -k 5 900 $(BUILD)/proofs/root_exhaustive 2 $(PROOF_STEP)

# ---- The adapter, and the real kernel -----------------------------------------------------------

# No system, no heap, no library but the compiler's own. clang makes code for any machine and has the
# freestanding headers; gcc needs its cross compiler.
ADAPTER_CC ?= $(if $(shell command -v arm-none-eabi-gcc 2>/dev/null),arm-none-eabi-gcc,clang --target=thumbv6m-none-eabi)
ADAPTER_OBJECTS := $(patsubst %.c,$(BUILD)/adapter/%.o,$(ADAPTER_SOURCES) hal/cable/usb_ops.c hal/cable/usb_wire.c hal/bus.c)

$(BUILD)/adapter/%.o: private CC := $(ADAPTER_CC)
$(BUILD)/adapter/%.o: %.c $(BUILD)/flags
	$(call compile,-ffreestanding -mcpu=cortex-m0plus -mthumb -Os $(INCLUDE_firmware) -Ifirmware/adapter)

KERNEL_TEST := $(BUILD)/kernel

adapter: $(ADAPTER_OBJECTS) ## Compile the adapter's device logic for a Cortex-M0+, with its size
	sh tests/check_adapter.sh $^

test-kernel: setup ## Draw over USB and HID through the real Linux USB stack, as an ordinary user
	@$(MAKE) --no-print-directory $(BUILD)/superframe $(BUILD)/sanitized/superframe $(LIBRARIES)
	@sh tests/kernel/fetch.sh $(KERNEL_TEST)/debian
	@$(MAKE) --no-print-directory -s install PREFIX=/usr/local DESTDIR='$(abspath $(KERNEL_TEST))/installed'
	@sh tests/kernel/initramfs.sh $(KERNEL_TEST)/debian/system $(KERNEL_TEST)/installed $(KERNEL_TEST)/guest
	@sh tests/kernel/run.sh $(KERNEL_TEST)/guest $(BUILD)/sanitized/superframe $(BUILD)/superframe

# ---- Mutants, coverage --------------------------------------------------------------------------

# Besides the suites, whatever tells by its exit status: release/x,1,2 is build/release/x 1 2.
MUTANT_PROGRAMS ?= tests/check_hashes.sh tests/check_manual.sh $(RELATIONS:$(BUILD)/%=%),build/relations,SEEDS=0:60

# The suites of hal/ and emulator/, linked with those two built once more, their branches counted. What
# the processor's own ports need is no test's to run: hal/ports_linux.c.
COVERED_SUITES := $(filter unit/hal/% unit/emulator/% unit/host/adapter/usb_% unit/host/boot/% \
                  unit/firmware/usb_% program/trace_command_test program/adapter_command_test,$(SUITES))
COVERED_OBJECTS  := $(patsubst %.c,$(BUILD)/coverage/%.o,$(HAL_SOURCES) $(ADAPTER_SOURCES) $(EMULATOR_SOURCES))
COVERED_BESIDES  := $(release_HOST) $(release_IMAGES)
COVERED_PROGRAMS := $(COVERED_SUITES:%=$(BUILD)/coverage/tests/%)
GCOVR := gcovr --root . --object-directory $(BUILD)/coverage --exclude-unreachable-branches --branches $(BUILD)/coverage

$(BUILD)/coverage/superframe: $(BUILD)/release/host/command/main.o $(COVERED_OBJECTS) $(COVERED_BESIDES)
	$(call link,--coverage,$(LIBS))

$(COVERED_PROGRAMS): $(BUILD)/coverage/%: %.c $(COVERED_OBJECTS) $(TESTKIT_SOURCES) $(COVERED_BESIDES)
	$(call link,$(WARNINGS) $(POSIX) -O0 -g $(INCLUDE_tests),--coverage -lcmocka $(LIBS))

mutants: | setup ## Break the source in small ways and see whether the tests notice (SEED= COUNT= SECONDS= FILES=)
	@SEED='$(SEED)' FIRST='$(FIRST)' COUNT='$(COUNT)' LIMIT='$(SECONDS)' FILES='$(FILES)' SANITIZED='$(SANITIZED)' CC='$(CC)' \
	    sh tests/mutants/run.sh $(BUILD) $(MUTANT_PROGRAMS) \
	    $(patsubst $(BUILD)/%,%,$(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS))

coverage: $(COVERED_PROGRAMS) $(BUILD)/coverage/superframe ## Measure the branches of hal/ and emulator/ that the suites take (100 % and 95 %)
	@find $(BUILD)/coverage -name '*.gcda' -delete
	@for suite in $(COVERED_PROGRAMS); do \
	    BUILD=$(BUILD) SUPERFRAME=$(BUILD)/coverage/superframe timeout 300 $$suite > $$suite.log 2>&1 || \
	        { tail -n 40 $$suite.log; exit 1; }; done
	$(GCOVR) --filter 'hal/cable/' --filter 'firmware/adapter/'
	$(GCOVR) --filter 'hal/[^/]*$$' --exclude 'hal/ports_linux.c' --fail-under-branch 100
	$(GCOVR) --filter 'emulator/' --fail-under-branch 95
