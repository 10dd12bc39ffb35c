# SPDX-License-Identifier: MIT
# What is measured: tests, speed, accuracy, costs; read by Makefile.

# ---- Speed --------------------------------------------------------------------------------------

BENCH_TOOLS := $(patsubst %,$(BUILD)/release/bench/%,timed psnr frame)
$(eval $(call tool,release/bench/frame,tests/bench/frame.c))

$(BUILD)/release/bench/timed: $(BUILD)/release/tests/bench/timed.o
	$(call link)

$(BUILD)/release/bench/psnr: $(BUILD)/release/tests/bench/psnr.o $(release_EMULATOR) $(release_HAL)
	$(call link,,-lpng -lxxhash -ldeflate -lm)

$(BUILD)/release/ports_bench: $(BUILD)/release/tests/bench/ports_bench.o $(release_EMULATOR) $(release_HAL)
	$(call link,,-lpng -lxxhash -ldeflate)

$(BUILD)/usb_bytes: $(BUILD)/release/tests/bench/usb_bytes.o $(release_EMULATOR) $(release_HAL)
	$(call link,,$(LIBS))

# Where povray can't be installed, what it is needed for is left out.
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

bench-ports: $(BUILD)/release/ports_bench ## Measure what a port write costs, in nanoseconds
	$<

usb-table: $(BUILD)/superframe $(BUILD)/usb_bytes ## Write docs/usb-bytes.md: what each scene costs on the cable
	sh tests/bench/usb_bytes.sh $^ > $(BUILD)/usb-bytes.md
	cp $(BUILD)/usb-bytes.md docs/usb-bytes.md

# ---- Accuracy -----------------------------------------------------------------------------------

CONVERGED_SIZE ?= 640x400
$(eval $(call tool,release/accuracy,tests/accuracy/accuracy.c))
$(foreach kind,tails asked,$(eval $(call tool,release/accuracy_$(kind),tests/accuracy/$(kind).c tests/accuracy/frame.c)))

# Pictures in f128, and converged ones, take minutes: they are kept for as long as the image that
# made them.
$(BUILD)/accuracy/made_by: $(BUILD)/release/image_f128.o
$(BUILD)/converged/made_by: $(BUILD)/release/image_f64.o $(BUILD)/release/tests/accuracy/frame.o
$(BUILD)/accuracy/made_by $(BUILD)/converged/made_by:
	@rm -rf $(@D) && mkdir -p $(@D) && touch $@

accuracy: $(BUILD)/release/accuracy $(BUILD)/accuracy/made_by ## Whole frames of every built-in scene against f128 (SCENES=... for some)
	$< $(BUILD)/accuracy $(SCENES)

accuracy-tails: $(BUILD)/release/accuracy_tails $(BUILD)/converged/made_by ## What cut branches count as: fig3, fig4a, fig5 by arithmetic, threshold and tail (CONVERGED_SIZE=640x400, SCENES=... for some)
	$< $(BUILD)/converged $(CONVERGED_SIZE) $(SCENES)

accuracy-asked: $(BUILD)/release/accuracy_asked $(BUILD)/converged/made_by ## What --error reaches on every built-in scene, and what it takes (CONVERGED_SIZE=640x400, SCENES=... for some)
	$< $(BUILD)/converged $(CONVERGED_SIZE) $(SCENES)

# ---- Speed against accuracy, and what its predictions are made of -------------------------------

# An image that counts its operations; it has a written table, and is linked into nothing else.
$(eval $(call image,release,count))
$(eval $(call tool,release/count_operations,tests/cost/operations.c))
$(eval $(call tool,release/predict,tests/cost/predict.c))
$(BUILD)/release/count_operations: $(BUILD)/release/image_count.o
COST_TARGETS ?= m0 m3 m4f i386 i387 x86_64

measure: $(BUILD)/superframe ## Measure speed against accuracy: report and plots in build/measure
	$(BUILD)/superframe measure --size 80x50 --jobs 2 -o $(BUILD)/measure

cost-operations: $(BUILD)/release/count_operations ## Count the operations of rays, boundaries and tests
	$<

cost-check: $(BUILD)/superframe $(BUILD)/targets/count.so $(BUILD)/release/predict ## Hold the predicted instructions against those that qemu counts; write the table in docs/measure.md
	sh tests/cost/check.sh $(BUILD) docs/measure.md

cost-instructions: $(BUILD)/targets/count.so | setup ## Count the instructions of operations (COST_TARGETS="m3 ..."; needs qemu-user, gcc-arm-none-eabi)
	sh tests/cost/instructions.sh $(COST_TARGETS)
