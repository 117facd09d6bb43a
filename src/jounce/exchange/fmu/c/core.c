#include "core.h"
#include <math.h>
#include <string.h>

#define PULL 0.005 /* s: how fast an importer's integrator is pulled back onto the loops */
#define SETTLED 1e-11
#define UNBALANCED 1e-4 /* m/s^2 or rad/s^2: what rounding leaves of balances between very stiff parts */
#define STRIDE 0.05 /* m or rad: longest step of a mechanism towards its equilibrium */

static bool failed(JnInstance *c, const char *why) { return c->why = why, false; }

/* Whether a reference lies in a block, which may be empty. */
static bool within(unsigned vr, unsigned first, unsigned next) { return vr >= first && vr < next; }

static double larger(double a, double b) { return a > b ? a : b; } /* fmax() is a call */
static double lesser(double a, double b) { return a < b ? a : b; }

static bool finite_all(const double *a, int n) {
    for (int i = 0; i < n; i++)
        if (!isfinite(a[i])) return false;
    return true;
}

/* ---- variables ---------------------------------------------------------------------------------------------- */

void jn_reset(JnInstance *c) {
    JnState *s = &c->s;
    c->stop = INFINITY;
    memset(s, 0, sizeof *s);
    memcpy(s->x, jn_x0, sizeof jn_x0);
    memcpy(s->u, jn_u0, sizeof jn_u0);
    memcpy(s->p, jn_p0, sizeof jn_p0);
    memcpy(s->m, jn_m0, sizeof jn_m0);
    memcpy(s->g, jn_g0, sizeof jn_g0);
    memcpy(s->memory, jn_memory0, sizeof jn_memory0);
    memcpy(s->rest, jn_rest0, sizeof jn_rest0);
    for (int i = 0; i < JN_COMMANDS; i++) s->rated[jn_command[i]] = true; /* a command holds */
    s->tolerance = 1e-5;
    s->at_rest = JN_AT_REST;
    s->p_changed = true;
}

void jn_start_at(JnInstance *c, double t) {
    c->s.t = c->s.t_start = c->s.t_input = c->s.t_before = t;
    c->s.known = 0;
}

static void parameters(JnState *s) {
    if (s->p_changed) jn_derived(s->p, s->e);
    s->p_changed = false;
}

/* Inputs at a time. Between the points at which co-simulation is told them, each track goes on with its rates. */
static const double *inputs(const JnInstance *c, double t, double *u) {
    const JnState *s = &c->s;
    double h = c->cosim ? t - s->t_input : 0.0;
    for (int i = 0; i < JN_NT; i++) {
        const double *from = s->u + i * JN_ORDER;
        double *to = u + i * JN_ORDER, rate = from[1], second = JN_ORDER > 2 ? from[JN_ORDER - 1] : 0.0;
        double bend = second != 0.0 ? second : s->bend[i];
        if (!s->rated[i]) {
            rate = s->slope[i];
            /* Importers evaluate at other times than those at which they set inputs: a difference of two values belongs
               to the times of the values. */
            if (!c->cosim && s->set_at[i] > s->before_at[i])
                rate = (from[0] - s->before[i]) / (s->set_at[i] - s->before_at[i]);
        }
        to[0] = from[0] + h * (rate + 0.5 * h * bend);
        to[1] = rate + h * bend;
        if (JN_ORDER > 2) to[JN_ORDER - 1] = second;
    }
    return u;
}

static void rate_at(JnInstance *c, double t, const double *x, double *dx) {
    double u[JN_ROOM(JN_NU)];
    jn_rate(x, inputs(c, t, u), c->s.e, c->s.m, dx);
}

static void onto_loops(JnInstance *c, const double *u) {
#if JN_PROJECTS
    double on[JN_NX + 2];
    jn_project(c->s.x, u, c->s.e, c->s.m, on);
    memcpy(c->s.x, on + 2, sizeof c->s.x);
#else
    (void)c, (void)u;
#endif
}

