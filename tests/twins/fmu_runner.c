/* A master that depends on nothing: the library of an FMI 3.0 FMU is loaded and stepped over a sine of 0.5 mm and 10 Hz.
 *
 *     runner LIBRARY TOKEN INPUT RATE OUTPUT COUNT STEP
 *
 * prints the output, a float64 by its value reference, at the end of each step. Compiles for Windows and elsewhere.
 */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#ifdef _WIN32
#include <windows.h>
static void *opened(const char *path) { return (void *)LoadLibraryA(path); }
static void *found(void *library, const char *name) { return (void *)GetProcAddress((HMODULE)library, name); }
#else
#include <dlfcn.h>
static void *opened(const char *path) { return dlopen(path, RTLD_NOW | RTLD_LOCAL); }
static void *found(void *library, const char *name) { return dlsym(library, name); }
#endif

typedef void *Make(const char *, const char *, const char *, bool, bool, bool, bool, const uint32_t *, size_t, void *,
                   void *, void *);
typedef int Enter(void *, bool, double, double, bool, double);
typedef int Plain(void *);
typedef int Set(void *, const uint32_t *, size_t, const double *, size_t);
typedef int Get(void *, const uint32_t *, size_t, double *, size_t);
typedef int Step(void *, double, double, bool, bool *, bool *, bool *, double *);

int main(int count, char **words) {
    if (count != 8) return 2;
    void *library = opened(words[1]);
    if (library == NULL) return 3;
    Make *make = (Make *)found(library, "fmi3InstantiateCoSimulation");
    Enter *enter = (Enter *)found(library, "fmi3EnterInitializationMode");
    Plain *leave = (Plain *)found(library, "fmi3ExitInitializationMode");
    Set *set = (Set *)found(library, "fmi3SetFloat64");
    Get *get = (Get *)found(library, "fmi3GetFloat64");
    Step *step = (Step *)found(library, "fmi3DoStep");
    if (!make || !enter || !leave || !set || !get || !step) return 4;
    void *c = make("runner", words[2], "", false, false, false, false, NULL, 0, NULL, NULL, NULL);
    if (c == NULL) return 5;
    const uint32_t in[2] = {(uint32_t)atol(words[3]), (uint32_t)atol(words[4])}, out = (uint32_t)atol(words[5]);
    const int steps = atoi(words[6]);
    const double h = atof(words[7]), w = 62.8;
    int worst = enter(c, false, 0.0, 0.0, false, 0.0) | leave(c);
    for (int i = 0; i < steps && worst <= 1; i++) {
        bool event, end, early;
        double reached, y, u[2] = {5e-4 * sin(w * h * i), 5e-4 * w * cos(w * h * i)};
        worst = set(c, in, 2, u, 2) | step(c, h * i, h, true, &event, &end, &early, &reached) | get(c, &out, 1, &y, 1);
        printf("%.17g\n", y);
    }
    return worst > 1 ? 6 : 0;
}
