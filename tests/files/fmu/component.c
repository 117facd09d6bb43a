/* A component FMU for tests, FMI 2.0 or 3.0 by -DVERSION: a skyhook for a damper, and mistakes on request.
   Inputs: 0 v_body [mm/s], 1 v_strut [m/s], 6 spare. Parameters: 2 gain [kN*s/m], 3 mistake (integer), 7 is_on (Boolean).
   A spring or tyre, too: inputs 9 deflection [mm], 10 rate [m/s]; parameters 11 stiffness [N/mm], 12 damping [N*s/m],
   13 preload [N], 14 cubic [N/m^3], 15 pulls (1: also below zero); output 16 load [N].
   Outputs: 4 coefficient [N*s/m], 5 force [daN] of a damper with the gain, 8 a count of steps. */
#ifndef _WIN32
#define _POSIX_C_SOURCE 200809L
#include <signal.h>
#endif
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if VERSION == 2
#include "fmi2Functions.h"
#define F(name) fmi2##name
typedef fmi2Component C;
typedef fmi2ValueReference R;
typedef fmi2Status S;
enum { GOOD = fmi2OK, BAD = fmi2Error };
#else
#include "fmi3Functions.h"
#define F(name) fmi3##name
typedef fmi3Instance C;
typedef fmi3ValueReference R;
typedef fmi3Status S;
enum { GOOD = fmi3OK, BAD = fmi3Error };
#endif

typedef struct {
    double x[17];
    int mistake, on;
    const void *callbacks, *logger, *environment;
} It;

static void say(It *it, const char *text) {
#if VERSION == 2
    const fmi2CallbackFunctions *f = it->callbacks;
    f->logger(f->componentEnvironment, "it", fmi2Error, "error", "%s", text);
    (void)it;
#else
    ((fmi3LogMessageCallback)it->logger)((void *)it->environment, fmi3Error, "error", text);
#endif
}
static It *made(void) {
    It *it = calloc(1, sizeof *it);
    it->x[2] = 1.0, it->x[15] = 1.0, it->on = 1;
    return it;
}
static S step(It *it) {
    if (it->mistake == 1 && it->x[8] >= 5) abort();
    if (it->mistake == 2 && it->x[8] >= 5) return say(it, "the valve is stuck"), BAD;
    if (it->mistake == 3) { FILE *f = fopen("notes.txt", "w"); fputs("here", f); fclose(f); }
    if (it->mistake == 4) puts("+++ noise on standard output +++"), fflush(stdout);
    if (it->mistake == 5) it->x[0] = NAN;
    if (it->mistake == 6) for (;;) {}
    if (it->mistake == 7) it->x[0] = INFINITY;
#ifndef _WIN32
    if (it->mistake == 8) kill(0, SIGKILL);
#endif
    double body = 1e-3 * it->x[0], v = it->x[1], c = 1e3 * it->x[2], force = -c * body;
    it->x[4] = it->on && force * v > 0.0 ? force * v / fmax(v * v, 1e-12) : 0.0;
    if (it->mistake == 5) it->x[4] = NAN;
    if (it->mistake == 7) it->x[4] = INFINITY;
    it->x[5] = 0.1 * c * v;
    double d = 1e-3 * it->x[9];
    it->x[16] = it->x[13] + 1e3 * it->x[11] * d + it->x[14] * d * d * d + it->x[12] * it->x[10];
    if (!it->x[15] && (d <= 0.0 || it->x[16] < 0.0)) it->x[16] = 0.0;
    it->x[8] += 1;
    return GOOD;
}

#if VERSION == 2
C fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                  const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean logging) {
    It *it = made();
    it->callbacks = f;
    if (strcmp(guid, "component")) return say(it, "another guid"), NULL;
    if (strncmp(resources, "file:///", 8)) return say(it, "resources are no URI"), NULL;
    return it;
}
S fmi2SetupExperiment(C c, fmi2Boolean g, double t, double s, fmi2Boolean e, double p) { return GOOD; }
S fmi2EnterInitializationMode(C c) { return GOOD; }
S fmi2DoStep(C c, double t, double h, fmi2Boolean n) { return step(c); }
S fmi2GetReal(C c, const R r[], size_t n, double v[]) { for (size_t i = 0; i < n; i++) v[i] = ((It *)c)->x[r[i]]; return GOOD; }
S fmi2SetReal(C c, const R r[], size_t n, const double v[]) { for (size_t i = 0; i < n; i++) ((It *)c)->x[r[i]] = v[i]; return GOOD; }
S fmi2SetInteger(C c, const R r[], size_t n, const int v[]) { ((It *)c)->mistake = v[0]; return GOOD; }
S fmi2SetBoolean(C c, const R r[], size_t n, const fmi2Boolean v[]) { ((It *)c)->on = v[0]; return GOOD; }
#else
C fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
                              fmi3Boolean events, fmi3Boolean early, const R r[], size_t n, void *environment,
                              fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) {
    It *it = made();
    it->logger = log, it->environment = environment;
    if (strcmp(token, "component")) return say(it, "another token"), NULL;
    if (resources[0] == 'f' || resources[strlen(resources) - 1] != '/') return say(it, "resources are no folder"), NULL;
    return it;
}
S fmi3EnterInitializationMode(C c, fmi3Boolean g, double t, double s, fmi3Boolean e, double p) { return GOOD; }
S fmi3DoStep(C c, double t, double h, fmi3Boolean n, fmi3Boolean *a, fmi3Boolean *b, fmi3Boolean *d, double *last) {
    *a = *b = *d = 0, *last = t + h;
    return step(c);
}
S fmi3GetFloat64(C c, const R r[], size_t n, double v[], size_t m) { for (size_t i = 0; i < n; i++) v[i] = ((It *)c)->x[r[i]]; return GOOD; }
S fmi3SetFloat64(C c, const R r[], size_t n, const double v[], size_t m) { for (size_t i = 0; i < n; i++) ((It *)c)->x[r[i]] = v[i]; return GOOD; }
S fmi3SetInt32(C c, const R r[], size_t n, const int v[], size_t m) { ((It *)c)->mistake = v[0]; return GOOD; }
S fmi3SetBoolean(C c, const R r[], size_t n, const fmi3Boolean v[], size_t m) { ((It *)c)->on = v[0]; return GOOD; }
#endif
S F(ExitInitializationMode)(C c) { return GOOD; }
S F(Terminate)(C c) { return GOOD; }
void F(FreeInstance)(C c) { free(c); }