/* Rates, channels or indicators of now, each only when somebody asks: an importer's stages want rates alone. */
bool jn_evaluate(JnInstance *c, int what) {
    JnState *s = &c->s;
    double u[JN_ROOM(JN_NU)];
    if (s->known & what) return true;
    parameters(s);
    inputs(c, s->t, u);
    if (what == RATES) {
        jn_rate(s->x, u, s->e, s->m, s->dx);
#if JN_PROJECTS /* the importer integrates redundant coordinates and knows nothing of loops */
        if (!c->cosim) {
            double on[JN_NX + 2];
            jn_project(s->x, u, s->e, s->m, on);
            for (int i = 0; i < JN_NX; i++) s->dx[i] += (on[i + 2] - s->x[i]) / PULL;
        }
#endif
        if (!finite_all(s->dx, JN_NX)) return failed(c, "the rates are no finite numbers");
    } else if (what == OUTPUTS) jn_output(s->x, u, s->e, s->m, s->y);
    else {
        jn_switch(s->x, u, s->e, s->m, s->z);
        /* An importer may stop where an indicator is exactly zero, which is on no side of it, and never come back:
           the indicator vanishes only when the switch is a little beyond. */
        for (int i = 0; i < JN_NM && !c->cosim; i++) s->z[i] += s->m[i] > 0.0 ? jn_band[i] : -jn_band[i];
        if (!finite_all(s->z, JN_NM)) return failed(c, "the event indicators are no finite numbers");
    }
    return s->known |= what, true;
}

bool jn_get(JnInstance *c, unsigned vr, double *value) {
    JnState *s = &c->s;
    double u[JN_ROOM(JN_NU)];
    if (vr == VR_TIME) *value = s->t;
    else if (vr < VR_DX) *value = s->x[vr - VR_X];
    else if (within(vr, VR_U, VR_P)) *value = inputs(c, s->t, u)[vr - VR_U];
    else if (within(vr, VR_P, VR_G)) *value = s->p[vr - VR_P];
    else if (within(vr, VR_G, VR_Y)) *value = s->g[vr - VR_G];
    else if (vr == VR_TOLERANCE) *value = s->tolerance;
    else if (vr > VR_TOLERANCE) return failed(c, "no such real variable");
    else if (!jn_evaluate(c, vr < VR_U ? RATES : vr < VR_Z ? OUTPUTS : INDICATORS)) return false;
    else *value = vr < VR_U ? s->dx[vr - VR_DX] : vr < VR_Z ? s->y[vr - VR_Y] : s->z[vr - VR_Z];
    return true;
}

bool jn_set(JnInstance *c, unsigned vr, double value) {
    JnState *s = &c->s;
    if (!isfinite(value)) return failed(c, "a value is no finite number");
    if (within(vr, VR_X, VR_DX)) s->x[vr - VR_X] = value;
    else if (within(vr, VR_U, VR_P)) {
        int input = (int)(vr - VR_U);
        double u[JN_ROOM(JN_NU)];
        if (s->t_input != s->t) { /* tracks that are not set now go on from where they are */
            memcpy(s->u, inputs(c, s->t, u), JN_NU * sizeof(double));
            s->t_input = s->t;
        }
        /* Importers set inputs that nobody connected to zero: only a rate that is not zero is one that is given. */
        if (input % JN_ORDER && value != 0.0) s->rated[input / JN_ORDER] = true;
        s->u[input] = value;
        if (input % JN_ORDER == 0) s->set_at[input / JN_ORDER] = s->t;
    } else if (within(vr, VR_P, VR_G)) s->p[vr - VR_P] = value, s->p_changed = true;
    else if (within(vr, VR_G, VR_Y)) s->g[vr - VR_G] = value;
    else if (vr == VR_TOLERANCE && value > 0.0) s->tolerance = value;
    else return failed(c, "not a real variable that can be set");
    s->known = 0;
    return true;
}

bool jn_get_boolean(JnInstance *c, unsigned vr, bool *value) {
    if (vr == VR_AT_REST) *value = c->s.at_rest;
    else if (within(vr, VR_M, VR_AT_REST)) *value = c->s.m[vr - VR_M] > 0.0;
    else return failed(c, "no such Boolean variable");
    return true;
}

