/* SPDX-License-Identifier: MIT */
/* Holds relations on generated scenes:
 *
 *     relations OUT [SEEDS=A:B] [RELATION=NAME] [SECONDS=S] [JOBS=N] [COVERED=yes] [WRITE=yes]
 *
 * Seeds A .. B-1, all relations unless one is named. Failures are reduced and written into the
 * folder OUT. COVERED=yes: a count of 0 among what the scenes cover is a failure, too. WRITE=yes:
 * the scenes are written as OUT/SEED.scene, and nothing is held.
 * Exit status: 0 all hold, 1 one does not, 2 bad usage. */
#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "base/parallel.h"
#include "coverage.h"
#include "generate.h"
#include "reduce.h"
#include "trial.h"
#include "write.h"

/* Failures that are reduced: of one relation in one arithmetic, and in all. */
enum { REDUCED_MOST = 3, REDUCED_ALL = 16, RELATIONS_ROOM = 40 };

/* Of all pixels of a relation: the share whose signatures agree, and that of flips. */
#define AGREEING_LEAST 0.99
#define FLIPS_MOST     0.0005

/* What came of one relation in one arithmetic, over all seeds. */
struct tally {
    uint64_t pairs, pixels, agreeing, flips, faults;
    int worst, worst_flip;
};

struct run {
    const char *out;
    const struct relation *only; /* NULL: all */
    unsigned first, last, jobs;
    bool must_cover, writes;
    time_t end;
    volatile sig_atomic_t stop;

    pthread_mutex_t lock; /* of what follows */
    struct tally tallies[RELATIONS_ROOM][RELATION_ARITHMETICS];
    struct coverage coverage;
    unsigned long seeds, refused, faults, reduced;
    char refusal[256]; /* the first one */
};

/* ---- One seed ------------------------------------------------------------------------------- */

struct worker {
    struct syntax scene;
    struct trial_cache cache, reduced_cache;
    struct trial_room room;
    struct failure failure;
};

/* Writes a scene file; to be called under the run's lock. */
static void write_file(const struct run *run, const char *name, const struct syntax *scene) {
    static char text[RENDERING_TEXT_MOST];
    char path[1024];
    (void)snprintf(path, sizeof path, "%s/%s.scene", run->out, name);
    FILE *file = fopen(path, "w");
    bool good = file != NULL && write_scene(scene, text, sizeof text) && fputs(text, file) >= 0;
    good = (file == NULL || fclose(file) == 0) && good;
    if (!good) {
        (void)fprintf(stderr, "relations: %s: cannot be written: %s\n", path, strerror(errno));
    }
}

static void write_form(const struct run *run, const struct failure *failure,
                       const struct syntax *form, const char *suffix) {
    char name[128];
    (void)snprintf(name, sizeof name, "%s-%llu-%s%s", failure->relation->name,
                   (unsigned long long)failure->seed,
                   relation_arithmetic(failure->arithmetic)->image->name, suffix);
    write_file(run, name, form);
}

/* Reduces a failure and hands it out as scene files and one line. */
static void report(struct run *run, struct worker *worker, const struct relation *relation,
                   int arithmetic, uint64_t seed, const struct trial_result *result) {
    struct failure *failure = &worker->failure;
    struct trial_result again;
    failure->relation = relation;
    failure->arithmetic = arithmetic;
    failure->seed = seed;
    failure->scene = worker->scene;
    failure->result = *result;
    reduce_failure(failure, &worker->reduced_cache, &worker->room);
    if (trial_start(&worker->reduced_cache, &failure->scene)) {
        trial_run(relation, arithmetic, seed, &worker->reduced_cache, &worker->room, &again);
        trial_end(&worker->reduced_cache);
    }
    bool has_two = relation->rewrite != NULL;
    (void)pthread_mutex_lock(&run->lock);
    write_form(run, failure, has_two ? &worker->room.prepared : &failure->scene, "");
    if (has_two) {
        write_form(run, failure, &worker->room.rewritten, "-rewritten");
    }
    (void)printf("%s, seed %llu, %s: %s; reduced: %s\n", relation->name, (unsigned long long)seed,
                 relation_arithmetic(arithmetic)->image->name, result->text, failure->result.text);
    (void)fflush(stdout);
    (void)pthread_mutex_unlock(&run->lock);
}

