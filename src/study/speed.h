/* What `bench speed` measures: scenes, figures and growths that families hand in. Scenes are named; figures of a scene
 * or method of another family are left out where that family is missing. */
#ifndef TS_STUDY_SPEED_H
#define TS_STUDY_SPEED_H
#include "kernels/base/compat.h"

/* One frame by some methods. */
typedef struct {
	const char *name;    /* as in --scene */
	const char *spec;    /* a built-in scene; "" for the file `model` of the folder TS_SCENES, which may be missing */
	const char *model;   /* NULL: a built-in scene */
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
	TS_SPEED_CORES,   /* TS_SPEED_TIME times the threads */
	TS_SPEED_COUNT,   /* the counter `what` */
	TS_SPEED_PIXELS,  /* of the image */
	TS_SPEED_TEXELS,  /* of the off-screen views */
	TS_SPEED_SURFELS, /* of the scene */
	TS_SPEED_RAYS,    /* seconds of Embree for the off-screen views */
	TS_SPEED_CASTING, /* seconds of truths' rays for the off-screen views of the scene's first method */
	TS_SPEED_POINTS,  /* seconds of bare points */
	TS_SPEED_MINIMA,  /* seconds of all threads for as many scattered minima as the counter `what`, faces as they are */
} ts_speed_kind;

typedef struct {
	ts_speed_kind kind;
	const char *scene, *method;
	const char *what;
	const char *per; /* a counter by which the term is divided; NULL: none */
} ts_speed_term;

typedef enum { TS_SPEED_SHOWN, TS_SPEED_LEAST, TS_SPEED_MOST } ts_speed_bound;

/* A figure: scale * above / below. */
typedef struct {
	const char *text, *unit;
	double scale;
	int decimals;
	ts_speed_term above, below;
	ts_speed_bound bound; /* the wanted bound; shown: none */
	double goal;
} ts_speed_figure;

/* A growth: times for several values of one parameter, and the exponents of power laws between them. */
typedef struct {
	const char *name;   /* as in --scene */
	const char *spec;   /* of its scene; to one that ends in '=' the value is appended */
	const char *param;  /* the parameter of the values; "size": pixels; "threads": threads; "": none */
	const char *values; /* separated by commas */
	const char *effect, *methods, *set;
	const char *stages; /* stages to time beside whole frames, separated by commas */
	const char *called; /* the printed name of these stages */
} ts_speed_growth;

/* The rows of a family. Each list is ended by a row without a name or text; NULL: there is none. */
typedef struct {
	const ts_speed_scene *scenes;
	const ts_speed_figure *figures;
	const ts_speed_growth *growths;
} ts_speed_of;

/* Takes the rows of all families, ended by NULL. The rows must stay. */
void ts_speed_use(const ts_speed_of *const *lists);

#endif