bool jn_set_boolean(JnInstance *c, unsigned vr, bool value) {
    if (vr != VR_AT_REST) return failed(c, "not a Boolean variable that can be set");
    c->s.at_rest = value;
    return true;
}

bool jn_set_input_rate(JnInstance *c, unsigned vr, int order, double value) {
    int input = (int)vr - VR_U, place = input < 0 ? 0 : input % JN_ORDER + order; /* a track's rates stand behind it */
    if (input < 0 || input >= JN_NU || order < 1) return failed(c, "no such derivative of an input");
    return place >= JN_ORDER || jn_set(c, vr + (unsigned)order, value);
}

bool jn_set_time(JnInstance *c, double t) {
    if (!isfinite(t)) return failed(c, "the time is no finite number");
    if (t != c->s.t) c->s.known = 0;
    c->s.t = c->s.t_input = t;
    return true;
}

/* Change of states (some are outputs), rates, outputs and indicators by value reference; false: vr is none of them. */
static bool known(JnInstance *c, unsigned vr, double *x, double *dx, double *y, double *z, double **place) {
    if (within(vr, VR_X, VR_DX)) *place = x + (vr - VR_X);
    else if (within(vr, VR_DX, VR_U)) *place = dx + (vr - VR_DX);
    else if (within(vr, VR_Y, VR_Z)) *place = y + (vr - VR_Y);
    else if (within(vr, VR_Z, VR_TOLERANCE)) *place = z + (vr - VR_Z);
    else return failed(c, "derivatives are those of states, rates, outputs and event indicators");
    return true;
}

static bool seeded(JnInstance *c, unsigned vr, double *sx, double *su, double *sp, double **place) {
    if (within(vr, VR_X, VR_DX)) *place = sx + (vr - VR_X);
    else if (within(vr, VR_U, VR_P)) *place = su + (vr - VR_U);
    else if (within(vr, VR_P, VR_G)) *place = sp + (vr - VR_P);
    else return failed(c, "derivatives are by states, inputs and parameters of the rig");
    return true;
}

bool jn_directional(JnInstance *c, const unsigned *of, size_t n_of, const unsigned *by, size_t n_by, const double *seed,
                    double *sensitivity) {
    JnState *s = &c->s;
    double sx[JN_NX] = {0}, su[JN_ROOM(JN_NU)] = {0}, sp[JN_ROOM(JN_NP)] = {0}, u[JN_ROOM(JN_NU)], *place;
    double dx[JN_NX], y[JN_ROOM(JN_NY)], z[JN_ROOM(JN_NM)], on[JN_NX];
    for (size_t i = 0; i < n_by; i++) {
        if (!seeded(c, by[i], sx, su, sp, &place)) return false;
        *place = seed[i];
    }
    parameters(s);
    jn_slopes(s->x, inputs(c, s->t, u), s->e, s->m, sx, su, sp, dx, y, z, on);
#if JN_PROJECTS
    if (!c->cosim)
        for (int i = 0; i < JN_NX; i++) dx[i] += (on[i] - sx[i]) / PULL;
#endif
    for (size_t i = 0; i < n_of; i++) {
        if (!known(c, of[i], sx, dx, y, z, &place)) return false;
        sensitivity[i] = *place;
    }
    return true;
}

bool jn_adjoint_of(JnInstance *c, const unsigned *of, size_t n_of, const unsigned *by, size_t n_by, const double *seed,
                   double *sensitivity) {
#if JN_ADJOINT
    JnState *s = &c->s;
    double dx[JN_NX] = {0}, y[JN_ROOM(JN_NY)] = {0}, z[JN_ROOM(JN_NM)] = {0}, on[JN_NX] = {0}, u[JN_ROOM(JN_NU)];
    double sx[JN_NX], su[JN_ROOM(JN_NU)], sp[JN_ROOM(JN_NP)], x[JN_NX] = {0}, *place;
    for (size_t i = 0; i < n_of; i++) {
        if (!known(c, of[i], x, dx, y, z, &place)) return false;
        *place = seed[i];
    }
    if (JN_PROJECTS && !c->cosim)
        for (int i = 0; i < JN_NX; i++) on[i] = dx[i] / PULL;
    parameters(s);
    jn_adjoint(s->x, inputs(c, s->t, u), s->e, s->m, dx, y, z, on, sx, su, sp);
    if (JN_PROJECTS && !c->cosim)
        for (int i = 0; i < JN_NX; i++) sx[i] -= dx[i] / PULL;
    for (int i = 0; i < JN_NX; i++) sx[i] += x[i];
    for (size_t i = 0; i < n_by; i++) {
        if (!seeded(c, by[i], sx, su, sp, &place)) return false;
        sensitivity[i] = *place;
    }
    return true;
#else
    (void)of, (void)n_of, (void)by, (void)n_by, (void)seed, (void)sensitivity;
    return failed(c, "the FMU was written without adjoint derivatives");
#endif
}