static void add_result(struct run *run, struct worker *worker, int number, int arithmetic,
                       uint64_t seed, const struct trial_result *result) {
    struct tally *tally = &run->tallies[number][arithmetic];
    (void)pthread_mutex_lock(&run->lock);
    tally->pairs++;
    tally->pixels += result->pixels;
    tally->agreeing += result->agreeing;
    tally->flips += result->flips;
    tally->worst = result->worst > tally->worst ? result->worst : tally->worst;
    tally->worst_flip =
        result->worst_flip > tally->worst_flip ? result->worst_flip : tally->worst_flip;
    tally->faults += result->fault != FAULT_NONE;
    bool is_reported =
        result->fault != FAULT_NONE && tally->faults <= REDUCED_MOST && run->reduced < REDUCED_ALL;
    run->reduced += is_reported;
    run->faults += result->fault != FAULT_NONE;
    (void)pthread_mutex_unlock(&run->lock);
    if (is_reported) {
        report(run, worker, &relations[number], arithmetic, seed, result);
    }
}

static void try_relations(struct run *run, struct worker *worker, uint64_t seed) {
    for (int number = 0; number < relation_count; number++) {
        const struct relation *relation = &relations[number];
        bool is_due =
            run->only == NULL ? seed % (uint64_t)relation->every == 0 : run->only == relation;
        for (int i = 0; i < RELATION_ARITHMETICS && is_due; i++) {
            struct trial_result result;
            if ((relation->arithmetics >> i & 1) == 0) {
                continue;
            }
            trial_run(relation, i, seed, &worker->cache, &worker->room, &result);
            if (result.applies) {
                add_result(run, worker, number, i, seed, &result);
            }
        }
    }
}

static void try_seed(void *context, unsigned seed) {
    struct run *run = context;
    struct worker *worker = time(NULL) < run->end ? malloc(sizeof *worker) : NULL;
    if (worker == NULL) {
        run->stop = 1;
        return;
    }
    generate_scene(&worker->scene, seed);
    bool good = trial_start(&worker->cache, &worker->scene);
    (void)pthread_mutex_lock(&run->lock);
    run->seeds++;
    if (run->writes) {
        char name[16];
        (void)snprintf(name, sizeof name, "%u", seed);
        write_file(run, name, &worker->scene);
    }
    if (good) {
        coverage_add(&run->coverage, &worker->scene, worker->cache.form.compiled);
    } else if (run->refused++ == 0) {
        (void)snprintf(run->refusal, sizeof run->refusal, "seed %u: %.220s", seed,
                       worker->cache.form.error.text);
    }
    (void)pthread_mutex_unlock(&run->lock);
    if (good) {
        if (!run->writes) {
            try_relations(run, worker, seed);
        }
        trial_end(&worker->cache);
    }
    free(worker);
}

/* ---- All seeds ------------------------------------------------------------------------------ */

/* Prints one relation's figures; returns whether they are as the rule wants them. */
static bool print_tally(int number, int arithmetic, const struct tally *tally) {
    double pixels = (double)tally->pixels;
    bool good = tally->faults == 0 && (double)tally->agreeing >= AGREEING_LEAST * pixels &&
                (double)tally->flips <= FLIPS_MOST * pixels;
    (void)printf("%-13s %-4s %6llu pairs %9llu pixels %8.4f %% agree %7.4f %% flips, worst %d, "
                 "%d; %llu faults%s\n",
                 relations[number].name, relation_arithmetic(arithmetic)->image->name,
                 (unsigned long long)tally->pairs, (unsigned long long)tally->pixels,
                 100 * (double)tally->agreeing / pixels, 100 * (double)tally->flips / pixels,
                 tally->worst, tally->worst_flip, (unsigned long long)tally->faults,
                 good ? "" : "  WRONG");
    return good;
}

