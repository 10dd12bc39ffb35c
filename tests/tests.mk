# SPDX-License-Identifier: MIT
# Programs of the tests, and goals that take more than one command; read by Makefile.

# ---- Programs -----------------------------------------------------------------------------------

# The suites that hold something against f128; those of tests/real/ are held against libquadmath.
SUITES_OF_F128 := program/command $(addprefix laws/,accuracy extremes_optics extremes_place extremes_shapes \
                  extremes_walls leak optics_laws tail worked_example)
# unit/ mirrors the folders of the source; laws/ holds what rays and pictures obey, program/ the command.
SUITES       := $(patsubst tests/%.c,%,$(wildcard $(patsubst %,tests/%/*_test.c,unit/* unit/host/* laws program)))
REAL_SUITES  := $(patsubst %.c,%,$(wildcard tests/real/*_test.c))
TEST_SKIPPED := $(if $(F128),,$(SUITES_OF_F128:%=%_test) $(REAL_SUITES:tests/%=%))
# The real libraries against an emulated kernel, once with each flavour of hidapi.
USB_FLAVOURS := $(if $(word 2,$(USB_PACKAGES)),$(if $(call there,umockdev-1.0),hidapi-hidraw hidapi-libusb))

TEST_PROGRAMS      := $(patsubst %,$(BUILD)/sanitized/tests/%,$(filter-out $(TEST_SKIPPED),$(SUITES)))
REAL_TEST_PROGRAMS := $(if $(F128),$(foreach arithmetic,$(ARITHMETICS),$(REAL_SUITES:%=$(BUILD)/sanitized/arithmetic_$(arithmetic)/%)))
USB_TEST_PROGRAMS  := $(USB_FLAVOURS:%=$(BUILD)/sanitized/tests/usb/%_test)
TOOL      := $(BUILD)/release/tests
RELATIONS := $(TOOL)/relations/relations
TOOLS     := $(RELATIONS) $(addprefix $(TOOL)/,bench/timed bench/psnr bench/frame bench/ports_bench bench/usb_bytes \
             accuracy/accuracy accuracy/tails accuracy/asked accuracy/promise cost/operations cost/predict pov/pov_check)
# Only clang brings libFuzzer, whatever compiler the caller has chosen. The fuzzer of boot needs Unicorn.
FUZZERS := $(patsubst %.c,$(BUILD)/fuzzed/%,$(filter-out $(if $(PROCESSORS),,%/boot_fuzz.c),$(wildcard tests/fuzz/*_fuzz.c)))
$(BUILD)/fuzzed/%: private override CC := clang
# The suites of hal/ and emulator/, linked with those two built once more, their branches counted.
COVERED_PROGRAMS := $(patsubst %,$(BUILD)/coverage/tests/%,$(filter unit/hal/% unit/emulator/% unit/host/adapter/usb_% \
    unit/host/boot/% unit/firmware/usb_% program/trace_command_test program/adapter_command_test,$(SUITES)))

# A program stands where its object does. What it needs besides is an archive, and these objects. The test
# kit is no part of the program: its own suites alone are linked with it. The image that counts its
# operations has a written table, and is linked into nothing else. tests/mutants/run.sh says what is TESTED.
PROGRAMS := $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(TOOLS) $(FUZZERS) $(COVERED_PROGRAMS)
$(PROGRAMS): %: %.o
	$(call link,$(if $(filter $(FUZZERS),$@),-fsanitize=fuzzer) $(if $(filter %_test,$@),-lcmocka) $(LIBS))
$(TEST_PROGRAMS) $(USB_TEST_PROGRAMS): $(BUILD)/$(or $(TESTED),sanitized)/library.a
$(patsubst %,$(BUILD)/sanitized/tests/unit/emulator/%_test,testkit testkit_writes): $(TESTKIT_SOURCES:%.c=$(BUILD)/sanitized/%.o)
$(TOOLS): $(BUILD)/release/library.a
$(RELATIONS): $(patsubst %.c,$(BUILD)/release/%.o,$(wildcard tests/relations/*.c))
$(TOOL)/accuracy/tails $(TOOL)/accuracy/asked: $(TOOL)/accuracy/frame.o
$(TOOL)/cost/operations: $(BUILD)/release/arithmetic_count.o
$(FUZZERS): $(BUILD)/fuzzed/library.a
$(BUILD)/fuzzed/tests/fuzz/scene_fuzz: $(BUILD)/fuzzed/tests/fuzz/scene_mutator.o
$(BUILD)/fuzzed/library.a: $(addprefix $(BUILD)/fuzzed/,$(filter hal/% emulator/% firmware/adapter/% host/boot/% \
    $(patsubst %,host/%/%.o,base scene compiler adapter) arithmetic_fx.o arithmetic_f32.o arithmetic_f32_many.o builtin_scenes.o lists/processors.o,$(LIBRARY)))
$(COVERED_PROGRAMS): $(BUILD)/coverage/library.a
$(BUILD)/coverage/library.a: $(patsubst %.c,$(BUILD)/coverage/%.o,$(BOARD_SOURCES) $(TESTKIT_SOURCES)) \
    $(addprefix $(BUILD)/release/,$(filter-out hal/% emulator/% firmware/%,$(LIBRARY)))
$(USB_TEST_PROGRAMS): $(BUILD)/sanitized/tests/usb/%_test: $(patsubst %.c,$(BUILD)/sanitized/%.o,$(wildcard tests/usb/*.c))
	$(call link,-lcmocka -l$* $(filter-out -lhidapi%,$(LIBS)) $(call libs_of,umockdev-1.0))
FLAGS_tests/real := $(POSIX)
FLAGS_tests/usb  := -D_DEFAULT_SOURCE $(if $(USB_FLAVOURS),$(call headers_of,umockdev-1.0))

# The program without f128 and transports: what only the whole lists name is left in the archive.
$(BUILD)/superframe_without: $(addprefix $(BUILD)/release/,host/command/main.o lists_without/usb_backends.o \
    lists_without/arithmetics.o lists_without/arithmetics_many.o library.a)
	$(call link,$(filter-out $(USB_LIBS) -lquadmath,$(LIBS)))
$(LISTS:%=$(BUILD)/lists_without/%.c): $(BUILD)/lists_without/%.c: host/base/list.sh FORCE
	$(call renew,sh $< $* $(filter-out f128% bulk hid,$(LIST_$*)))

# The firmware without what the host adds to it: tests/check_symbols.sh reads this.
FIRMWARE_IMAGES := $(patsubst %,$(BUILD)/release/firmware_%.o,fx f32 f64)
$(FIRMWARE_IMAGES): $(BUILD)/release/firmware_%.o: $(addprefix $(BUILD)/release/arithmetic_%/,$(FIRMWARE_SOURCES:.c=.o)) $(BUILD)/sources
	$(call combine)

$(BUILD)/targets/count.so: tests/targets/count_plugin.c | setup
	$(call link,$(WARNINGS) -O2 -shared -fPIC)

# No system, no heap, no library but the compiler's own. clang makes code for any machine and has the
# freestanding headers; gcc needs its cross compiler.
ADAPTER_CC ?= $(if $(shell command -v arm-none-eabi-gcc 2>/dev/null),arm-none-eabi-gcc,clang --target=thumbv6m-none-eabi)
ADAPTER_OBJECTS := $(patsubst %.c,$(BUILD)/adapter/%.o,$(wildcard firmware/adapter/*.c) hal/cable/usb_ops.c hal/cable/usb_wire.c hal/bus.c)
$(BUILD)/adapter/%.o: private CC := $(ADAPTER_CC)
$(eval $(call objects,adapter,-ffreestanding -mcpu=cortex-m0plus -mthumb -Os $(INCLUDE_firmware) -Ifirmware/adapter))

# Undefined behaviour in root and reciprocal, which Eva takes as given, ends the trial.
PROOFS := $(BUILD)/proofs/root_exhaustive $(BUILD)/proofs/exponential_exhaustive
$(PROOFS): $(BUILD)/proofs/%: tests/proofs/%.c $(wildcard firmware/real/fixed*.h) | setup
	$(call link,$(WARNINGS) -O3 -Ifirmware/real/fx $(INCLUDE_tests) $(if $(filter root%,$*),-fsanitize=undefined -fno-sanitize-recover=all) -lquadmath -lpthread)

# ---- Tests --------------------------------------------------------------------------------------

# All but the two of `make lint`.
TEST_SCRIPTS := $(filter-out %/check_style.sh %/check_english.sh,$(wildcard tests/check_*.sh tests/*_matrix.sh tests/*/*_test.sh))
# `make quick` leaves these to `make test`: each takes more than two seconds.
SLOW_SUITES := program/command program/trace_command program/adapter_clients program/adapter_strangers \
    unit/host/lab/measure% unit/host/lab/paper% unit/host/stream/stream unit/host/validate/validate \
    unit/firmware/usb_% unit/host/adapter/usb_% unit/host/adapter/usbip_server unit/hal/usb_% \
    $(addprefix unit/host/compiler/,compiled_points coincident_surfaces dead_things fused_solids) \
    $(addprefix unit/host/render/,ray_tree render_counts) \
    $(addprefix laws/,accuracy asked_error csg_laws extremes_% leak patterns tail)
QUICK_PROGRAMS := $(filter-out $(SLOW_SUITES:%=$(BUILD)/sanitized/tests/%_test),$(TEST_PROGRAMS))

# The packages first: which of them are there decides what is built.
test: setup ## Run every test (under the address and undefined-behaviour sanitizers) [test quick usb]
	@$(MAKE) --no-print-directory run-tests

run-tests: $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS) $(BUILD)/superframe $(BUILD)/sanitized/superframe \
    $(FIRMWARE_IMAGES) strict fresh-prefix $(BUILD)/superframe_without $(filter $(TOOL)/bench/%,$(TOOLS)) $(FUZZERS) $(RELATIONS) \
    $(TOOL)/accuracy/promise
	@$(if $(TEST_SKIPPED),echo 'skipped without libquadmath: $(TEST_SKIPPED)')
	@$(if $(USB_FLAVOURS),,echo 'skipped without libusb, both hidapi and umockdev: tests/usb')
	@$(if $(PROCESSORS),,echo 'skipped without Unicorn: boot_fuzz')
	@sh tests/run.sh $(BUILD) $(TEST_SCRIPTS) $(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS)

