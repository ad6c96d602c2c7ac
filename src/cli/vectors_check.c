/* The verdict on a port's outputs: a table of the primitives, and of each wrong one the first wrong item. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "../study/table.h"
#include "vectors.h"

typedef struct {
	ts_vector_rows *rows;
	ts_report report;
	ts_table table;
	json_t *first_wrong;
	ts_file_text details; /* what stands below the table */
	u32 n_right, n_wrong;
} check;

static const ts_column columns[] = {
	{"primitive", "primitive", false}, {"items", "items", true},     {"wrong", "wrong", true},
	{"fault", "explained by", false},  {"explained", "items", true}, {NULL, NULL, false},
};

/* A line below the table. */
__attribute__((format(printf, 2, 3))) static void tell(check *c, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	vfprintf(c->details.out, format, arguments);
	va_end(arguments);
	fputc('\n', c->details.out);
}

/* Decimal, hexadecimal of floats, and bits. */
typedef struct {
	char decimal[40], hex[40], bits[24];
} value_text;

static value_text print_value(ts_vector_type type, const u32 *row)
{
	value_text r = {"", "", ""};
	u64 wide = (u64)row[ts_vector_type_words(type) - 1] << 32 | row[0];
	double x = (double)ts_u2f(row[0]);
	snprintf(r.bits, sizeof r.bits, "%08" PRIx32, row[0]);
	switch (type) {
	case TS_VECTOR_F32:
		snprintf(r.decimal, sizeof r.decimal, "%.9g", x);
		snprintf(r.hex, sizeof r.hex, "%a", x);
		break;
	case TS_VECTOR_I32: snprintf(r.decimal, sizeof r.decimal, "%" PRId32, (i32)row[0]); break;
	case TS_VECTOR_U32: snprintf(r.decimal, sizeof r.decimal, "%" PRIu32, row[0]); break;
	case TS_VECTOR_I64: snprintf(r.decimal, sizeof r.decimal, "%" PRId64, (i64)wide); break;
	case TS_VECTOR_U64: snprintf(r.decimal, sizeof r.decimal, "%" PRIu64, wide); break;
	}
	if (ts_vector_type_words(type) == 2) snprintf(r.bits, sizeof r.bits, "%016" PRIx64, wide);
	return r;
}

/* One line of text and an array of values, for the elements of an argument or of an output. */
static json_t *tell_values(check *c, const char *name, ts_vector_type type, u32 count, const u32 *row)
{
	char line[TS_VECTOR_WORDS * 64];
	size_t used = 0;
	json_t *list = json_array();
	for (u32 k = 0; k < count; k++) {
		value_text t = print_value(type, row + k * ts_vector_type_words(type));
		used += (size_t)snprintf(line + used, sizeof line - used, "%s%s%s%s (%s)", k == 0 ? "" : ", ", t.decimal,
		                         t.hex[0] != 0 ? " " : "", t.hex, t.bits);
		json_t *value = json_pack("{ss, ss}", "decimal", t.decimal, "bits", t.bits);
		if (t.hex[0] != 0) json_object_set_new(value, "hex", json_string(t.hex));
		json_array_append_new(list, value);
	}
	tell(c, "  %-10s %s", name, line);
	return list;
}

static bool is_nan(u32 u) { return (u & 0x7fffffffu) > 0x7f800000u; }

/* Steps between floats, differences of integers. */
static i64 distance(ts_vector_type type, const u32 *out, const u32 *found)
{
	switch (type) {
	case TS_VECTOR_F32: return ts_vector_ulps(out[0], found[0]);
	case TS_VECTOR_I32: return (i64)(i32)found[0] - (i32)out[0];
	case TS_VECTOR_U32: return (i64)found[0] - out[0];
	default: return (i64)(((u64)found[1] << 32 | found[0]) - ((u64)out[1] << 32 | out[0]));
	}
}

/* " in arrives", " in element 1 of l", " in element 2"; nothing where there is but one. */
static void name_spot(char *text, size_t bytes, const ts_vector_spot *spot)
{
	size_t used = 0;
	bool named = spot->column->name[0] != 0;
	text[0] = 0;
	if (spot->column->count > 1) used = (size_t)snprintf(text, bytes, " in element %" PRIu32, spot->element);
	if (named) snprintf(text + used, bytes - used, "%s%s", used > 0 ? " of " : " in ", spot->column->name);
}

/* How far the first wrong element is off. */
static json_t *tell_distance(check *c, const ts_vector *v, u32 element, const u32 *out, const u32 *found)
{
	char where[80];
	ts_vector_spot spot = ts_vector_out_spot(v, element);
	u32 at = spot.word;
	bool is_float = spot.column->type == TS_VECTOR_F32;
	name_spot(where, sizeof where, &spot);
	if (is_float && is_nan(found[at])) {
		tell(c, "  %-10s not a number%s", "apart", where);
		return json_null();
	}
	i64 apart = distance(spot.column->type, out + at, found + at);
	tell(c, "  %-10s %+" PRId64 "%s%s", "apart", apart, is_float ? " ulp" : "", where);
	return json_integer(apart);
}

