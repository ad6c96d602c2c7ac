/* What `bench speed` measures, as the families' tables have it: frames, figures of them, and growths. */
#ifndef TS_STUDY_SPEED_H
#define TS_STUDY_SPEED_H
#include "study/asked/job.h"
#include "study/expression.h"
#include "study/figure.h"

enum { TS_SPEED_METHODS = 4 };

/* One frame by some methods. */
typedef struct {
	const char *name; /* as in --scene */
	const char *spec; /* of its scene; of a model the file in the folder TS_SCENES, which may be missing */
	bool model;
	const char *effect;                        /* of the methods */
	const char *methods[TS_SPEED_METHODS + 1]; /* names, ended by NULL */
	const char *set;                           /* parameters, unless they were typed */
	bool rays, points; /* also Embree's rays for its off-screen views; also as many bare points as the first method's,
	                     * of which only cubes are made */
} ts_speed_scene;

typedef struct ts_speed_set ts_speed_set;

/* A figure of a frame that no method alone has: its value in a run; *quiet becomes false where what it is made of was
 * not. */
typedef struct {
	const char *name, *doc, *unit;
	double (*value)(const ts_speed_set *set, u32 run, bool *quiet);
} ts_speed_own;
/* All of these, ended by one without a name. */
extern const ts_speed_own ts_speed_owns[];

/* What a name of an expression is: `S.rays`, `S.epr.ms.splat`. */
typedef struct {
	u32 scene;               /* its number; TS_NONE: of none, "threads" */
	const ts_speed_own *own; /* NULL: `figure`, whose variant is the number of a method of the scene */
	ts_figure figure;
} ts_speed_name;

typedef enum { TS_SPEED_SHOWN, TS_SPEED_LEAST, TS_SPEED_MOST } ts_speed_bound;

/* A figure, and the wanted bound; shown: none. */
typedef struct {
	const char *text, *unit;
	int decimals;
	const ts_term *terms; /* of its expression, over names */
	u32 n_terms;
	ts_speed_bound bound;
	double goal;
} ts_speed_figure;

/* A growth: times for several values of one parameter, and the exponents of power laws between them. */
typedef struct {
	ts_speed_scene of;  /* to a spec that ends in '=' the value is appended */
	const char *param;  /* the parameter of the values; "size": pixels; "threads": threads; "-": none */
	const char *values; /* separated by commas */
	const char *stages; /* stages to time beside whole frames, separated by commas */
	const char *called; /* the printed name of these stages */
} ts_speed_growth;

/* What a text has. Each list is ended by a row without a name or text. */
typedef struct ts_speed_of {
	const ts_speed_scene *scenes;
	const ts_speed_figure *figures;
	const ts_speed_growth *growths;
	const ts_speed_name *names;
	u32 n_names;
} ts_speed_of;

/* Measures and prints the table "speed". `lists` is ended by NULL. */
ts_status ts_bench_speed(const ts_job *job, const ts_speed_of *const *lists);

#endif