quick: $(QUICK_PROGRAMS) $(BUILD)/superframe $(BUILD)/sanitized/superframe strict ## Run what is quick of the tests [test]
	@sh tests/run.sh $(BUILD) tests/check_includes.sh tests/check_hashes.sh $(QUICK_PROGRAMS)

# Where tests/check_install.sh builds the examples: nothing of an earlier install is left in it.
fresh-prefix: $(BUILD)/superframe $(LIBRARIES)
	@rm -rf $(BUILD)/prefix
	@$(MAKE) --no-print-directory -s install PREFIX='$(abspath $(BUILD))/prefix' DESTDIR=

strict: | setup ## Compile the firmware with one opaque type for each role: no raw arithmetic passes
	$(Q)for form in full many; do \
	    $(CC) $(WARNINGS) -ffreestanding -Ifirmware/real/strict -Ifirmware/features/$$form $(INCLUDE_firmware) \
	    -fsyntax-only $(FIRMWARE_SOURCES) || exit 1; done

test-kernel: setup ## Draw over USB and HID through the real Linux USB stack, as an ordinary user [test usb kernel]
	@$(MAKE) --no-print-directory $(BUILD)/superframe $(BUILD)/sanitized/superframe $(LIBRARIES)
	@sh tests/kernel/fetch.sh $(BUILD)/kernel/debian
	@$(MAKE) --no-print-directory -s install PREFIX=/usr/local DESTDIR='$(abspath $(BUILD)/kernel)/installed'
	@sh tests/kernel/initramfs.sh $(BUILD)/kernel/debian/system $(BUILD)/kernel/installed $(BUILD)/kernel/guest
	@sh tests/kernel/run.sh $(BUILD)/kernel/guest $(BUILD)/sanitized/superframe $(BUILD)/superframe

