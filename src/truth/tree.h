/* Embree, version 3 or 4, opened with the first tree, so that a process without truths does not load its 40 MB; and a
 * tree of it: a device and a scene, with their first error, which may come from several threads at once, and their
 * limit of memory. */
#ifndef TS_TRUTH_TREE_H
#define TS_TRUTH_TREE_H
#include <pthread.h>
#include <touchstone/status.h>
#include "kernels/base/num.h"
#include "methods/stages.h"

#if TS_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/* The functions of Embree that are called. */
/* clang-format off */
#define TS_RTC_CALLS(CALL) \
	CALL(NewDevice) CALL(ReleaseDevice) CALL(GetDeviceError) CALL(SetDeviceErrorFunction) \
	CALL(SetDeviceMemoryMonitorFunction) CALL(NewScene) CALL(ReleaseScene) CALL(SetSceneFlags) CALL(CommitScene) \
	CALL(SetSceneProgressMonitorFunction) CALL(NewGeometry) CALL(ReleaseGeometry) CALL(CommitGeometry) \
	CALL(AttachGeometry) CALL(AttachGeometryByID) CALL(SetSharedGeometryBuffer) CALL(SetNewGeometryBuffer) \
	CALL(SetGeometryUserData) CALL(SetGeometryUserPrimitiveCount) CALL(SetGeometryBoundsFunction) \
	CALL(SetGeometryIntersectFunction) CALL(SetGeometryIntersectFilterFunction) CALL(Intersect1) CALL(Intersect16)
/* clang-format on */
#define TS_RTC_CALL(name) __typeof__(&rtc##name) name;
typedef struct {
	TS_RTC_CALLS(TS_RTC_CALL)
} ts_rtc_calls;
#undef TS_RTC_CALL

/* Valid once ts_rtc_open, from any thread, has found Embree. */
extern ts_rtc_calls ts_rtc;
ts_status ts_rtc_open(void);

typedef struct {
	pthread_mutex_t lock;
	char text[160]; /* "" until there is one */
} ts_first_error;

/* Starts without an error. Released by ts_first_error_end. */
void ts_first_error_begin(ts_first_error *error);
void ts_first_error_end(ts_first_error *error);

/* Keeps the code and the text (may be NULL), cut to what fits, unless there is an error already. From any thread. */
void ts_first_error_keep(ts_first_error *error, int code, const char *text);

/* The error as one text, or NULL if there is none. It stays as it is until ts_first_error_end. From any thread. */
const char *ts_first_error_text(ts_first_error *error);

#if TS_EMBREE == 4
typedef struct RTCRayQueryContext ts_tree_context;
#else
typedef struct RTCIntersectContext ts_tree_context;
#endif

typedef struct {
	RTCDevice device;
	RTCScene scene;
	i64 bytes_left;       /* of the memory that Embree may still take, from any thread */
	ts_first_error error; /* Embree's threads report theirs at once */
} ts_tree;

/* Starts an empty tree; `tree` must stay where it is. Released by ts_tree_end, also on failure: Embree's own error. */
ts_status ts_tree_begin(ts_tree *tree, u32 threads);
void ts_tree_end(ts_tree *tree);
/* Builds the tree over the attached geometries. Fails if Embree fails, or if Embree's threads break the contract's
 * arithmetic. */
ts_status ts_tree_build(ts_tree *tree);
/* Fails if Embree has failed; `doing` is for the message. */
ts_status ts_tree_check(ts_tree *tree, const char *doing);
/* Fails with Embree's reason, if Embree gives one, where Embree made nothing; `doing` is for the message. */
ts_status ts_tree_fail(ts_tree *tree, const char *doing);
/* Finds the nearest hit, in *ray. Filters of geometries get the address of the context. From any thread. */
void ts_tree_cast(const ts_tree *tree, struct RTCRayHit *ray, ts_tree_context *context);
/* As ts_tree_cast, for those of 16 rays whose `valid` is -1. The filter (NULL: none) is called after the geometries'
 * own filters, with one triangle and some of the rays; where it accepts, the traversal continues up to the tfar that it
 * leaves. */
void ts_tree_cast_16(const ts_tree *tree, const int *valid, struct RTCRayHit16 *rays, ts_tree_context *context,
                     RTCFilterFunctionN filter);

#endif
