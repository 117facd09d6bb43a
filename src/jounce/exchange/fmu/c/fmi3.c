/* FMI 3.0 over core.h: model exchange and co-simulation. */
#include "core.h"
#include "fmi3Functions.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define I ((JnInstance *)c)
#define UNUSED(x) (void)(x)

static fmi3Status say(JnInstance *c, fmi3Status status, const char *text) {
    if (c->callback)
        ((fmi3LogMessageCallback)c->callback)(c->environment, status,
                                              status == fmi3Error ? "logStatusError" : "logStatusWarning", text);
    return status;
}
static fmi3Status fail(fmi3Instance c, const char *text) { return say(I, fmi3Error, text); }
static fmi3Status told(fmi3Instance c, bool good) { return good ? fmi3OK : fail(c, I->why); }

static fmi3Instance make(fmi3String name, fmi3String token, fmi3InstanceEnvironment environment,
                         fmi3LogMessageCallback log, bool cosim) {
    JnInstance *c = calloc(1, sizeof *c);
    if (!c) return NULL;
    c->callback = (void *)log, c->environment = environment, c->cosim = cosim;
    strncpy(c->name, name ? name : "", sizeof c->name - 1);
    if (!token || strcmp(token, JN_TOKEN)) {
        say(c, fmi3Error, "the instantiation token is not that of the model description");
        free(c);
        return NULL;
    }
    jn_reset(c);
    return c;
}

const char *fmi3GetVersion(void) { return "3.0"; }
fmi3Status fmi3SetDebugLogging(fmi3Instance c, fmi3Boolean on, size_t n, const fmi3String categories[]) {
    return UNUSED(c), UNUSED(on), UNUSED(n), UNUSED(categories), fmi3OK;
}
fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                          fmi3LogMessageCallback log) {
    UNUSED(resources), UNUSED(visible), UNUSED(logging);
    return make(name, token, environment, log, false);
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early,
                                         const fmi3ValueReference intermediate[], size_t n_intermediate,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update) {
    UNUSED(resources), UNUSED(visible), UNUSED(logging), UNUSED(early), UNUSED(intermediate), UNUSED(n_intermediate);
    UNUSED(update), UNUSED(event_mode); /* hasEventMode is false: the importer may not use it */
    return make(name, token, environment, log, true);
}
fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                               fmi3ClockUpdateCallback clock, fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
    UNUSED(name), UNUSED(token), UNUSED(resources), UNUSED(visible), UNUSED(logging), UNUSED(environment);
    UNUSED(log), UNUSED(clock), UNUSED(lock), UNUSED(unlock);
    return NULL;
}
void fmi3FreeInstance(fmi3Instance c) { free(c); }

fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean given, fmi3Float64 tolerance, fmi3Float64 start,
                                       fmi3Boolean stop_given, fmi3Float64 stop) {
    if (!isfinite(start)) return fail(c, "the start time is no finite number");
    if (given && tolerance > 0.0) I->s.tolerance = tolerance;
    if (stop_given) I->stop = stop;
    return jn_start_at(I, start), fmi3OK;
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance c) { return told(c, jn_initialise(I)); }
fmi3Status fmi3EnterEventMode(fmi3Instance c) { return UNUSED(c), fmi3OK; }
fmi3Status fmi3Terminate(fmi3Instance c) { return I->s.ready = false, fmi3OK; }
fmi3Status fmi3Reset(fmi3Instance c) { return jn_reset(I), fmi3OK; }

fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Float64 v[], size_t nv) {
    if (n != nv) return fail(c, "all variables are scalars: as many values as references");
    for (size_t i = 0; i < n; i++)
        if (!jn_get(I, vr[i], &v[i])) return fail(c, I->why);
    return fmi3OK;
}
fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Float64 v[], size_t nv) {
    if (n != nv) return fail(c, "all variables are scalars: as many values as references");
    for (size_t i = 0; i < n; i++)
        if (!jn_set(I, vr[i], v[i])) return fail(c, I->why);
    return fmi3OK;
}
fmi3Status fmi3GetBoolean(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Boolean v[], size_t nv) {
    if (n != nv) return fail(c, "all variables are scalars: as many values as references");
    for (size_t i = 0; i < n; i++)
        if (!jn_get_boolean(I, vr[i], &v[i])) return fail(c, I->why);
    return fmi3OK;
}
fmi3Status fmi3SetBoolean(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Boolean v[], size_t nv) {
    if (n != nv) return fail(c, "all variables are scalars: as many values as references");
    for (size_t i = 0; i < n; i++)
        if (!jn_set_boolean(I, vr[i], v[i])) return fail(c, I->why);
    return fmi3OK;
}
#define NONE(name, type)                                                                                               \
    fmi3Status fmi3Get##name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, type v[], size_t nv) {           \
        return UNUSED(vr), UNUSED(v), n || nv ? fail(c, "no variables of type " #name) : fmi3OK;                       \
    }                                                                                                                  \
    fmi3Status fmi3Set##name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const type v[], size_t nv) {     \
        return UNUSED(vr), UNUSED(v), n || nv ? fail(c, "no variables of type " #name) : fmi3OK;                       \
    }