/* A line and a member of `to` for each column. */
static void tell_columns(check *c, json_t *to, const char *before, const ts_vector_column *of, const u32 *row)
{
	char name[80];
	for (const ts_vector_column *a = of; a->name != NULL; a++) {
		snprintf(name, sizeof name, "%s%s", before, a->name);
		json_object_set_new(to, a->name, tell_values(c, name, a->type, a->count, row));
		row += a->count * ts_vector_type_words(a->type);
	}
}

/* Of records an object of the columns, else the array. */
static json_t *tell_outputs(check *c, const ts_vector *v, const char *what, const u32 *row)
{
	char before[40];
	if (!ts_vector_gives_record(v)) return tell_values(c, what, v->out[0].type, v->out[0].count, row);
	json_t *all = json_object();
	snprintf(before, sizeof before, "%s ", what);
	tell_columns(c, all, before, v->out, row);
	return all;
}

static json_t *tell_fault(check *c, const ts_vector_verdict *verdict)
{
	bool first = verdict->fault != TS_N_FAULTS && (verdict->first_faults >> verdict->fault & 1) != 0;
	u32 fault = verdict->fault;
	for (u32 f = 0; f < TS_N_FAULTS && !first; f++) {
		if ((verdict->first_faults >> f & 1) != 0) fault = f;
	}
	if (verdict->first_faults == 0) {
		tell(c, "  %-10s none that is known", "fault");
		return json_null();
	}
	const ts_vector_fault_info *info = &ts_vector_fault_table[fault];
	tell(c, "  %-10s %s: %s", "fault", info->name, info->remedy);
	return json_string(info->name);
}

static void tell_first(check *c, const ts_vector *v, const ts_vector_verdict *verdict)
{
	u32 out_words = ts_vector_out_words(v);
	const u32 *row = c->rows->in + (size_t)verdict->first * ts_vector_in_words(v);
	const u32 *out = c->rows->out + (size_t)verdict->first * out_words;
	const u32 *found = c->rows->found + (size_t)verdict->first * out_words;
	json_t *item = json_object(), *in = json_object();
	tell(c, "%s, item %" PRIu32 ", the first of %" PRIu32 " wrong: %s (%s%s)", v->name, verdict->first,
	     verdict->n_wrong, v->doc, v->rule[0] >= '0' && v->rule[0] <= '9' ? "rule " : "", v->rule);
	tell_columns(c, in, "", v->in, row);
	json_object_set_new(item, "primitive", json_string(v->name));
	json_object_set_new(item, "item", json_integer(verdict->first));
	json_object_set_new(item, "in", in);
	json_object_set_new(item, "expected", tell_outputs(c, v, "expected", out));
	json_object_set_new(item, "found", tell_outputs(c, v, "found", found));
	json_object_set_new(item, "element", json_integer(verdict->first_element));
	json_object_set_new(item, "apart", tell_distance(c, v, verdict->first_element, out, found));
	json_object_set_new(item, "fault", tell_fault(c, verdict));
	json_array_append_new(c->first_wrong, item);
}

static void tell_row(check *c, const ts_vector *v, const ts_vector_verdict *verdict)
{
	ts_table_text(&c->table, v->name);
	if (verdict == NULL) {
		ts_table_none(&c->table);
		ts_table_none(&c->table);
	} else {
		ts_table_count(&c->table, TS_VECTOR_ITEMS);
		ts_table_count(&c->table, verdict->n_wrong);
	}
	if (verdict == NULL || verdict->fault == TS_N_FAULTS) {
		ts_table_none(&c->table);
		ts_table_none(&c->table);
	} else {
		ts_table_text(&c->table, ts_vector_fault_table[verdict->fault].name);
		ts_table_count(&c->table, verdict->n_explained[verdict->fault]);
	}
}

static ts_status read_outputs(bool *there, check *c, const ts_vector *v, const char *dir)
{
	char name[64], descr[TS_VECTOR_DESCR];
	u64 shape[TS_MAX_DIMS];
	snprintf(name, sizeof name, "%s.out.npy", v->name);
	ts_vector_out_descr(descr, v);
	u32 n_dims = ts_vector_out_shape(shape, v);
	return ts_vectors_read(c->rows->found, there, dir, name, descr, ts_vector_out_bytes(v), n_dims, shape);
}

