/* SPDX-License-Identifier: MIT */
/* The places that a command reads and writes. No two results go to one, none over an input, and no
 * picture over what is none. */
#include "options/places.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/path.h"
#include "board/camera.h"
#include "scene/load.h"

enum { RESULTS_MOST = 8 + RENDER_EXPOSURES, NAME_SIZE = 256, WHAT_SIZE = 32 };

/* A name, and what the system knows of it. */
struct place {
    const char *what; /* the option or operand that names it */
    const char *name; /* "-": a standard stream */
    bool is_picture;  /* it may replace PNGs alone */
    bool is_there;
    struct stat facts; /* where is_there */
    char *resolved;    /* where it is not there: its folder's real path, and its own name */
};

/* All results of a command line. */
struct results {
    struct place places[RESULTS_MOST];
    char what[RESULTS_MOST][WHAT_SIZE];
    unsigned count;
    char picture[NAME_SIZE]; /* render's, where -o is not given */
    char *exposures[RENDER_EXPOSURES];
};

static bool is_stream(const struct place *place) {
    return strcmp(place->name, "-") == 0;
}

static struct place look_at(const char *what, const char *name, int stream) {
    struct place place;
    memset(&place, 0, sizeof place);
    place.what = what;
    place.name = name;
    place.is_there =
        is_stream(&place) ? fstat(stream, &place.facts) == 0 : stat(name, &place.facts) == 0;
    if (!place.is_there && !is_stream(&place)) {
        place.resolved = path_resolve(name);
    }
    return place;
}

static bool is_same_file(const struct place *a, const struct place *b) {
    return a->facts.st_dev == b->facts.st_dev && a->facts.st_ino == b->facts.st_ino;
}

/* Tells whether results may share a place. A device takes everything from everybody, but the
 * terminal of standard output would show results mixed up. */
static bool is_shareable(const struct place *place) {
    const struct place output = look_at("", "-", STDOUT_FILENO);
    return (S_ISCHR(place->facts.st_mode) || S_ISBLK(place->facts.st_mode)) &&
           !(is_same_file(place, &output) && isatty(STDOUT_FILENO));
}

/* Tells whether what goes to one place is lost or mixed up where something goes to the other
 * too. */
static bool do_results_clash(const struct place *a, const struct place *b) {
    if (is_stream(a) && is_stream(b)) {
        return true;
    }
    if (a->is_there && b->is_there) {
        return is_same_file(a, b) && !is_shareable(a);
    }
    return a->resolved != NULL && b->resolved != NULL && strcmp(a->resolved, b->resolved) == 0;
}

/* Tells whether the result replaces the file that is read. */
static bool is_overwritten(const struct place *input, const struct place *result) {
    return input->is_there && result->is_there && S_ISREG(input->facts.st_mode) &&
           is_same_file(input, result);
}

/* ---- Results -------------------------------------------------------------------------------- */

static void add_result(struct results *results, const char *what, const char *name,
                       bool is_picture) {
    if (name != NULL) {
        results->places[results->count] = look_at(what, name, STDOUT_FILENO);
        results->places[results->count++].is_picture = is_picture;
    }
}

static void add_exposures(struct results *results, const char *what, const char *folder) {
    for (unsigned i = 0; folder != NULL && i < RENDER_EXPOSURES; i++) {
        results->exposures[i] = camera_exposure_name(folder, i);
        add_result(results, what, results->exposures[i], false);
    }
}

/* Returns the name that an option was given; NULL: none. */
static const char *name_of(const struct option_entry *entry, const struct options *options) {
    const char *name;
    memcpy(&name, (const unsigned char *)options + entry->offset, sizeof name);
    return name;
}

/* Names an option in messages: "-o", "--stats". */
static const char *shown(const struct option_entry *entry, char text[WHAT_SIZE]) {
    if (entry->shown != NULL) {
        return entry->shown;
    }
    if (entry->letter != 0) {
        (void)snprintf(text, WHAT_SIZE, "-%c", entry->letter);
    } else {
        (void)snprintf(text, WHAT_SIZE, "--%s", entry->name);
    }
    return text;
}

static void add_results(struct results *results, const struct command *command,
                        const struct options *options) {
    const struct option_entry *entry;
    if (options->output == NULL && command->default_output != NULL) {
        add_result(results, "-o",
                   command->default_output(options, results->picture, sizeof results->picture),
                   true);
    }
    for (size_t i = 0; (entry = command_option(command, i)) != NULL; i++) {
        char *what = results->what[results->count];
        switch (entry->role) {
        case ROLE_NONE:
        case ROLE_INPUT:
            break;
        case ROLE_RESULT:
            add_result(results, shown(entry, what), name_of(entry, options), false);
            break;
        case ROLE_PICTURE:
            add_result(results, shown(entry, what), name_of(entry, options), !options->converts);
            break;
        case ROLE_EXPOSURES:
            add_exposures(results, shown(entry, what), name_of(entry, options));
            break;
        }
    }
    if (command->printed != NULL && command->printed(options) != NULL) {
        add_result(results, command->printed(options), "-", false);
    }
}