NONE(Float32, fmi3Float32)
NONE(Int8, fmi3Int8)
NONE(UInt8, fmi3UInt8)
NONE(Int16, fmi3Int16)
NONE(UInt16, fmi3UInt16)
NONE(Int32, fmi3Int32)
NONE(UInt32, fmi3UInt32)
NONE(Int64, fmi3Int64)
NONE(UInt64, fmi3UInt64)
NONE(String, fmi3String)
fmi3Status fmi3GetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, size_t sizes[], fmi3Binary v[],
                         size_t nv) {
    return UNUSED(vr), UNUSED(sizes), UNUSED(v), n || nv ? fail(c, "no binary variables") : fmi3OK;
}
fmi3Status fmi3SetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const size_t sizes[],
                         const fmi3Binary v[], size_t nv) {
    return UNUSED(vr), UNUSED(sizes), UNUSED(v), n || nv ? fail(c, "no binary variables") : fmi3OK;
}
fmi3Status fmi3GetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n, fmi3Clock v[]) {
    return UNUSED(vr), UNUSED(v), n ? fail(c, "no clocks") : fmi3OK;
}
fmi3Status fmi3SetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Clock v[]) {
    return UNUSED(vr), UNUSED(v), n ? fail(c, "no clocks") : fmi3OK;
}
fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance c, fmi3ValueReference vr, size_t *n) {
    return UNUSED(vr), UNUSED(n), fail(c, "dependencies are in the model description");
}
fmi3Status fmi3GetVariableDependencies(fmi3Instance c, fmi3ValueReference vr, size_t a[], fmi3ValueReference b[],
                                       size_t d[], fmi3DependencyKind e[], size_t n) {
    UNUSED(vr), UNUSED(a), UNUSED(b), UNUSED(d), UNUSED(e), UNUSED(n);
    return fail(c, "dependencies are in the model description");
}

/* ---- states saved and restored ---- */

fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState *state) {
    if (!*state) *state = malloc(sizeof(JnState));
    if (!*state) return fail(c, "no memory");
    return memcpy(*state, &I->s, sizeof(JnState)), fmi3OK;
}
fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState state) { return memcpy(&I->s, state, sizeof(JnState)), fmi3OK; }
fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState *state) {
    UNUSED(c);
    free(*state);
    *state = NULL;
    return fmi3OK;
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t *size) {
    return UNUSED(c), UNUSED(state), *size = sizeof(JnState), fmi3OK;
}
fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
    if (size < sizeof(JnState)) return fail(c, "not enough room for a state");
    return memcpy(bytes, state, sizeof(JnState)), fmi3OK;
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const fmi3Byte bytes[], size_t size, fmi3FMUState *state) {
    if (size != sizeof(JnState)) return fail(c, "not a state of this model");
    if (!*state) *state = malloc(sizeof(JnState));
    if (!*state) return fail(c, "no memory");
    return memcpy(*state, bytes, sizeof(JnState)), fmi3OK;
}

/* ---- derivatives ---- */

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference of[], size_t n_of,
                                        const fmi3ValueReference by[], size_t n_by, const fmi3Float64 seed[],
                                        size_t n_seed, fmi3Float64 sensitivity[], size_t n_sensitivity) {
    if (n_by != n_seed || n_of != n_sensitivity) return fail(c, "all variables are scalars: as many seeds as references");
    return told(c, jn_directional(I, of, n_of, by, n_by, seed, sensitivity));
}
fmi3Status fmi3GetAdjointDerivative(fmi3Instance c, const fmi3ValueReference of[], size_t n_of,
                                    const fmi3ValueReference by[], size_t n_by, const fmi3Float64 seed[],
                                    size_t n_seed, fmi3Float64 sensitivity[], size_t n_sensitivity) {
    if (n_of != n_seed || n_by != n_sensitivity) return fail(c, "all variables are scalars: as many seeds as references");
    return told(c, jn_adjoint_of(I, of, n_of, by, n_by, seed, sensitivity));
}

/* ---- clocks and configuration: none ---- */

fmi3Status fmi3EnterConfigurationMode(fmi3Instance c) { return fail(c, "no structural parameters"); }
fmi3Status fmi3ExitConfigurationMode(fmi3Instance c) { return fail(c, "no structural parameters"); }
#define CLOCK(name, ...)                                                                                               \
    fmi3Status name(fmi3Instance c, const fmi3ValueReference vr[], size_t n, __VA_ARGS__)
