/* FMI 2.0 over core.h: model exchange and co-simulation. */
#include "core.h"
#include "fmi2Functions.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define I ((JnInstance *)c)
#define UNUSED(x) (void)(x)

static fmi2Status say(JnInstance *c, fmi2Status status, const char *text) {
    const fmi2CallbackFunctions *f = c->callback;
    if (f && f->logger)
        f->logger(f->componentEnvironment, c->name, status,
                  status == fmi2Error ? "logStatusError" : "logStatusWarning", "%s", text);
    return status;
}
static fmi2Status fail(fmi2Component c, const char *text) { return say(I, fmi2Error, text); }
static fmi2Status told(fmi2Component c, bool good) { return good ? fmi2OK : fail(c, I->why); }

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return "2.0"; }
fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t n, const fmi2String categories[]) {
    return UNUSED(c), UNUSED(on), UNUSED(n), UNUSED(categories), fmi2OK;
}
fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean logging) {
    JnInstance *c = calloc(1, sizeof *c);
    UNUSED(resources), UNUSED(visible), UNUSED(logging);
    if (!c) return NULL;
    c->callback = (void *)functions, c->cosim = type == fmi2CoSimulation;
    strncpy(c->name, name ? name : "", sizeof c->name - 1);
    if (!guid || strcmp(guid, JN_TOKEN)) {
        say(c, fmi2Error, "the GUID is not that of the model description");
        free(c);
        return NULL;
    }
    jn_reset(c);
    return c;
}
void fmi2FreeInstance(fmi2Component c) { free(c); }
fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean given, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean stop_given, fmi2Real stop) {
    if (!isfinite(start)) return fail(c, "the start time is no finite number");
    if (given && tolerance > 0.0) I->s.tolerance = tolerance;
    if (stop_given) I->stop = stop;
    return jn_start_at(I, start), fmi2OK;
}
fmi2Status fmi2EnterInitializationMode(fmi2Component c) { return UNUSED(c), fmi2OK; }
fmi2Status fmi2ExitInitializationMode(fmi2Component c) { return told(c, jn_initialise(I)); }
fmi2Status fmi2Terminate(fmi2Component c) { return I->s.ready = false, fmi2OK; }
fmi2Status fmi2Reset(fmi2Component c) { return jn_reset(I), fmi2OK; }

fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Real v[]) {
    for (size_t i = 0; i < n; i++)
        if (!jn_get(I, vr[i], &v[i])) return fail(c, I->why);
    return fmi2OK;
}
fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Real v[]) {
    for (size_t i = 0; i < n; i++)
        if (!jn_set(I, vr[i], v[i])) return fail(c, I->why);
    return fmi2OK;
}
fmi2Status fmi2GetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, fmi2Boolean v[]) {
    for (size_t i = 0; i < n; i++) {
        bool value = false;
        if (!jn_get_boolean(I, vr[i], &value)) return fail(c, I->why);
        v[i] = value;
    }
    return fmi2OK;
}
fmi2Status fmi2SetBoolean(fmi2Component c, const fmi2ValueReference vr[], size_t n, const fmi2Boolean v[]) {
    for (size_t i = 0; i < n; i++)
        if (!jn_set_boolean(I, vr[i], v[i] != fmi2False)) return fail(c, I->why);
    return fmi2OK;
}
#define NONE(name, type)                                                                                               \
    fmi2Status fmi2Get##name(fmi2Component c, const fmi2ValueReference vr[], size_t n, type v[]) {                     \
        return UNUSED(vr), UNUSED(v), n ? fail(c, "no variables of type " #name) : fmi2OK;                             \
    }                                                                                                                  \
    fmi2Status fmi2Set##name(fmi2Component c, const fmi2ValueReference vr[], size_t n, const type v[]) {               \
        return UNUSED(vr), UNUSED(v), n ? fail(c, "no variables of type " #name) : fmi2OK;                             \
    }
NONE(Integer, fmi2Integer)
NONE(String, fmi2String)

fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
    if (!*state) *state = malloc(sizeof(JnState));
    if (!*state) return fail(c, "no memory");
    return memcpy(*state, &I->s, sizeof(JnState)), fmi2OK;
}
fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) { return memcpy(&I->s, state, sizeof(JnState)), fmi2OK; }
fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
    UNUSED(c);
    free(*state);
    *state = NULL;
    return fmi2OK;
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
    return UNUSED(c), UNUSED(state), *size = sizeof(JnState), fmi2OK;
}
fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    if (size < sizeof(JnState)) return fail(c, "not enough room for a state");
    return memcpy(bytes, state, sizeof(JnState)), fmi2OK;
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state) {
    if (size != sizeof(JnState)) return fail(c, "not a state of this model");
    if (!*state) *state = malloc(sizeof(JnState));
    if (!*state) return fail(c, "no memory");
    return memcpy(*state, bytes, sizeof(JnState)), fmi2OK;
}
fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference of[], size_t n_of,
                                        const fmi2ValueReference by[], size_t n_by, const fmi2Real seed[],
                                        fmi2Real sensitivity[]) {
    return told(c, jn_directional(I, of, n_of, by, n_by, seed, sensitivity));
}

/* ---- model exchange ---- */

fmi2Status fmi2EnterEventMode(fmi2Component c) { return UNUSED(c), fmi2OK; }
fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) {
    memset(info, 0, sizeof *info);
    if (!jn_event(I)) return fail(c, I->why);
    info->nextEventTimeDefined = JN_COMMANDS > 0;
    info->nextEventTime = JN_COMMANDS ? jn_next_instant(I) : 0.0;
    return fmi2OK;
}
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) { return UNUSED(c), fmi2OK; }
fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_set, fmi2Boolean *event, fmi2Boolean *terminate) {
    UNUSED(no_set);
    *event = *terminate = fmi2False;
    return jn_accept(I), fmi2OK;
}
fmi2Status fmi2SetTime(fmi2Component c, fmi2Real t) { return told(c, jn_set_time(I, t)); }
fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real x[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    memcpy(I->s.x, x, sizeof I->s.x);
    I->s.known = 0;
    return fmi2OK;
}
/* Numbers that are not finite make the importer take a smaller step. */
fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real dx[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    if (!jn_evaluate(I, RATES)) return say(I, fmi2Discard, I->why);
    return memcpy(dx, I->s.dx, sizeof I->s.dx), fmi2OK;
}
fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real z[], size_t n) {
    if (n != JN_NM) return fail(c, "wrong number of event indicators");
    if (!jn_evaluate(I, INDICATORS)) return say(I, fmi2Discard, I->why);
    return memcpy(z, I->s.z, JN_NM * sizeof(double)), fmi2OK;
}
fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    return memcpy(x, I->s.x, sizeof I->s.x), fmi2OK;
}
fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real x[], size_t n) {
    if (n != JN_NX) return fail(c, "wrong number of states");
    return memcpy(x, jn_scale, sizeof jn_scale), fmi2OK;
}

/* ---- co-simulation ---- */

fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real v[]) {
    for (size_t i = 0; i < n; i++)
        if (!jn_set_input_rate(I, vr[i], order[i], v[i])) return fail(c, I->why);
    return fmi2OK;
}
fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real v[]) {
    UNUSED(vr), UNUSED(order), UNUSED(v);
    return n ? fail(c, "maxOutputDerivativeOrder is 0") : fmi2OK;
}
fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean no_set) {
    UNUSED(no_set);
    if (!jn_may_step(I, t, h)) return fail(c, I->why);
    if (h == 0.0) return say(I, fmi2Warning, "a step without length, which changes nothing");
    return told(c, jn_advance(I, t + h));
}
fmi2Status fmi2CancelStep(fmi2Component c) { return fail(c, "steps are not asynchronous"); }
#define STATUS(name, type)                                                                                             \
    fmi2Status name(fmi2Component c, const fmi2StatusKind s, type *v) {                                                \
        return UNUSED(c), UNUSED(s), UNUSED(v), fmi2Discard;                                                           \
    }
STATUS(fmi2GetStatus, fmi2Status)
STATUS(fmi2GetIntegerStatus, fmi2Integer)
STATUS(fmi2GetStringStatus, fmi2String)
fmi2Status fmi2GetRealStatus(fmi2Component c, const fmi2StatusKind s, fmi2Real *v) {
    if (s != fmi2LastSuccessfulTime) return fmi2Discard;
    return *v = I->s.t, fmi2OK;
}
fmi2Status fmi2GetBooleanStatus(fmi2Component c, const fmi2StatusKind s, fmi2Boolean *v) {
    UNUSED(c);
    if (s != fmi2Terminated) return fmi2Discard;
    return *v = fmi2False, fmi2OK;
}
