# SPDX-License-Identifier: MIT
# Images of the firmware for other CPUs: built, run, measured; read by Makefile.

pc98: $(BUILD)/superframe ## Make a PC-98 floppy of fig3 (or SCENE=...): build/out/fig3.hdm
	@mkdir -p $(BUILD)/out
	SUPERFRAME=$(BUILD)/superframe CC='$(CC)' sh firmware/targets/build.sh 386-flat fx $(SCENE) - - minimal $(BUILD)/targets/pc98
	cp $(BUILD)/targets/pc98/disk.hdm $(BUILD)/out/$(notdir $(basename $(SCENE))).hdm
	@echo "The floppy is $(BUILD)/out/$(notdir $(basename $(SCENE))).hdm"

pc98-probe: | setup ## Make a PC-98 floppy that asks a real board what is not known: build/out/probe.hdm
	@mkdir -p $(BUILD)/out
	CC='$(CC)' sh firmware/targets/build_probe.sh $(BUILD)/targets/probe
	cp $(BUILD)/targets/probe/disk.hdm $(BUILD)/out/probe.hdm
	@echo "The floppy is $(BUILD)/out/probe.hdm"

wasm: $(BUILD)/superframe ## Make a WebAssembly module of fig3 (or SCENE=...): build/out/fig3.wasm
	@mkdir -p $(BUILD)/out
	SUPERFRAME=$(BUILD)/superframe sh firmware/targets/build.sh wasm fx $(SCENE) - - minimal $(BUILD)/targets/module
	cp $(BUILD)/targets/module/image.wasm $(BUILD)/out/$(notdir $(basename $(SCENE))).wasm

$(BUILD)/targets/count.so: tests/targets/count_plugin.c | setup
	@mkdir -p $(@D)
	$(CC) -std=c99 -pedantic -Wall -Wextra -Wconversion -O2 -shared -fPIC -o $@ $<

targets: $(BUILD)/superframe $(BUILD)/targets/count.so ## Run fig3 and fig4b on every target; write the table in docs/targets.md
	BUILD=$(BUILD) sh tests/targets/check_portability.sh
	BUILD=$(BUILD) sh tests/targets/table.sh docs/targets.md

size: $(BUILD)/superframe $(BUILD)/targets/count.so ## Measure code, memory, stack and instructions against docs/size.txt
	BUILD=$(BUILD) sh tests/targets/size.sh docs/size.txt

size-keep: $(BUILD)/superframe $(BUILD)/targets/count.so ## Keep the figures of `make size` in docs/size.txt
	BUILD=$(BUILD) sh tests/targets/size.sh --keep docs/size.txt

minimal-table: $(BUILD)/superframe $(BUILD)/targets/count.so ## Full against minimal images of every scene; write the table in docs/minimal.md
	BUILD=$(BUILD) sh tests/targets/minimal.sh docs/minimal.md
