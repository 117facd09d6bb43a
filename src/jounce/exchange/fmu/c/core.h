/* A jounce model behind FMI: its instance, evaluation, events, equilibrium, co-simulation steps. No FMI types here.
 *
 * Two generated files give the model: model.h (counts, start values) and model.c (the functions jn_*, from graphs).
 *   x  coordinates, speeds, internal states          u  each track's value and its rates
 *   p  parameters                                    e  p, then what depends on p alone
 *   m  modes, 0 or 1, constant between events: m[i] = (switch[i] > 0)
 *   g  numbers of the controller's law               a controller sees outputs at fixed instants and sets tracks
 */
#ifndef JN_CORE_H
#define JN_CORE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "model.h"

#define JN_ROOM(n) ((n) > 0 ? (n) : 1) /* C has no arrays without elements */

/* of model.c */
void jn_derived(const double *p, double *e);
void jn_rate(const double *x, const double *u, const double *e, const double *m, double *dx);
void jn_output(const double *x, const double *u, const double *e, const double *m, double *y);
void jn_switch(const double *x, const double *u, const double *e, const double *m, double *z);
/* residual of the loops, their conditioning, then the state moved onto them: JN_NX + 2 numbers */
void jn_project(const double *x, const double *u, const double *e, const double *m, double *out);
void jn_loops(const double *x, const double *u, const double *e, const double *m, double *value, double *rate);
/* change of rates, outputs, indicators and projected states along a direction; and the transpose of that map */
void jn_slopes(const double *x, const double *u, const double *e, const double *m, const double *sx, const double *su,
               const double *sp, double *dx, double *y, double *z, double *on);
#if JN_ADJOINT
void jn_adjoint(const double *x, const double *u, const double *e, const double *m, const double *dx, const double *y,
                const double *z, const double *on, double *sx, double *su, double *sp);
#endif
#if JN_COMMANDS
void jn_law(const double *memory, const double *measured, const double *g, double *out); /* commands, next memory */
#endif

/* Value references, one block after another; variables.py lists them in the same order. */
enum {
    VR_TIME = 0,
    VR_X = 1,
    VR_DX = VR_X + JN_NX,
    VR_U = VR_DX + JN_NX,
    VR_P = VR_U + JN_NU,
    VR_G = VR_P + JN_NP,
    VR_Y = VR_G + JN_NG,
    VR_Z = VR_Y + JN_NY,
    VR_TOLERANCE = VR_Z + JN_NM, /* of co-simulation's integrator */
    VR_M,                        /* booleans */
    VR_AT_REST = VR_M + JN_NM
};

typedef struct { /* plain memory: copied as it is to save and to restore a state */
    double t, x[JN_NX], u[JN_ROOM(JN_NU)], p[JN_ROOM(JN_NP)], e[JN_ROOM(JN_NE)], m[JN_ROOM(JN_NM)];
    double g[JN_ROOM(JN_NG)], memory[JN_ROOM(JN_MEMORY)], rest[JN_ROOM(JN_MEASURED)]; /* rest: outputs in equilibrium */
    double t_start, t_input;          /* t_input: when the inputs were last set; co-simulation goes on from there */
    double step;                      /* of the integrator; 0: to be chosen */
    double tolerance;                 /* relative, of displacements */
    double before[JN_ROOM(JN_NT)], t_before; /* values of the tracks at the last communication point or accepted step */
    double set_at[JN_ROOM(JN_NT)], before_at[JN_ROOM(JN_NT)]; /* when a track got its value, and the one before */
    double dx[JN_NX], y[JN_ROOM(JN_NY)], z[JN_ROOM(JN_NM)];
    int64_t steps, rejected, events, instants;
    double slope[JN_ROOM(JN_NT)];     /* of tracks whose rate nobody gives: from the last two values */
    double rate_before[JN_ROOM(JN_NT)], bend[JN_ROOM(JN_NT)], bend_before[JN_ROOM(JN_NT)]; /* second rates, see bent() */
    bool rated[JN_ROOM(JN_NT)];       /* whether the rate of a track is given */
    bool at_rest, p_changed, ready; /* ready: initialised, and not terminated */
    int known; /* which of dx, y and z belong to t, x, u, p, m */
} JnState;

typedef struct {
    JnState s;
    bool cosim;
    double stop;                      /* INFINITY where the importer has told none */
    void *environment, *callback;
    char name[128];
    const char *why; /* what failed last */
} JnInstance;

void jn_reset(JnInstance *c);
void jn_start_at(JnInstance *c, double t);
bool jn_get(JnInstance *c, unsigned vr, double *value);     /* false: no such variable, or no finite number */
bool jn_set(JnInstance *c, unsigned vr, double value);      /* false: cannot be set, or no finite number */
bool jn_get_boolean(JnInstance *c, unsigned vr, bool *value);
bool jn_set_boolean(JnInstance *c, unsigned vr, bool value);
bool jn_set_input_rate(JnInstance *c, unsigned vr, int order, double value);
bool jn_set_time(JnInstance *c, double t);
enum { RATES = 1, OUTPUTS = 2, INDICATORS = 4 };
bool jn_evaluate(JnInstance *c, int what);                  /* dx, y or z of now */
bool jn_initialise(JnInstance *c);                          /* equilibrium if wanted, consistent modes */
void jn_accept(JnInstance *c);                              /* the importer's integrator has taken a step to here */
bool jn_event(JnInstance *c);                               /* modes follow their switches, the controller has its turn */
double jn_next_instant(const JnInstance *c);                /* of the controller; INFINITY without one */
bool jn_may_step(JnInstance *c, double t, double h);        /* whether a step of co-simulation is one that can be */
bool jn_advance(JnInstance *c, double t_end);               /* co-simulation step */
bool jn_directional(JnInstance *c, const unsigned *of, size_t n_of, const unsigned *by, size_t n_by, const double *seed,
                    double *sensitivity);
bool jn_adjoint_of(JnInstance *c, const unsigned *of, size_t n_of, const unsigned *by, size_t n_by, const double *seed,
                   double *sensitivity);
#endif
