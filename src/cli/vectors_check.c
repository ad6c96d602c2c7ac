/* The verdict on a port's outputs: a table of the primitives, and the first wrong item of each wrong one. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/vectors.h"
#include "study/results/table.h"

typedef struct {
	ts_context *context;
	ts_vector_rows rows;
	ts_report report;
	ts_table table;
	json_t *first_wrong;
	ts_file_text details; /* printed below the table */
	u32 n_right, n_wrong;
} check;

static const ts_column columns[] = {
	{"primitive", "primitive", false}, {"items", "items", true},     {"wrong", "wrong", true},
	{"fault", "explained by", false},  {"explained", "items", true}, {NULL, NULL, false},
};

/* Adds a line below the table. */
__attribute__((format(printf, 2, 3))) static void add_line(check *c, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	vfprintf(c->details.out, format, arguments);
	va_end(arguments);
	fputc('\n', c->details.out);
}

/* Decimal, hexadecimal for floats, and bits. */
typedef struct {
	char decimal[40], hex[40], bits[24];
} value_text;

/* 32-bit words of one value. */
static u32 words_of(ts_vector_type type) { return type == TS_VECTOR_I64 || type == TS_VECTOR_U64 ? 2 : 1; }

static value_text print_value(ts_vector_type type, const u32 *row)
{
	value_text r = {"", "", ""};
	u64 wide = (u64)row[words_of(type) - 1] << 32 | row[0];
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
	if (words_of(type) == 2) snprintf(r.bits, sizeof r.bits, "%016" PRIx64, wide);
	return r;
}

/* One line of text and an array of values, for the elements of a column; `row` points to its first word. */
static json_t *report_values(check *c, const char *name, const ts_vector_column_info *of, const u32 *row)
{
	FILE *out = c->details.out;
	json_t *list = json_array();
	fprintf(out, "  %-10s ", name);
	for (u32 k = 0; k < of->count; k++, row += words_of(of->type)) {
		value_text t = print_value(of->type, row);
		fprintf(out, "%s%s%s%s (%s)", k == 0 ? "" : ", ", t.decimal, t.hex[0] != 0 ? " " : "", t.hex, t.bits);
		json_t *value = json_pack("{ss, ss}", "decimal", t.decimal, "bits", t.bits);
		if (t.hex[0] != 0) json_object_set_new(value, "hex", json_string(t.hex));
		json_array_append_new(list, value);
	}
	fputc('\n', out);
	return list;
}

/* A line and a member of an object for each of n columns. */
static json_t *report_columns(check *c, const char *before, const ts_vector_column_info *of, u32 n, const u32 *row)
{
	char name[80];
	json_t *all = json_object();
	for (u32 i = 0; i < n; i++) {
		snprintf(name, sizeof name, "%s%s", before, of[i].name);
		json_object_set_new(all, of[i].name, report_values(c, name, &of[i], row + of[i].word));
	}
	return all;
}

/* For records an object of the columns, otherwise the array. */
static json_t *report_outputs(check *c, const ts_vector_info *v, const char *what, const u32 *row)
{
	char before[40];
	if (!v->record) return report_values(c, what, v->outputs, row);
	snprintf(before, sizeof before, "%s ", what);
	return report_columns(c, before, v->outputs, v->n_outputs, row);
}

/* " in arrives", " in element 1 of l", " in element 2"; empty if there is only one. */
static void name_place(char *text, size_t bytes, const ts_vector_column_info *column, u32 element)
{
	size_t used = 0;
	text[0] = 0;
	if (column->count > 1) used = (size_t)snprintf(text, bytes, " in element %" PRIu32, element);
	if (column->name[0] != 0) snprintf(text + used, bytes - used, "%s%s", used > 0 ? " of " : " in ", column->name);
}

