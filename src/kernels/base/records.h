/* The records of records.def as structs. */
#ifndef TS_KERNELS_RECORDS_H
#define TS_KERNELS_RECORDS_H
#include "compat.h"

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
#include "../../../include/touchstone/records.def"

#define RECORD_END(name, bytes) TS_ASSERT_SIZE(name, bytes);
#include "../../../include/touchstone/records.def"

#endif