# Besides the suites, whatever tells by its exit status: release/x,1,2 is build/release/x 1 2.
MUTANT_PROGRAMS ?= tests/check_hashes.sh tests/check_manual.sh $(RELATIONS:$(BUILD)/%=%),build/relations,SEEDS=0:60
mutants: | setup ## Break the source in small ways and see whether the tests notice (SEED= COUNT= SECONDS= FILES=) [test usb]
	@CC='$(CC)' LIMIT='$(SECONDS)' sh tests/mutants/run.sh $(BUILD) $(MUTANT_PROGRAMS) \
	    $(patsubst $(BUILD)/%,%,$(TEST_PROGRAMS) $(REAL_TEST_PROGRAMS) $(USB_TEST_PROGRAMS))

# What the processor's own ports need is no test's to run: hal/ports_linux.c.
GCOVR := gcovr --root . --object-directory $(BUILD)/coverage --exclude-unreachable-branches --branches $(BUILD)/coverage
coverage: $(COVERED_PROGRAMS) $(BUILD)/coverage/superframe ## Measure the branches of hal/ and emulator/ that the suites take (100 % and 95 %) [test coverage]
	@find $(BUILD)/coverage -name '*.gcda' -delete
	@for suite in $(COVERED_PROGRAMS); do \
	    SUPERFRAME=$(BUILD)/coverage/superframe timeout 300 $$suite > $$suite.log 2>&1 || { tail -n 40 $$suite.log; exit 1; }; done
	$(GCOVR) --filter 'hal/cable/' --filter 'firmware/adapter/'
	$(GCOVR) --filter 'hal/[^/]*$$' --exclude 'hal/ports_linux.c' --fail-under-branch 100
	$(GCOVR) --filter 'emulator/' --fail-under-branch 95