/* The distance of the first wrong value. */
static json_t *report_distance(check *c, const ts_vector_info *v, const ts_vector_judged *judged)
{
	char where[80];
	const ts_vector_column_info *column = &v->outputs[judged->first_column];
	name_place(where, sizeof where, column, judged->first_element);
	if (judged->first_nan) {
		add_line(c, "  %-10s not a number%s", "apart", where);
		return json_null();
	}
	const char *unit = column->type == TS_VECTOR_F32 ? " ulp" : "";
	add_line(c, "  %-10s %+" PRId64 "%s%s", "apart", judged->first_apart, unit, where);
	return json_integer(judged->first_apart);
}

static json_t *report_fault(check *c, const ts_vector_judged *judged)
{
	if (judged->first_fault == NULL) {
		add_line(c, "  %-10s none that is known", "fault");
		return json_null();
	}
	add_line(c, "  %-10s %s: %s", "fault", judged->first_fault, judged->first_remedy);
	return json_string(judged->first_fault);
}

/* The place of the first wrong value among the elements of all columns. */
static u32 element_of_all(const ts_vector_info *v, const ts_vector_judged *judged)
{
	u32 element = judged->first_element;
	for (u32 i = 0; i < judged->first_column; i++) element += v->outputs[i].count;
	return element;
}

static ts_status report_first(check *c, const ts_vector_info *v, const ts_vector_judged *judged)
{
	const size_t first = judged->first, out_at = first * v->out_words;
	if (ts_vector_words(c->context, c->rows.in, c->rows.out, v->name) != TS_OK) return TS_ERROR;
	json_t *item = json_object();
	add_line(c, "%s, item %zu, the first of %" PRIu32 " wrong: %s (%s%s)", v->name, first, judged->n_wrong, v->doc,
	         v->rule[0] >= '0' && v->rule[0] <= '9' ? "rule " : "", v->rule);
	json_t *in = report_columns(c, "", v->inputs, v->n_inputs, c->rows.in + first * v->in_words);
	json_object_set_new(item, "primitive", json_string(v->name));
	json_object_set_new(item, "item", json_integer((json_int_t)first));
	json_object_set_new(item, "in", in);
	json_object_set_new(item, "expected", report_outputs(c, v, "expected", c->rows.out + out_at));
	json_object_set_new(item, "found", report_outputs(c, v, "found", c->rows.found + out_at));
	json_object_set_new(item, "element", json_integer(element_of_all(v, judged)));
	json_object_set_new(item, "apart", report_distance(c, v, judged));
	json_object_set_new(item, "fault", report_fault(c, judged));
	json_array_append_new(c->first_wrong, item);
	return TS_OK;
}

/* judged NULL: there are no outputs. */
static void report_row(check *c, const ts_vector_info *v, const ts_vector_judged *judged)
{
	ts_table_text(&c->table, v->name);
	if (judged == NULL) {
		ts_table_none(&c->table);
		ts_table_none(&c->table);
	} else {
		ts_table_count(&c->table, v->items);
		ts_table_count(&c->table, judged->n_wrong);
	}
	if (judged == NULL || judged->fault == NULL) {
		ts_table_none(&c->table);
		ts_table_none(&c->table);
	} else {
		ts_table_text(&c->table, judged->fault);
		ts_table_count(&c->table, judged->n_explained);
	}
}

static ts_status read_outputs(bool *there, check *c, const ts_vector_info *v, const char *dir)
{
	char name[64];
	const size_t elements = v->n_dims > 1 ? v->shape[1] : 1, bytes = v->out_words * sizeof(u32) / elements;
	snprintf(name, sizeof name, "%s.out.npy", v->name);
	return ts_vectors_read(c->rows.found, there, dir, name, v->out_dtype, bytes, v->n_dims, v->shape);
}