/* ---- events ------------------------------------------------------------------------------------------------- */

/* Whether any switch is on the other side of its mode by more than a share of its band. */
static bool beyond(const JnState *s, const double *z, double share) {
    for (int i = 0; i < JN_NM; i++)
        if (s->m[i] > 0.0 ? z[i] < -share * jn_band[i] : z[i] > share * jn_band[i]) return true;
    return false;
}

static bool update_modes(JnInstance *c) {
    JnState *s = &c->s;
    bool any = false;
    parameters(s);
    for (int round = 0; round < 20; round++) { /* a mode may move the switch of another */
        double u[JN_ROOM(JN_NU)], z[JN_ROOM(JN_NM)];
        jn_switch(s->x, inputs(c, s->t, u), s->e, s->m, z);
        if (!beyond(s, z, 0.5)) break;
        for (int i = 0; i < JN_NM; i++)
            if (s->m[i] > 0.0 ? z[i] < -0.5 * jn_band[i] : z[i] > 0.5 * jn_band[i]) s->m[i] = z[i] > 0.0;
        any = true;
    }
    s->known = 0;
    return any;
}

double jn_next_instant(const JnInstance *c) {
    return JN_COMMANDS ? c->s.t_start + JN_PERIOD * (double)c->s.instants : INFINITY;
}

/* The controller sees the outputs and sets its commands, which hold until its next instant. */
static bool control(JnInstance *c) {
#if JN_COMMANDS
    JnState *s = &c->s;
    double u[JN_ROOM(JN_NU)], y[JN_ROOM(JN_NY)], seen[JN_MEASURED + 1], out[JN_COMMANDS + JN_MEMORY];
    parameters(s);
    jn_output(s->x, inputs(c, s->t, u), s->e, s->m, y);
    for (int i = 0; i < JN_MEASURED; i++) seen[i] = y[jn_measured[i]] - s->rest[i];
    seen[JN_MEASURED] = s->t - s->t_start;
    jn_law(s->memory, seen, s->g, out);
    if (!finite_all(out, JN_COMMANDS)) return failed(c, "the controller's command is no finite number");
    for (int i = 0; i < JN_COMMANDS; i++) s->u[jn_command[i] * JN_ORDER] = out[i];
    memcpy(s->memory, out + JN_COMMANDS, JN_MEMORY * sizeof(double));
    s->instants++;
    s->known = 0;
#else
    (void)c;
#endif
    return true;
}

static double rounding(double t) { return 1e-12 * larger(1.0, fabs(t)); }

bool jn_event(JnInstance *c) {
    JnState *s = &c->s;
    while (jn_next_instant(c) <= s->t + rounding(s->t))
        if (!control(c)) return false;
    for (int i = 0; i < JN_NT; i++) { /* inputs may have jumped: that is no rate */
        s->before[i] = s->u[i * JN_ORDER];
        s->before_at[i] = s->set_at[i] = s->t;
    }
    s->t_before = s->t;
    update_modes(c);
    return true;
}

void jn_accept(JnInstance *c) {
    JnState *s = &c->s;
    if (s->t <= s->t_before) return;
    for (int i = 0; i < JN_NT; i++) {
        double apart = s->set_at[i] - s->before_at[i];
        s->slope[i] = apart > 0.0 ? (s->u[i * JN_ORDER] - s->before[i]) / apart : 0.0; /* not set any more: it rests */
        s->before[i] = s->u[i * JN_ORDER];
        s->before_at[i] = s->set_at[i];
    }
    s->t_before = s->t;
    s->known = 0;
}

