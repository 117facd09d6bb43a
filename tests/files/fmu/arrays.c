/* A component FMU for tests, FMI 2.0 or 3.0 by -DVERSION, of inputs and outputs of several types and of arrays:
   y = K u + 10 on i + 0.5 f, n = 2 y as whole numbers, hot = y > 0, held in slots. In FMI 3.0 they are the arrays
   1 u[3], 2 K[2,3], 3 f[2] (Float32), 4 i[2] (Int16), 5 on[2] (Boolean), 6 y[2], 7 n[2] (Int32), 8 hot[2] (Boolean),
   and 9 is the size 3 of u; in FMI 2.0 element i of array r is the variable 16 r + i, and f is a Real. */
#include <math.h>
#include <stdlib.h>
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

typedef struct { double x[9][16]; } It;
static const size_t sizes[9] = {0, 3, 6, 2, 2, 2, 2, 2, 2};

static S step(It *it) {
    for (int k = 0; k < 2; k++) {
        double y = 10.0 * it->x[5][k] * it->x[4][k] + 0.5 * it->x[3][k];
        for (int j = 0; j < 3; j++) y += it->x[2][3 * k + j] * it->x[1][j];
        it->x[6][k] = y, it->x[7][k] = floor(2.0 * y + 0.5), it->x[8][k] = y > 0.0;
    }
    return GOOD;
}
#if VERSION == 2
#define CALLS(name, T) \
    S fmi2Get##name(C c, const R r[], size_t n, T v[]) { for (size_t i = 0; i < n; i++) v[i] = (T)((It *)c)->x[r[i] / 16][r[i] % 16]; return GOOD; } \
    S fmi2Set##name(C c, const R r[], size_t n, const T v[]) { for (size_t i = 0; i < n; i++) ((It *)c)->x[r[i] / 16][r[i] % 16] = v[i]; return GOOD; }
CALLS(Real, double)
CALLS(Integer, int)
CALLS(Boolean, fmi2Boolean)
C fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                  const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean logging) { return calloc(1, sizeof(It)); }
S fmi2SetupExperiment(C c, fmi2Boolean g, double t, double s, fmi2Boolean e, double p) { return GOOD; }
S fmi2EnterInitializationMode(C c) { return GOOD; }
S fmi2DoStep(C c, double t, double h, fmi2Boolean n) { return step(c); }
#else
/* An array is given whole, or refused. */
#define CALLS(name, T) \
    S fmi3Get##name(C c, const R r[], size_t n, T v[], size_t m) { size_t k = 0; for (size_t i = 0; i < n; i++) for (size_t j = 0; j < sizes[r[i]]; j++, k++) { if (k >= m) return BAD; v[k] = (T)((It *)c)->x[r[i]][j]; } return k == m ? GOOD : BAD; } \
    S fmi3Set##name(C c, const R r[], size_t n, const T v[], size_t m) { size_t k = 0; for (size_t i = 0; i < n; i++) for (size_t j = 0; j < sizes[r[i]]; j++, k++) { if (k >= m) return BAD; ((It *)c)->x[r[i]][j] = v[k]; } return k == m ? GOOD : BAD; }
CALLS(Float64, double)
CALLS(Float32, float)
CALLS(Int16, fmi3Int16)
CALLS(Int32, fmi3Int32)
CALLS(Boolean, fmi3Boolean)
C fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible, fmi3Boolean logging,
                              fmi3Boolean events, fmi3Boolean early, const R r[], size_t n, void *environment,
                              fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) { return calloc(1, sizeof(It)); }
S fmi3EnterInitializationMode(C c, fmi3Boolean g, double t, double s, fmi3Boolean e, double p) { return GOOD; }
S fmi3DoStep(C c, double t, double h, fmi3Boolean n, fmi3Boolean *a, fmi3Boolean *b, fmi3Boolean *d, double *last) {
    *a = *b = *d = 0, *last = t + h;
    return step(c);
}
#endif
S F(ExitInitializationMode)(C c) { return GOOD; }
S F(Terminate)(C c) { return GOOD; }
void F(FreeInstance)(C c) { free(c); }
