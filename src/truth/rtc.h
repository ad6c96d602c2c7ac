/* Embree, version 3 or 4, opened with the first tree, so that a process without truths does not load its 40 MB. */
#ifndef TS_TRUTH_RTC_H
#define TS_TRUTH_RTC_H
#include <touchstone/status.h>
#include "kernels/base/num.h"
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
	CALL(NewGeometry) CALL(ReleaseGeometry) CALL(CommitGeometry) CALL(AttachGeometry) CALL(AttachGeometryByID) \
	CALL(SetSharedGeometryBuffer) CALL(SetNewGeometryBuffer) CALL(SetGeometryUserData) \
	CALL(SetGeometryUserPrimitiveCount) CALL(SetGeometryBoundsFunction) CALL(SetGeometryIntersectFunction) \
	CALL(SetGeometryIntersectFilterFunction) CALL(Intersect1) CALL(Intersect16)
/* clang-format on */
#define TS_RTC_CALL(name) __typeof__(&rtc##name) name;
typedef struct {
	TS_RTC_CALLS(TS_RTC_CALL)
} ts_rtc_calls;
#undef TS_RTC_CALL

/* Valid once ts_rtc_open, from any thread, has found Embree. */
extern ts_rtc_calls ts_rtc;
ts_status ts_rtc_open(void);

#endif
