# SPDX-License-Identifier: MIT
# What a render costs, and what POV-Ray takes for the same scene; a part of the Makefile.

BENCH_TOOLS := $(BUILD)/release/bench/timed $(BUILD)/release/bench/psnr $(BUILD)/release/bench/frame

$(BUILD)/release/bench/%.o: tests/bench/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(BUILD)/release/bench/timed: $(BUILD)/release/bench/timed.o
	$(CC) $(LDFLAGS_release) -o $@ $<

$(BUILD)/release/bench/psnr: $(BUILD)/release/bench/psnr.o $(release_EMULATOR) $(release_HAL)
	$(CC) $(LDFLAGS_release) -o $@ $^ -lpng -lxxhash -lz -lm

$(BUILD)/release/bench/frame: $(BUILD)/release/bench/frame.o $(release_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)