static void free_results(struct results *results) {
    for (unsigned i = 0; i < results->count; i++) {
        free(results->places[i].resolved);
    }
    for (unsigned i = 0; i < RENDER_EXPOSURES; i++) {
        free(results->exposures[i]);
    }
}

/* ---- What clashes --------------------------------------------------------------------------- */

static bool are_results_apart(const struct results *results, struct options_error *error) {
    for (unsigned i = 0; i < results->count; i++) {
        for (unsigned j = 0; j < i; j++) {
            const struct place *a = &results->places[j], *b = &results->places[i];
            if (do_results_clash(a, b)) {
                (void)snprintf(error->text, sizeof error->text,
                               "two results can't go to the same place, %s: %s and %s; give each "
                               "its own file",
                               is_stream(a) || is_stream(b) ? "standard output" : b->name, a->what,
                               b->what);
                return false;
            }
        }
    }
    return true;
}

static bool stays(const char *name, const struct results *results, struct options_error *error) {
    struct place input = look_at("", name, STDIN_FILENO);
    bool stays = true;
    for (unsigned i = 0; i < results->count && stays; i++) {
        const struct place *result = &results->places[i];
        stays = !is_overwritten(&input, result);
        if (!stays) {
            (void)snprintf(error->text, sizeof error->text,
                           "%.200s: %s would overwrite what is read; allowed is: another file",
                           name, result->what);
        }
    }
    free(input.resolved);
    return stays;
}

/* Tells how many of the operands are files or scenes. */
static int count_inputs(const struct command *command, const struct options *options) {
    switch (command->kind) {
    case OPERANDS_NONE:
        break;
    case OPERANDS_SCENE_FIRST:
        return 1;
    case OPERANDS_SCENES:
    case OPERANDS_FILES:
        return options->operand_count;
    }
    return 0;
}

static bool do_inputs_stay(const struct command *command, const struct options *options,
                           const struct results *results, struct options_error *error) {
    const struct option_entry *entry;
    bool has_scenes = command->kind != OPERANDS_FILES, all_stay = true;
    for (int i = 0; i < count_inputs(command, options) && all_stay; i++) {
        const char *operand = options->operands[i];
        all_stay = (has_scenes && scene_is_builtin(operand)) || stays(operand, results, error);
    }
    for (size_t i = 0; all_stay && (entry = command_option(command, i)) != NULL; i++) {
        const char *name = entry->role == ROLE_INPUT ? name_of(entry, options) : NULL;
        all_stay = name == NULL || stays(name, results, error);
    }
    return all_stay;
}

/* ---- Pictures that would replace something else ---------------------------------------------- */

/* Tells whether a name ends in another kind of picture than PNG. */
static bool has_other_ending(const char *name) {
    static const char *const endings[] = {"jpg",  "jpeg", "gif", "bmp", "tif", "tiff", "webp",
                                          "ppm",  "pgm",  "pbm", "pnm", "tga", "svg",  "heic",
                                          "avif", "jxl",  "qoi", "exr", "pdf", "eps"};
    const char *dot = strrchr(name, '.');
    for (size_t i = 0; dot != NULL && i < sizeof endings / sizeof endings[0]; i++) {
        if (strcasecmp(dot + 1, endings[i]) == 0) {
            return true;
        }
    }
    return false;
}

/* Tells whether a file with contents stands under the name, and is no PNG. What can't be read is
 * for the command to complain about. */
static bool is_other_file(const char *name) {
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    unsigned char begin[sizeof signature];
    struct stat facts;
    if (stat(name, &facts) != 0 || !S_ISREG(facts.st_mode) || facts.st_size == 0) {
        return false;
    }
    FILE *file = fopen(name, "rb");
    if (file == NULL) {
        return false;
    }
    size_t length = fread(begin, 1, sizeof begin, file);
    (void)fclose(file);
    return length < sizeof begin || memcmp(begin, signature, sizeof begin) != 0;
}

static bool may_be_written(const char *name, bool is_forced, struct options_error *error) {
    if (strcmp(name, "-") == 0) {
        return true;
    }
    if (has_other_ending(name)) {
        return options_refuse(error,
                              "%.200s: what is written is a PNG; allowed is: a name that ends in "
                              ".png, or in no other kind of picture",
                              name);
    }
    return is_forced || !is_other_file(name) ||
           options_refuse(error, "%.200s: the file that is there is no PNG; --force replaces it",
                          name);
}

static bool may_pictures_be_written(const struct results *results, bool is_forced,
                                    struct options_error *error) {
    bool may_be = true;
    for (unsigned i = 0; i < results->count && may_be; i++) {
        const struct place *place = &results->places[i];
        may_be = !place->is_picture || may_be_written(place->name, is_forced, error);
    }
    return may_be;
}

bool places_are_apart(const struct command *command, const struct options *options,
                      struct options_error *error) {
    struct results results;
    memset(&results, 0, sizeof results);
    add_results(&results, command, options);
    bool are_apart = are_results_apart(&results, error) &&
                     do_inputs_stay(command, options, &results, error) &&
                     may_pictures_be_written(&results, options->force, error);
    free_results(&results);
    return are_apart;
}