/* ---- static equilibrium ------------------------------------------------------------------------------------- */

#define ROWS (JN_NV + JN_NI + JN_NC)
#define COLUMNS (JN_NV + JN_NI)

/* Least squares by Householder reflections of scaled columns; directions that nothing decides stay where they are. */
static void least_squares(double a[ROWS][COLUMNS], double *b, double *d) {
    double scale[COLUMNS], diagonal[COLUMNS];
    for (int j = 0; j < COLUMNS; j++) {
        scale[j] = 0.0;
        for (int i = 0; i < ROWS; i++) scale[j] = fmax(scale[j], fabs(a[i][j]));
        if (scale[j] == 0.0) scale[j] = 1.0;
        for (int i = 0; i < ROWS; i++) a[i][j] /= scale[j];
    }
    for (int k = 0; k < COLUMNS; k++) {
        double norm = 0.0, weight;
        for (int i = k; i < ROWS; i++) norm += a[i][k] * a[i][k];
        norm = a[k][k] > 0.0 ? -sqrt(norm) : sqrt(norm);
        diagonal[k] = fabs(norm) < 1e-12 ? 0.0 : norm;
        if (diagonal[k] == 0.0) continue;
        a[k][k] -= norm;
        weight = -norm * a[k][k];
        for (int j = k + 1; j <= COLUMNS; j++) {
            double dot = 0.0;
            for (int i = k; i < ROWS; i++) dot += a[i][k] * (j < COLUMNS ? a[i][j] : b[i]);
            for (int i = k; i < ROWS; i++) {
                if (j < COLUMNS) a[i][j] -= dot / weight * a[i][k];
                else b[i] -= dot / weight * a[i][k];
            }
        }
    }
    for (int k = COLUMNS - 1; k >= 0; k--) {
        double sum = b[k];
        for (int j = k + 1; j < COLUMNS; j++) sum -= a[k][j] * d[j] * scale[j];
        d[k] = diagonal[k] == 0.0 ? 0.0 : sum / diagonal[k] / scale[k];
    }
}

/* Leave out of the accelerations (rows of a and b) what crosses the loops: it follows from what runs along them, but
   for products of two small numbers, and those, with light parts, would outweigh the balance. Twice, for rounding. */
static void along_loops(double a[ROWS][COLUMNS], double *b) {
    double across[JN_ROOM(JN_NC)][JN_ROOM(JN_NV)];
    for (int i = 0; i < JN_NC; i++) {
        double *row = across[i], *given = a[JN_NV + JN_NI + i], size = 0.0, left = 0.0;
        memcpy(row, given, JN_NV * sizeof(double));
        for (int k = 0; k < JN_NV; k++) size += row[k] * row[k];
        for (int h = 0; h < 2 * i; h++) {
            double dot = 0.0, *known = across[h % i];
            for (int k = 0; k < JN_NV; k++) dot += known[k] * row[k];
            for (int k = 0; k < JN_NV; k++) row[k] -= dot * known[k];
        }
        for (int k = 0; k < JN_NV; k++) left += row[k] * row[k];
        for (int k = 0; k < JN_NV; k++) row[k] = left > 1e-18 * size ? row[k] / sqrt(left) : 0.0;
        for (int j = 0; j <= COLUMNS; j++) {
            double dot = 0.0;
            for (int k = 0; k < JN_NV; k++) dot += row[k] * (j < COLUMNS ? a[k][j] : b[k]);
            for (int k = 0; k < JN_NV; k++) {
                if (j < COLUMNS) a[k][j] -= dot * row[k];
                else b[k] -= dot * row[k];
            }
        }
    }
}

/* Inputs whose rates vanish: equilibrium is that of their values. */
static const double *still(const JnState *s, double *u) {
    for (int i = 0; i < JN_NU; i++) u[i] = i % JN_ORDER ? 0.0 : s->u[i];
    return u;
}

