/* The records of records.def as structs. */
#ifndef TS_KERNELS_BASE_RECORDS_H
#define TS_KERNELS_BASE_RECORDS_H
#include "kernels/base/compat.h"

#ifndef TS_HAS_RECORDS /* <touchstone/records.h> has them, too */
#define TS_HAS_RECORDS
#define RECORD(name, doc) typedef struct {
#define FIELD(type, name, count, doc) TS_FIELD_##count(type, name)
#define RECORD_END(name, bytes) \
	} \
	name;
#define TS_FIELD_1(type, name) type name;
#define TS_FIELD_2(type, name) type name[2];
#define TS_FIELD_3(type, name) type name[3];
#define TS_FIELD_4(type, name) type name[4];
#define TS_FIELD_5(type, name) type name[5];
#define TS_FIELD_6(type, name) type name[6];
#define TS_FIELD_9(type, name) type name[9];
#include <touchstone/records.def>
#endif

#define RECORD_END(name, bytes) TS_ASSERT_SIZE(name, bytes);
#include <touchstone/records.def>

#endif
