# SPDX-License-Identifier: MIT
# What a render costs, and what POV-Ray takes for the same scene; a part of the Makefile.

BENCH_TOOLS := $(BUILD)/release/bench/timed $(BUILD)/release/bench/psnr $(BUILD)/release/bench/frame

$(BUILD)/release/bench/%.o: tests/bench/%.c $(BUILD)/flags | setup
	@mkdir -p $(@D)
	$(CC) $(WARNINGS) $(POSIX) $(CFLAGS_release) $(INCLUDE_tests) -MMD -MP -c -o $@ $<

$(BUILD)/release/bench/timed: $(BUILD)/release/bench/timed.o
	$(CC) $(LDFLAGS_release) -o $@ $<

$(BUILD)/release/bench/psnr: $(BUILD)/release/bench/psnr.o $(release_EMULATOR) $(release_HAL)
	$(CC) $(LDFLAGS_release) -o $@ $^ -lpng -lxxhash -ldeflate -lm

$(BUILD)/release/bench/frame: $(BUILD)/release/bench/frame.o $(release_LIBRARY) $(BUILD)/sources
	$(CC) $(LDFLAGS_release) -o $@ $(filter %.o,$^) $(LIBS)

# Where povray can't be installed, what it is needed for is left out.
.PHONY: bench bench-keep bench-check bench-instructions-keep
bench: $(BUILD)/superframe $(BENCH_TOOLS) ## Measure what renders cost, alone and against POV-Ray (BENCH=all, STAGES=...)
	@CC='$(CC)' SETUP='$(SETUP)' sh setup.sh pov paper || true
	@sh tests/bench/bench.sh $(BUILD) $(STAGES)

bench-keep: ## Keep the page, the JSON and the plots of the last `make bench` in docs/
	@mkdir -p docs/bench
	cp $(BUILD)/bench/bench.md docs/bench.md
	cp $(wildcard $(addprefix $(BUILD)/bench/,settings.tsv bench.json rays.png ratio.png)) docs/bench/

bench-check: $(BUILD)/superframe ## Hold instructions a ray against docs/bench/instructions.txt (at most 2 % more)
	@sh tests/bench/instructions.sh $(BUILD) check docs/bench/instructions.txt

bench-instructions-keep: $(BUILD)/superframe ## Keep the instructions a ray in docs/bench/instructions.txt
	@mkdir -p docs/bench
	@sh tests/bench/instructions.sh $(BUILD) keep docs/bench/instructions.txt

SETUP_FOR_bench-check := count
SETUP_FOR_bench-instructions-keep := count