/* A port that started from other inputs is not judged. */
static ts_status check_inputs(check *c, const ts_vector_info *v, const char *dir)
{
	char name[64];
	bool there;
	const size_t bytes = v->in_words * sizeof(u32);
	const u64 items = v->items;
	u32 *found = c->rows.found;
	snprintf(name, sizeof name, "%s.in.npy", v->name);
	ts_status status = ts_vectors_read(found, &there, dir, name, v->in_dtype, bytes, 1, &items);
	if (status != TS_OK || !there) return status;
	if (ts_vector_words(c->context, c->rows.in, NULL, v->name) != TS_OK) return TS_ERROR;
	if (memcmp(found, c->rows.in, bytes * v->items) == 0) return TS_OK;
	return ts_fail("%s/%s: not the inputs of this version; write the vectors again with \"vectors -o\"", dir, name);
}

static ts_status check_primitive(check *c, const ts_vector_info *v, const char *dir)
{
	bool there;
	ts_vector_judged judged = {.bytes = sizeof judged};
	ts_status status = check_inputs(c, v, dir);
	if (status == TS_OK) status = read_outputs(&there, c, v, dir);
	if (status != TS_OK) return status;
	if (there && ts_vector_check(c->context, &judged, v->name, c->rows.found) == TS_ERROR) return TS_ERROR;
	report_row(c, v, there ? &judged : NULL);
	c->n_right += there && judged.n_wrong == 0;
	c->n_wrong += judged.n_wrong != 0;
	return judged.n_wrong != 0 ? report_first(c, v, &judged) : TS_OK;
}

static ts_status check_all(check *c, const char *dir)
{
	const ts_vector_info *v;
	const u32 n = ts_vectors_total();
	ts_status status = ts_vectors_check_names(dir);
	if (status == TS_OK) status = ts_vectors_read_contract(dir);
	for (u32 i = 0; status == TS_OK && (v = ts_vector_at(i)) != NULL; i++) {
		ts_progress("vectors", i + 1, n);
		status = check_primitive(c, v, dir);
	}
	if (status != TS_OK || c->n_right + c->n_wrong > 0) return status;
	return ts_fail("%s: no PRIMITIVE.out.npy there; the names are those that \"vectors -o\" writes", dir);
}

static ts_status report_details(check *c)
{
	if (ts_file_text_flush(&c->details, "the report") != TS_OK) return TS_ERROR;
	const char *line = c->details.bytes > 0 ? c->details.text : "";
	for (const char *end; (end = strchr(line, '\n')) != NULL; line = end + 1) {
		ts_report_failure(&c->report, "%.*s", (int)(end - line), line);
	}
	return TS_OK;
}

static ts_status report_all(check *c)
{
	u32 n_absent = ts_vectors_total() - c->n_right - c->n_wrong;
	ts_report_value(&c->report, "right", json_integer(c->n_right));
	ts_report_value(&c->report, "wrong", json_integer(c->n_wrong));
	ts_report_value(&c->report, "absent", json_integer(n_absent));
	ts_report_value(&c->report, "first_wrong", json_incref(c->first_wrong));
	ts_report_table(&c->report, &c->table);
	if (report_details(c) != TS_OK) return TS_ERROR;
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
	if (status == TS_OK) status = report_all(c);
	ts_table_end(&c->table);
	if (status != TS_OK) {
		ts_report_discard(&c->report);
		return status;
	}
	status = ts_report_end(&c->report);
	return status != TS_OK ? status : c->n_wrong > 0 ? TS_DIFFERENT : TS_OK;
}

ts_status ts_vectors_check(const ts_cli *cli, ts_context *context)
{
	check c = {.context = context, .first_wrong = json_array()};
	ts_status status = ts_vectors_rows(&c.rows);
	if (status == TS_OK) status = ts_file_text_begin(&c.details, "the report");
	if (status == TS_OK && c.first_wrong == NULL) status = ts_fail("the report: out of memory");
	if (status == TS_OK) status = work(&c, cli);
	if (c.details.out != NULL) ts_file_text_drop(&c.details);
	json_decref(c.first_wrong);
	free(c.rows.in);
	return status;
}
