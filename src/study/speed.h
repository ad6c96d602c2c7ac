/* What `bench speed` measures: scenes, figures and growths that families hand in. Scenes are called by name; what a
 * family says of another's scene or method is left out where that is not there. */
#ifndef TS_STUDY_SPEED_H
#define TS_STUDY_SPEED_H
#include "../kernels/base/compat.h"

/* One frame by some methods. */
typedef struct {
	const char *name;    /* as in --scene */
	const char *spec;    /* a built-in scene, or the file `model` in the folder TS_SCENES, where that has it */
	const char *model;   /* NULL: it is built in */
	const char *effect;  /* of the methods */
	const char *methods; /* names, separated by commas */
	const char *set;     /* parameters, unless they were typed */
	bool rays, points;   /* also Embree's rays for its off-screen views; also as many bare points as the first method's,
	                      * of which only cubes are made */
} ts_speed_scene;

/* A term of a figure: seconds, a count, or a limit. */
typedef enum {
	TS_SPEED_ONE,
	TS_SPEED_TIME,    /* seconds of the stages `what`, separated by commas; "": of the frame */
	TS_SPEED_CORES,   /* the same, times the threads */
	TS_SPEED_COUNT,   /* the counter `what` */
	TS_SPEED_PIXELS,  /* of the image */
	TS_SPEED_TEXELS,  /* of the off-screen views */
	TS_SPEED_SURFELS, /* of the scene */
	TS_SPEED_RAYS,    /* seconds of Embree for the off-screen views */
	TS_SPEED_CASTING, /* seconds of truths' rays for the same, of the scene's first method */
	TS_SPEED_POINTS,  /* seconds of bare points */
	TS_SPEED_MINIMA,  /* seconds of all threads for as many scattered minima as the counter `what`, faces as they are */
} ts_speed_kind;

typedef struct {
	ts_speed_kind kind;
	const char *scene, *method;
	const char *what;
	const char *per; /* a counter that it is divided by; NULL: none */
} ts_speed_term;

typedef enum { TS_SPEED_SHOWN, TS_SPEED_LEAST, TS_SPEED_MOST } ts_speed_bound;

/* scale * above / below. */
typedef struct {
	const char *text, *unit;
	double scale;
	int decimals;
	ts_speed_term above, below;
	ts_speed_bound bound; /* what is wanted of it; shown: nothing */
	double goal;
} ts_speed_figure;

/* A time as one thing grows: exponents of power laws. */
typedef struct {
	const char *name;   /* as in --scene */
	const char *spec;   /* of its scene; one that ends in '=' goes on with the value */
	const char *param;  /* that the value is of; "" none; of pixels "size"; of threads "threads" */
	const char *values; /* separated by commas */
	const char *effect, *methods, *set;
	const char *stages; /* beside whole frames also these, separated by commas */
	const char *called; /* what they are */
} ts_speed_growth;

/* Each list ended by a row without a name or text; NULL: there is none. */
typedef struct {
	const ts_speed_scene *scenes;
	const ts_speed_figure *figures;
	const ts_speed_growth *growths;
} ts_speed_of;

/* Takes those of all families, ended by NULL. The rows must stay. */
void ts_speed_use(const ts_speed_of *const *lists);

#endif
