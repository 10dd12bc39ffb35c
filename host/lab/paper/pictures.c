/* SPDX-License-Identifier: MIT */
/* The paper's figures as PNG files, and a contact sheet of them. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "lab/paper/paper.h"
#include "png_file.h"

FILE *paper_create(const struct paper *paper, const char *name) {
    char path[4096];
    int length = snprintf(path, sizeof path, "%s/%s", paper->folder, name);
    FILE *file = NULL;
    errno = ENAMETOOLONG;
    if (length > 0 && (size_t)length < sizeof path) {
        file = fopen(path, "wb");
    }
    if (file == NULL) {
        complain("%s: cannot be written: %s", name, strerror(errno));
    }
    return file;
}

int paper_close(FILE *file, const char *name) {
    errno = 0;
    bool is_written = fflush(file) == 0 && !ferror(file);
    int error_number = errno;
    if (fclose(file) != 0 && is_written) {
        is_written = false;
        error_number = errno;
    }
    if (!is_written) {
        complain("%s: cannot be written: %s", name,
                 error_number != 0 ? strerror(error_number) : "an earlier write failed");
    }
    return is_written ? STATUS_DONE : STATUS_FAILED;
}

static int write_picture(const struct paper *paper, const char *name, const uint8_t *rgb,
                         unsigned width, unsigned height) {
    struct png_error error;
    FILE *file = paper_create(paper, name);
    if (file == NULL) {
        return STATUS_FAILED;
    }
    if (write_png(file, rgb, width, height, &error) != PNG_OK) {
        complain("%s: cannot be written: %s", name, error.message);
        (void)fclose(file);
        return STATUS_FAILED;
    }
    return paper_close(file, name);
}

/* ---- The contact sheet ---------------------------------------------------------------------- */

enum {
    COLUMNS = 3,
    GAP = 12,
    CELL_WIDTH = PICTURE_WIDTH / 2,
    CELL_HEIGHT = PICTURE_HEIGHT / 2,
    SHEET_WIDTH = COLUMNS * (CELL_WIDTH + GAP) + GAP,
    PAPER_WHITE = 0xF0
};

/* Puts a photo into a cell of the sheet at half its size: each dot is the mean of 2 x 2. */
static void put_cell(uint8_t *sheet, unsigned cell, const struct paper_photo *photo) {
    size_t left = GAP + cell % COLUMNS * (CELL_WIDTH + GAP);
    size_t top = GAP + cell / COLUMNS * (CELL_HEIGHT + GAP);
    for (size_t y = 0; y < CELL_HEIGHT; y++) {
        for (size_t x = 0; x < CELL_WIDTH * 3; x++) {
            size_t dot = x / 3 * 6 + x % 3;
            const uint8_t *upper = &photo->rgb[2 * y * PICTURE_WIDTH * 3 + dot];
            const uint8_t *lower = upper + PICTURE_WIDTH * 3;
            sheet[((top + y) * SHEET_WIDTH + left) * 3 + x] =
                (uint8_t)((upper[0] + upper[3] + lower[0] + lower[3] + 2) / 4);
        }
    }
}

static int write_sheet(const struct paper *paper) {
    unsigned cells = 0, cell = 0;
    for (int i = 0; paper_figures[i].file != NULL; i++) {
        cells += paper->figures[i] != NULL;
    }
    unsigned rows = (cells + COLUMNS - 1) / COLUMNS;
    unsigned height = rows * (CELL_HEIGHT + GAP) + GAP;
    uint8_t *sheet = malloc((size_t)SHEET_WIDTH * height * 3);
    if (sheet == NULL) {
        return failure("out of memory");
    }
    memset(sheet, PAPER_WHITE, (size_t)SHEET_WIDTH * height * 3);
    for (int i = 0; paper_figures[i].file != NULL; i++) {
        if (paper->figures[i] != NULL) {
            put_cell(sheet, cell++, paper->figures[i]);
        }
    }
    int status = write_picture(paper, "contact-sheet.png", sheet, SHEET_WIDTH, height);
    free(sheet);
    return status;
}

int paper_write_pictures(const struct paper *paper) {
    int status = STATUS_DONE;
    for (int i = 0; paper_figures[i].file != NULL && status == STATUS_DONE; i++) {
        char name[64];
        (void)snprintf(name, sizeof name, "%s.png", paper_figures[i].file);
        if (paper->figures[i] != NULL) {
            status =
                write_picture(paper, name, paper->figures[i]->rgb, PICTURE_WIDTH, PICTURE_HEIGHT);
        }
    }
    return status == STATUS_DONE ? write_sheet(paper) : status;
}
