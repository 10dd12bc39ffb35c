/* SPDX-License-Identifier: MIT */
/* The table of sub-commands. */
#include <stddef.h>

#include "command/command.h"

const struct command commands[] = {
    {COMMAND_RENDER, "render", "SCENE",
     "Render a scene through firmware, ports and board to a picture.", 1, 1, run_render},
    {COMMAND_SCENES, "scenes", "", "List the built-in scenes: name, tab, one sentence.", 0, 0,
     run_scenes},
    {COMMAND_CHECK, "check", "SCENE", "Read and analyse a scene; say what it requires.", 1, 1,
     run_check},
    {COMMAND_COMPILE, "compile", "SCENE", "Write a scene as const tables for a firmware image.", 1,
     1, run_compile},
    {COMMAND_EXPORT, "export", "SCENE", "Write a scene for POV-Ray.", 1, 1, run_export},
    {COMMAND_TREE, "tree", "SCENE X Y", "Print the tree of rays of one pixel.", 3, 3, run_tree},
    {COMMAND_REPLAY, "replay", "TRACE...", "Play port traces on the emulated board.", 1, 1000,
     run_replay},
    {COMMAND_COMPARE, "compare", "A.png B.png",
     "Measure how far two pictures of the same size are apart.", 1, 3, run_compare},
    {COMMAND_MEASURE, "measure", "[SCENE...]", "Measure speed against accuracy.", 0, 1000,
     run_measure},
    {COMMAND_PAPER, "paper", "", "Make every figure of the paper, and measure its claims.", 0, 0,
     run_paper},
    {COMMAND_DEVICES, "devices", "", "List the adapters that are plugged in.", 0, 0, run_devices},
    {COMMAND_ADAPTER, "adapter", "", "Be a virtual USB adapter with the emulated board behind it.",
     0, 0, run_adapter},
    {COMMAND_TRACE, "trace", "TRACE", "Tell a port trace in words.", 1, 1, run_trace},
    {COMMAND_BOOT, "boot", "IMAGE.hdm", "Run a PC-98 floppy image on an emulated CPU.", 1, 1,
     run_boot},
    {COMMAND_COUNT, NULL, NULL, NULL, 0, 0, NULL}};
