/* SPDX-License-Identifier: MIT */
/* A folder of results that appears whole, or not at all. */
#ifndef SUPERFRAME_PAPER_FOLDER_H
#define SUPERFRAME_PAPER_FOLDER_H

#include <stdbool.h>

/* Results are written into `temporary`. All NULL: not open. */
struct paper_folder {
    char *target;
    char *temporary;
    bool is_there; /* the target was there before: files in it are replaced one by one */
};

/* Makes the temporary folder: beside the target, or inside the target if that is there already. So
 * both are on the same file system. False, with the reason printed, on failure. */
bool paper_folder_open(struct paper_folder *folder, const char *target);

/* Puts what was written into its place. Other files of a folder that was there stay. False, with
 * the reason printed, on failure. The folder is closed either way. */
bool paper_folder_commit(struct paper_folder *folder);

/* Removes what was written. Harmless if the folder is not open. */
void paper_folder_discard(struct paper_folder *folder);

#endif