/* Rates of the coordinates for some speeds: they are linear in the speeds. */
static void moved_by(JnInstance *c, const double *u, const double *speeds, double *dq) {
    double x[JN_NX], dx[JN_NX];
    memcpy(x, c->s.x, sizeof x);
    memcpy(x + JN_NQ, speeds, JN_NV * sizeof(double));
    jn_rate(x, u, c->s.e, c->s.m, dx);
    memcpy(dq, dx, JN_NQ * sizeof(double));
}

/* One step of a semi-smooth Newton to where accelerations and open loops vanish; gives its size. */
static double towards_rest(JnInstance *c) {
    JnState *s = &c->s;
    static const double none_u[JN_ROOM(JN_NU)], none_p[JN_ROOM(JN_NP)];
    double a[ROWS][COLUMNS] = {{0}}, b[ROWS], d[COLUMNS], u[JN_ROOM(JN_NU)], dx[JN_NX], dq[JN_ROOM(JN_NQ)];
    double y[JN_ROOM(JN_NY)], z[JN_ROOM(JN_NM)], on[JN_NX], open[JN_ROOM(JN_NC)], opening[JN_ROOM(JN_NC)], largest = 0.0;
    jn_rate(s->x, still(s, u), s->e, s->m, dx);
    jn_loops(s->x, u, s->e, s->m, open, opening);
    for (int i = 0; i < JN_NV + JN_NI; i++) b[i] = -dx[JN_NQ + i];
    for (int i = 0; i < JN_NC; i++) b[JN_NV + JN_NI + i] = -open[i];
    for (int j = 0; j < COLUMNS; j++) { /* along one speed, or a change of one internal state */
        double seed[JN_NX] = {0}, speeds[JN_ROOM(JN_NV)] = {0};
        if (j < JN_NV) {
            double x[JN_NX];
            speeds[j] = 1.0;
            moved_by(c, u, speeds, seed);
            memcpy(x, s->x, sizeof x);
            x[JN_NQ + j] = 1.0;
            jn_loops(x, u, s->e, s->m, open, opening);
            for (int i = 0; i < JN_NC; i++) a[JN_NV + JN_NI + i][j] = opening[i];
        } else seed[JN_NQ + j] = 1.0;
        jn_slopes(s->x, u, s->e, s->m, seed, none_u, none_p, dx, y, z, on);
        for (int i = 0; i < JN_NV + JN_NI; i++) a[i][j] = dx[JN_NQ + i];
    }
    along_loops(a, b);
    least_squares(a, b, d);
    for (int j = 0; j < JN_NV; j++) largest = fmax(largest, fabs(d[j]));
    if (JN_PROJECTS && largest > STRIDE)
        for (int j = 0; j < JN_NV; j++) d[j] *= STRIDE / largest;
    moved_by(c, u, d, dq);
    for (int i = 0; i < JN_NQ; i++) s->x[i] += dq[i];
    for (int i = 0; i < JN_NI; i++) s->x[JN_NQ + JN_NV + i] += d[JN_NV + i];
    for (int k = 0; k < 3; k++) onto_loops(c, u);
    memset(s->x + JN_NQ, 0, JN_NV * sizeof(double));
    s->known = 0;
    return largest;
}

bool jn_initialise(JnInstance *c) {
    JnState *s = &c->s;
    jn_start_at(c, s->t);
    parameters(s);
    if (s->at_rest) {
        double size = 1.0, u[JN_ROOM(JN_NU)], dx[JN_NX], left = 0.0;
        memset(s->x + JN_NQ, 0, JN_NV * sizeof(double));
        for (int round = 0; round < 60 && isfinite(size); round++) {
            size = towards_rest(c);
            if (!update_modes(c) && size < SETTLED) break;
        }
        jn_rate(s->x, still(s, u), s->e, s->m, dx);
        for (int i = 0; i < JN_NV; i++) left = fmax(left, fabs(dx[JN_NQ + i]));
        if (!(size < 1e4 * SETTLED) || !(left < UNBALANCED)) return failed(c, "no static equilibrium with these parameters and inputs");
    }
    update_modes(c);
#if JN_COMMANDS
    if (s->at_rest) {
        double u[JN_ROOM(JN_NU)], y[JN_ROOM(JN_NY)];
        jn_output(s->x, still(s, u), s->e, s->m, y);
        for (int i = 0; i < JN_MEASURED; i++) s->rest[i] = y[jn_measured[i]];
    }
#endif
    for (int i = 0; i < JN_NT; i++) {
        s->before[i] = s->u[i * JN_ORDER];
        s->before_at[i] = s->set_at[i] = s->t;
        s->slope[i] = s->bend[i] = s->bend_before[i] = 0.0;
        s->rate_before[i] = s->u[i * JN_ORDER + 1];
    }
    return s->ready = jn_evaluate(c, RATES);
}

