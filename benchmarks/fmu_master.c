/* A master in C: what an FMU costs by itself, without a language in between. FMI 3.0; times are processor time in s. */
#define _POSIX_C_SOURCE 199309L
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>

typedef int Set(void *, const uint32_t *, size_t, const double *, size_t);
typedef int Get(void *, const uint32_t *, size_t, double *, size_t);
typedef int Step(void *, double, double, bool, bool *, bool *, bool *, double *);
typedef int SetStates(void *, const double *, size_t);
typedef int GetRates(void *, double *, size_t);
typedef void Rate(const double *, const double *, const double *, const double *, double *);

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Co-simulation over a sine of 0.5 mm and 10 Hz: heights and rates are set, one channel is read; below 0: refused. */
double steps(Set *set, Step *step, Get *get, void *c, const uint32_t *in, size_t n, uint32_t out, int count, double h) {
    double *u = malloc(sizeof *u * n * (size_t)count), y, reached, begin;
    bool event, end, early;
    int worst = 0;
    if (u == NULL) return -1.0;
    for (int i = 0; i < count; i++) /* sines are no part of the FMU */
        for (size_t k = 0; k < n; k++) u[(size_t)i * n + k] = k % 2 ? 0.0314 * cos(62.8 * h * i) : 5e-4 * sin(62.8 * h * i);
    begin = now();
    for (int i = 0; i < count && worst <= 1; i++) {
        worst = set(c, in, n, u + (size_t)i * n, n) | step(c, h * i, h, true, &event, &end, &early, &reached);
        worst |= get(c, &out, 1, &y, 1);
    }
    begin = now() - begin;
    free(u);
    return worst > 1 ? -1.0 : begin;
}

/* Model exchange: states are set, rates are read. */
double rates(SetStates *set, GetRates *get, void *c, double *x, double *dx, size_t n, int count) {
    double begin = now();
    for (int i = 0; i < count; i++) {
        if (set(c, x, n) > 1 || get(c, dx, n) > 1) return -1.0;
        x[0] += 1e-18 * dx[0];
    }
    return now() - begin;
}

/* The same from machine code of jounce. */
double native(Rate *rate, double *x, const double *u, const double *p, const double *m, double *dx, int count) {
    double begin = now();
    for (int i = 0; i < count; i++) {
        rate(x, u, p, m, dx);
        x[0] += 1e-18 * dx[0];
    }
    return now() - begin;
}