/* A port that started from other inputs is not judged. */
static ts_status check_inputs(check *c, const ts_vector *v, const char *dir)
{
	char name[64], descr[TS_VECTOR_DESCR];
	bool there;
	size_t bytes = ts_vector_in_words(v) * sizeof(u32);
	snprintf(name, sizeof name, "%s.in.npy", v->name);
	ts_vector_in_descr(descr, v);
	ts_status status = ts_vectors_read(c->rows->found, &there, dir, name, descr, bytes, 1, (u64[]){TS_VECTOR_ITEMS});
	if (status != TS_OK || !there || memcmp(c->rows->found, c->rows->in, bytes * TS_VECTOR_ITEMS) == 0) return status;
	return ts_fail("%s/%s: not the inputs of this version; write the vectors again with \"vectors -o\"", dir, name);
}

static ts_status check_primitive(check *c, const ts_vector *v, const char *dir)
{
	bool there;
	ts_vector_make(v, c->rows->in, c->rows->out);
	ts_status status = check_inputs(c, v, dir);
	if (status == TS_OK) status = read_outputs(&there, c, v, dir);
	if (status != TS_OK) return status;
	if (!there) {
		tell_row(c, v, NULL);
		return TS_OK;
	}
	ts_vector_verdict verdict = ts_vector_judge(v, c->rows->in, c->rows->out, c->rows->found);
	tell_row(c, v, &verdict);
	c->n_right += verdict.n_wrong == 0;
	c->n_wrong += verdict.n_wrong != 0;
	if (verdict.n_wrong != 0) tell_first(c, v, &verdict);
	return TS_OK;
}

static ts_status check_all(check *c, const char *dir)
{
	const ts_vector *v;
	ts_status status = ts_vectors_check_names(dir);
	if (status == TS_OK) status = ts_vectors_read_contract(dir);
	for (u32 i = 0; status == TS_OK && (v = ts_vectors_at(i)) != NULL; i++) {
		ts_progress("vectors", i + 1, ts_vectors_count());
		status = check_primitive(c, v, dir);
	}
	if (status != TS_OK || c->n_right + c->n_wrong > 0) return status;
	return ts_fail("%s: no PRIMITIVE.out.npy there; the names are those that \"vectors -o\" writes", dir);
}

static ts_status tell_details(check *c)
{
	if (ts_file_text_flush(&c->details, "the report") != TS_OK) return TS_ERROR;
	const char *line = c->details.bytes > 0 ? c->details.text : "";
	for (const char *end; (end = strchr(line, '\n')) != NULL; line = end + 1) {
		ts_report_failure(&c->report, "%.*s", (int)(end - line), line);
	}
	return TS_OK;
}

static ts_status tell_all(check *c)
{
	u32 n_absent = ts_vectors_count() - c->n_right - c->n_wrong;
	ts_report_value(&c->report, "right", json_integer(c->n_right));
	ts_report_value(&c->report, "wrong", json_integer(c->n_wrong));
	ts_report_value(&c->report, "absent", json_integer(n_absent));
	ts_report_value(&c->report, "first_wrong", json_incref(c->first_wrong));
	ts_report_table(&c->report, &c->table);
	if (tell_details(c) != TS_OK) return TS_ERROR;
	ts_report_line(&c->report, "%" PRIu32 " primitives right, %" PRIu32 " wrong, %" PRIu32 " not there", c->n_right,
	               c->n_wrong, n_absent);
	return ts_report_check(&c->report);
}

/* The report is printed only if it is whole, and released in any case. */
static ts_status work(check *c, const ts_cli *cli)
{
	ts_report_begin(&c->report, cli->job.output.json);
	c->report.quiet = cli->job.output.quiet;
	ts_report_value(&c->report, "contract", json_integer(TS_CONTRACT_VERSION));
	c->table = ts_table_begin("primitives", "", columns);
	ts_status status = check_all(c, cli->check);
	if (status == TS_OK) status = tell_all(c);
	ts_table_end(&c->table);
	if (status != TS_OK) {
		ts_report_discard(&c->report);
		return status;
	}
	status = ts_report_end(&c->report);
	return status != TS_OK ? status : c->n_wrong > 0 ? TS_DIFFERENT : TS_OK;
}

ts_status ts_vectors_check(const ts_cli *cli)
{
	check c = {.rows = ts_alloc(1, sizeof *c.rows, "arithmetic vectors"), .first_wrong = json_array()};
	ts_status status = c.rows != NULL ? ts_file_text_begin(&c.details, "the report") : TS_ERROR;
	if (status == TS_OK && c.first_wrong == NULL) status = ts_fail("the report: out of memory");
	if (status == TS_OK) status = work(&c, cli);
	if (c.details.out != NULL) ts_file_text_drop(&c.details);
	json_decref(c.first_wrong);
	free(c.rows);
	return status;
}