static int print_run(const struct run *run) {
    int wrong = 0;
    for (int i = 0; i < relation_count; i++) {
        for (int j = 0; j < RELATION_ARITHMETICS; j++) {
            if (run->tallies[i][j].pixels > 0) {
                wrong += !print_tally(i, j, &run->tallies[i][j]);
            }
        }
    }
    (void)printf("%lu seeds from %u, %lu refused%s%s\ncovered, in scenes:", run->seeds, run->first,
                 run->refused, run->refused > 0 ? ", such as " : "", run->refusal);
    int missing = coverage_print(&run->coverage, stdout);
    bool is_bare = run->must_cover && missing > 0;
    (void)printf("relations: %d wrong, %lu faults%s\n", wrong, run->faults,
                 is_bare ? ", and some of what is to be covered is not" : "");
    return wrong > 0 || is_bare;
}

/* ---- Arguments ------------------------------------------------------------------------------ */

static int refuse(const char *argument, const char *allowed) {
    (void)fprintf(stderr, "relations: %s: allowed is: %s\n", argument, allowed);
    return 2;
}

/* Reads a whole number of at most nine digits. */
static bool read_number(const char **text, unsigned *number) {
    int digits = 0;
    *number = 0;
    for (; **text >= '0' && **text <= '9' && digits < 9; ++*text, digits++) {
        *number = *number * 10 + (unsigned)(**text - '0');
    }
    return digits > 0;
}

static bool read_seeds(struct run *run, const char *text) {
    return read_number(&text, &run->first) && *text++ == ':' && read_number(&text, &run->last) &&
           *text == '\0' && run->first < run->last;
}

static bool read_relation(struct run *run, const char *text) {
    for (int i = 0; i < relation_count; i++) {
        if (strcmp(relations[i].name, text) == 0) {
            run->only = &relations[i];
        }
    }
    return run->only != NULL;
}

static bool read_most(const char *text, unsigned most, unsigned *number) {
    return read_number(&text, number) && *text == '\0' && *number >= 1 && *number <= most;
}

/* Returns 0, or the exit status of a refusal. */
static int read_argument(struct run *run, const char *argument, unsigned *seconds) {
    const char *value = strchr(argument, '=');
    size_t letters = value != NULL ? (size_t)(value++ - argument) : 0;
    if (letters == 5 && strncmp(argument, "SEEDS", 5) == 0) {
        return read_seeds(run, value) ? 0 : refuse(argument, "SEEDS=A:B with A below B");
    }
    if (letters == 8 && strncmp(argument, "RELATION", 8) == 0) {
        return read_relation(run, value) ? 0
                                         : refuse(argument, "a name of docs/relations.md's table");
    }
    if (letters == 7 && strncmp(argument, "SECONDS", 7) == 0) {
        return read_most(value, 1000000, seconds) ? 0 : refuse(argument, "SECONDS=1..1000000");
    }
    if (letters == 4 && strncmp(argument, "JOBS", 4) == 0) {
        return read_most(value, 256, &run->jobs) ? 0 : refuse(argument, "JOBS=1..256");
    }
    if (strcmp(argument, "COVERED=yes") == 0) {
        run->must_cover = true;
        return 0;
    }
    if (strcmp(argument, "WRITE=yes") == 0) {
        run->writes = true;
        return 0;
    }
    return refuse(argument, "SEEDS=A:B, RELATION=NAME, SECONDS=S, JOBS=N, COVERED=yes, WRITE=yes");
}

int main(int argc, char **argv) {
    static struct run run;
    unsigned seconds = 1000000;
    run.last = 100;
    run.jobs = 2;
    if (argc < 2 || strchr(argv[1], '=') != NULL) {
        return refuse("no folder", "relations OUT [SEEDS=A:B] [RELATION=NAME] [SECONDS=S] ...");
    }
    run.out = argv[1];
    for (int i = 2; i < argc; i++) {
        int status = read_argument(&run, argv[i], &seconds);
        if (status != 0) {
            return status;
        }
    }
    if (mkdir(run.out, 0777) != 0 && errno != EEXIST) {
        (void)fprintf(stderr, "relations: %s: %s\n", run.out, strerror(errno));
        return 2;
    }
    (void)pthread_mutex_init(&run.lock, NULL);
    run.end = time(NULL) + (time_t)seconds;
    parallel_for(run.first, run.last, run.jobs, try_seed, &run, &run.stop);
    return print_run(&run);
}