# Every PROOF_STEP-th argument is tried (a power of two to 65536): 1 is a proof, more is a sample.
PROOF_STEP ?= 1
prove: $(PROOFS) ## Prove ranges and errors of fixed point (Frama-C, Gappa, exhaustive trial), and the adapter's answers [prove]
	sh tests/proofs/ranges.sh $(BUILD)/proofs/ranges
	sh tests/proofs/bounds.sh
	sh tests/proofs/usb_requests.sh $(BUILD)/proofs
	timeout -k 5 600 $(BUILD)/proofs/exponential_exhaustive 2 $(PROOF_STEP)
	timeout -k 5 900 $(BUILD)/proofs/root_exhaustive 2 $(PROOF_STEP)

# Everything is read as it is compiled; the firmware in fixed and in floating point, where the ranges
# of divisors are proved in comments, which the analyser can't read.
lint: lint-style lint-cppcheck lint-tidy ## Read the source with clang-tidy and cppcheck, and check its style [lint]

lint-style: | setup # [lint]
	@sh tests/check_style.sh
	@sh tests/check_english.sh

lint-cppcheck: | setup # [lint]
	cppcheck --quiet --std=c99 --enable=warning,performance,portability --error-exitcode=1 \
	    --suppressions-list=tests/cppcheck_suppressions.txt $(INCLUDE_host) -Ifirmware/real/fx $(SETS_bits) -Ihost/stream/bits \
	    -Iemulator/testing hal emulator host firmware

# tidy ARITHMETICS,SOURCES,INCLUDES: reads what is compiled for each arithmetic.
tidy = @printf '%s\n' $(1) | xargs -P 2 -I % clang-tidy --quiet --checks=-clang-analyzer-core.DivideZero $(2) -- \
    -std=c99 -Ifirmware/real/% $(3) $(INCLUDE_host)
lint-tidy: | setup # [lint]
	@printf '%s\n' $(BOARD_SOURCES) $(HOST_SOURCES) $(TESTKIT_SOURCES) | \
	    xargs -P 2 -n 8 sh -c 'clang-tidy --quiet "$$@" -- -std=c99 $(POSIX) $(INCLUDE_host) -Iemulator/testing' tidy
	$(call tidy,fx f64,$(FIRMWARE_SOURCES) $(PER_ARITHMETIC_SOURCES),$(SETS_bits))
	$(call tidy,f64,$(FIRMWARE_SOURCES) $(PER_ARITHMETIC_SOURCES),$(SETS_list))
	$(call tidy,fx_vector f64,$(call STREAM_SOURCES,bits),$(SETS_bits) -Ihost/stream/bits -Ihost/stream/sets/plain)
	$(call tidy,f64,$(call STREAM_SOURCES,list),$(SETS_list) -Ihost/stream/list -Ihost/stream/sets/plain)