#define NO_CLOCK { return UNUSED(vr), n ? fail(c, "no clocks") : fmi3OK; }
CLOCK(fmi3GetIntervalDecimal, fmi3Float64 a[], fmi3IntervalQualifier b[]) { UNUSED(a), UNUSED(b); NO_CLOCK }
CLOCK(fmi3GetIntervalFraction, fmi3UInt64 a[], fmi3UInt64 b[], fmi3IntervalQualifier d[]) {
    UNUSED(a), UNUSED(b), UNUSED(d);
    NO_CLOCK
}
CLOCK(fmi3GetShiftDecimal, fmi3Float64 a[]) { UNUSED(a); NO_CLOCK }
CLOCK(fmi3GetShiftFraction, fmi3UInt64 a[], fmi3UInt64 b[]) { UNUSED(a), UNUSED(b); NO_CLOCK }
CLOCK(fmi3SetIntervalDecimal, const fmi3Float64 a[]) { UNUSED(a); NO_CLOCK }
CLOCK(fmi3SetIntervalFraction, const fmi3UInt64 a[], const fmi3UInt64 b[]) { UNUSED(a), UNUSED(b); NO_CLOCK }
CLOCK(fmi3SetShiftDecimal, const fmi3Float64 a[]) { UNUSED(a); NO_CLOCK }
CLOCK(fmi3SetShiftFraction, const fmi3UInt64 a[], const fmi3UInt64 b[]) { UNUSED(a), UNUSED(b); NO_CLOCK }
fmi3Status fmi3ActivateModelPartition(fmi3Instance c, fmi3ValueReference clock, fmi3Float64 t) {
    return UNUSED(clock), UNUSED(t), fail(c, "no scheduled execution");
}

/* ---- model exchange ---- */

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance c) { return UNUSED(c), fmi3OK; }
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals,
                                    fmi3Boolean *values, fmi3Boolean *next_given, fmi3Float64 *next) {
    *again = *terminate = *nominals = *values = false;
    if (!jn_event(I)) return fail(c, I->why);
    *next_given = JN_COMMANDS > 0;
    *next = JN_COMMANDS ? jn_next_instant(I) : 0.0;
    return fmi3OK;
}
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) { return UNUSED(c), fmi3OK; }
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, fmi3Boolean no_set, fmi3Boolean *event, fmi3Boolean *terminate) {
    UNUSED(no_set);
    *event = *terminate = false;
    return jn_accept(I), fmi3OK;
}
fmi3Status fmi3SetTime(fmi3Instance c, fmi3Float64 t) { return told(c, jn_set_time(I, t)); }
fmi3Status fmi3SetContinuousStates(fmi3Instance c, const fmi3Float64 x[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    memcpy(I->s.x, x, sizeof I->s.x);
    I->s.known = 0;
    return fmi3OK;
}
/* Numbers that are not finite make the importer take a smaller step. */
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, fmi3Float64 dx[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    if (!jn_evaluate(I, RATES)) return say(I, fmi3Discard, I->why);
    return memcpy(dx, I->s.dx, sizeof I->s.dx), fmi3OK;
}
fmi3Status fmi3GetEventIndicators(fmi3Instance c, fmi3Float64 z[], size_t n) {
    if (n != JN_NM) return fail(c, "wrong number of event indicators");
    if (!jn_evaluate(I, INDICATORS)) return say(I, fmi3Discard, I->why);
    return memcpy(z, I->s.z, JN_NM * sizeof(double)), fmi3OK;
}
fmi3Status fmi3GetContinuousStates(fmi3Instance c, fmi3Float64 x[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    return memcpy(x, I->s.x, sizeof I->s.x), fmi3OK;
}
fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, fmi3Float64 x[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    return memcpy(x, jn_scale, sizeof jn_scale), fmi3OK;
}
fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *n) { return UNUSED(c), *n = JN_NM, fmi3OK; }
fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *n) { return UNUSED(c), *n = JN_NX, fmi3OK; }

/* ---- co-simulation ---- */

fmi3Status fmi3EnterStepMode(fmi3Instance c) { return UNUSED(c), fmi3OK; }
fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, const fmi3ValueReference vr[], size_t n, const fmi3Int32 orders[],
                                    fmi3Float64 v[], size_t nv) {
    return UNUSED(vr), UNUSED(orders), UNUSED(v), UNUSED(nv), n ? fail(c, "maxOutputDerivativeOrder is 0") : fmi3OK;
}
fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 t, fmi3Float64 h, fmi3Boolean no_set, fmi3Boolean *event,
                      fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *reached) {
    UNUSED(no_set);
    *event = *terminate = *early = false;
    *reached = I->s.t;
    if (!jn_may_step(I, t, h)) return fail(c, I->why);
    if (h == 0.0) return say(I, fmi3Warning, "a step without length, which changes nothing");
    bool good = jn_advance(I, t + h);
    *reached = I->s.t;
    return told(c, good);
}