/* ---- co-simulation: Dormand and Prince's pair of orders 5 and 4, with steps that land on events ---------------- */

#define K(j) k[j][i]
#define STAGE(to, node, sum)                                                                                           \
    for (int i = 0; i < JN_NX; i++) end[i] = s->x[i] + h * (sum);                                                      \
    rate_at(c, s->t + (node) * h, end, k[to])

/* One step of length h from (t, x), whose slope is k[0]; gives the error relative to the tolerance. */
static double attempt(JnInstance *c, double h, double k[7][JN_NX], double *end) {
    JnState *s = &c->s;
    double worst = 0.0;
    STAGE(1, 1.0 / 5, 1.0 / 5 * K(0));
    STAGE(2, 3.0 / 10, 3.0 / 40 * K(0) + 9.0 / 40 * K(1));
    STAGE(3, 4.0 / 5, 44.0 / 45 * K(0) - 56.0 / 15 * K(1) + 32.0 / 9 * K(2));
    STAGE(4, 8.0 / 9, 19372.0 / 6561 * K(0) - 25360.0 / 2187 * K(1) + 64448.0 / 6561 * K(2) - 212.0 / 729 * K(3));
    STAGE(5, 1.0, 9017.0 / 3168 * K(0) - 355.0 / 33 * K(1) + 46732.0 / 5247 * K(2) + 49.0 / 176 * K(3) -
                      5103.0 / 18656 * K(4));
    STAGE(6, 1.0, 35.0 / 384 * K(0) + 500.0 / 1113 * K(2) + 125.0 / 192 * K(3) - 2187.0 / 6784 * K(4) +
                      11.0 / 84 * K(5));
    for (int i = 0; i < JN_NX; i++) {
        double size = larger(larger(fabs(s->x[i]), fabs(end[i])), jn_scale[i]);
        double error = 71.0 / 57600 * K(0) - 71.0 / 16695 * K(2) + 71.0 / 1920 * K(3) - 17253.0 / 339200 * K(4) +
                       22.0 / 525 * K(5) - 1.0 / 40 * K(6);
        worst = larger(worst, fabs(h * error) / (s->tolerance * size));
        if (!isfinite(end[i])) return INFINITY;
    }
    return worst;
}

/* Whether a switch has left the side of its mode at a share of the step (on the cubic through its ends). */
static bool crossed(JnInstance *c, double h, double share, double k[7][JN_NX], const double *end) {
    JnState *s = &c->s;
    double x[JN_NX], u[JN_ROOM(JN_NU)], z[JN_ROOM(JN_NM)], f = share, g = 1 - f;
    double bend = f * g * (1 - 2 * f), begin = h * f * g * g, last = h * f * f * g;
    if (share == 1.0) memcpy(x, end, sizeof x);
    else for (int i = 0; i < JN_NX; i++)
        x[i] = g * s->x[i] + f * end[i] - bend * (end[i] - s->x[i]) + begin * k[0][i] - last * k[6][i];
    jn_switch(x, inputs(c, s->t + share * h, u), s->e, s->m, z);
    return beyond(s, z, 1.0);
}

