# SPDX-License-Identifier: MIT
# The fuzzers of tests/fuzz, see docs/fuzzing.md; read by Makefile.

# Only clang brings libFuzzer, whatever compiler the caller has chosen.
$(BUILD)/fuzzed/%: private override CC := clang

# A fuzzer takes from this library what it calls. A processor needs Unicorn.
FUZZED_HOST    := $(addprefix $(BUILD)/fuzzed/host/,scene_%.o compile%.o affine.o bounds.o quadric_form.o usb_%.o processor/%.o)
FUZZED_IMAGES  := $(patsubst %,$(BUILD)/fuzzed/image_%.o,fx f32)
FUZZED_OBJECTS := $(fuzzed_HAL) $(fuzzed_EMULATOR) $(filter $(FUZZED_HOST),$(fuzzed_HOST)) $(FUZZED_IMAGES)
FUZZERS        := $(patsubst tests/fuzz/%.c,$(BUILD)/fuzzed/%,$(wildcard tests/fuzz/*_fuzz.c))
FUZZERS        := $(if $(BOOT_PACKAGE),$(FUZZERS),$(filter-out %/boot_fuzz,$(FUZZERS)))

$(BUILD)/fuzzed/library.a: $(FUZZED_OBJECTS) $(BUILD)/sources
	@rm -f $@
	@$(AR) rcs $@ $(filter %.o,$^)

$(BUILD)/fuzzed/tests/fuzz/%.o: tests/fuzz/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_fuzzed) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(BUILD)/fuzzed/scene_fuzz: $(BUILD)/fuzzed/tests/fuzz/scene_mutator.o
$(FUZZERS): $(BUILD)/fuzzed/%: $(BUILD)/fuzzed/tests/fuzz/%.o $(BUILD)/fuzzed/library.a
	$(CC) $(LDFLAGS_fuzzed) -o $@ $(filter %.o,$^) $(BUILD)/fuzzed/library.a $(LIBS)

.PHONY: fuzz
fuzz: $(FUZZERS) ## Fuzz each reader of foreign bytes for SECONDS=600, or FUZZER=scene alone
	@BUILD=$(BUILD) sh tests/check_fuzz.sh $(or $(SECONDS),600) $(FUZZER)
