/* Two numbers side by side: what the corners of an axle do alike is computed once. Compilers that know vectors keep a
 * pair in one register, which is as wide on every 64-bit processor. */
#ifndef JN_PAIRS_H
#define JN_PAIRS_H
#if defined(_MSC_VER) && !defined(__clang__)
#define restrict __restrict /* behind all headers of the system, which use the word otherwise */
#endif
#if defined(__GNUC__) && !defined(__clang__)
#define JN_LONG __attribute__((optimize("O0"))) /* of a long function, which is called seldom: a second, not a minute */
#else
#define JN_LONG
#endif
#if defined(__GNUC__) && !defined(JN_NO_VECTORS)
typedef double pair __attribute__((vector_size(16)));
#define both(a, b) ((pair){a, b})
#define at(v, lane) ((v)[lane])
#define plus(v, w) ((v) + (w))
#define minus(v, w) ((v) - (w))
#define times(v, w) ((v) * (w))
#define over(v, w) ((v) / (w))
#define negative(v) (-(v))
#else
typedef struct { double lane[2]; } pair;
static pair both(double a, double b) { pair v = {{a, b}}; return v; }
#define at(v, i) ((v).lane[i])
static pair plus(pair v, pair w) { return both(at(v, 0) + at(w, 0), at(v, 1) + at(w, 1)); }
static pair minus(pair v, pair w) { return both(at(v, 0) - at(w, 0), at(v, 1) - at(w, 1)); }
static pair times(pair v, pair w) { return both(at(v, 0) * at(w, 0), at(v, 1) * at(w, 1)); }
static pair over(pair v, pair w) { return both(at(v, 0) / at(w, 0), at(v, 1) / at(w, 1)); }
static pair negative(pair v) { return both(-at(v, 0), -at(v, 1)); }
#endif
#endif