/* Share of the step at which a switch is first seen beyond its band; 0: at none of the places looked at. */
static double first_crossing(JnInstance *c, double h, double k[7][JN_NX], const double *end, double smallest) {
    double low = 0.0, high = 0.0;
    if (!JN_NM) return 0.0;
    for (int part = 1; part <= 4 && high == 0.0; part++) { /* also a contact that begins and ends within the step */
        if (crossed(c, h, 0.25 * part, k, end)) high = 0.25 * part;
        else low = 0.25 * part;
    }
    while (high > 0.0 && (high - low) * h > smallest) {
        double middle = 0.5 * (low + high);
        if (crossed(c, h, middle, k, end)) high = middle;
        else low = middle;
    }
    return high;
}

/* How the tracks go on until the next communication point: with the rate that is given, or that of the last two values,
 * and bent as they were bent before. At a corner of the road the last two bends differ, and the lesser of them holds. */
static void bent(JnState *s) {
    double h = s->t - s->t_before;
    for (int i = 0; i < JN_NT && h > 0.0; i++) {
        double *u = s->u + i * JN_ORDER, rate = s->rated[i] ? u[1] : (u[0] - s->before[i]) / h;
        double now = (rate - s->rate_before[i]) / h, last = s->bend_before[i];
        s->bend[i] = now * last <= 0.0 ? 0.0 : fabs(now) < fabs(last) ? now : last;
        s->slope[i] = rate + (s->rated[i] ? 0.0 : 0.5 * h * s->bend[i]); /* a difference is the rate half a step ago */
        s->rate_before[i] = rate, s->bend_before[i] = now, s->before[i] = u[0];
    }
    s->t_before = s->t_input = s->t;
}

static double nearly(double t) { return 1e-9 * larger(1.0, fabs(t)); }

bool jn_may_step(JnInstance *c, double t, double h) { /* written so that what is no number is refused */
    if (!c->s.ready) return failed(c, "a step before the initialisation, or after the end");
    if (!(fabs(t - c->s.t) <= nearly(t))) return failed(c, "the step does not begin where the last ended");
    if (!(h >= 0.0) || !isfinite(t + h)) return failed(c, "the length of a step is negative, or no finite number");
    if (t + h > c->stop + nearly(c->stop)) return failed(c, "the step goes beyond the stop time");
    return true;
}

bool jn_advance(JnInstance *c, double t_end) {
    JnState *s = &c->s;
    double k[7][JN_NX], end[JN_NX], u[JN_ROOM(JN_NU)], h = s->step > 0.0 ? s->step : 1e-3, smallest = rounding(t_end);
    bent(s);
    parameters(s);
    update_modes(c); /* inputs or parameters may have jumped */
    rate_at(c, s->t, s->x, k[0]);
    for (int64_t budget = 1000000; t_end - s->t > smallest; budget--) {
        double next = lesser(t_end, jn_next_instant(c)), error, share, trial;
        bool lands;
        if (budget == 0) return failed(c, "a million steps did not reach the communication point");
        if (next <= s->t + smallest) {
            if (!control(c)) return false;
            rate_at(c, s->t, s->x, k[0]);
            continue;
        }
        lands = s->t + 1.0001 * h >= next;
        trial = lands ? next - s->t : h;
        error = attempt(c, trial, k, end);
        if (error > 1.0) {
            h = trial * larger(0.2, 0.9 * pow(error, -0.2));
            s->rejected++;
            if (h < smallest) return failed(c, "the step became too small: unstable, or loops that cannot be closed");
            continue;
        }
        share = first_crossing(c, trial, k, end, smallest);
        if (share > 0.0) {
            trial *= share;
            attempt(c, trial, k, end);
        } else if (!lands || trial >= h) h = trial * (error < 1.8e-4 ? 5.0 : 0.9 * pow(error, -0.2));
        s->t = lands && !(share > 0.0) ? next : s->t + trial;
        memcpy(s->x, end, sizeof s->x);
        onto_loops(c, inputs(c, s->t, u));
        s->steps++;
        if (share > 0.0) s->events++, update_modes(c);
        if (share > 0.0 || JN_PROJECTS) rate_at(c, s->t, s->x, k[0]);
        else memcpy(k[0], k[6], sizeof k[0]);
    }
    s->t = t_end;
    s->step = h;
    s->known = 0;
    return finite_all(s->x, JN_NX) || failed(c, "the states are no finite numbers");
}
