/* `probe TRACE`: why a pixel, a texel, a triangle or a point is as it is. One description, printed as text or as
 * JSON. */
#include "cli/client.h"
#include "study/results/table.h"

enum { WIDTH = 118, ITEM_TEXT = 512 };

static bool is_valued(const json_t *v)
{
	return json_object_size(v) == 2 && json_object_get(v, "value") != NULL && json_object_get(v, "bits") != NULL;
}

/* Values that fit on a line. */
static bool is_leaf(const json_t *v)
{
	if (json_is_object(v)) return is_valued(v);
	for (size_t i = 0; i < json_array_size(v); i++) {
		if (!is_leaf(json_array_get(v, i)) || json_is_object(json_array_get(v, i))) return false;
	}
	return true;
}

static size_t say(char *text, size_t used, const json_t *v);

static size_t say_list(char *text, size_t used, const json_t *list, const char *apart)
{
	for (size_t i = 0; i < json_array_size(list) && used < ITEM_TEXT - 64; i++) {
		if (i > 0) used += (size_t)snprintf(text + used, ITEM_TEXT - used, "%s", apart);
		used = say(text, used, json_array_get(list, i));
	}
	return used;
}

static size_t say_bits(char *text, size_t used, const json_t *v)
{
	const json_t *bits = json_object_get(v, "bits");
	used = say(text, used, json_object_get(v, "value"));
	used += (size_t)snprintf(text + used, ITEM_TEXT - used, " (");
	used = json_is_array(bits) ? say_list(text, used, bits, " ") : say(text, used, bits);
	return used + (size_t)snprintf(text + used, ITEM_TEXT - used, ")");
}

/* Appends a leaf to text of ITEM_TEXT bytes, of which `used` are; long ones are cut. Returns the new `used`. */
static size_t say(char *text, size_t used, const json_t *v)
{
	if (used > ITEM_TEXT - 64) return used;
	if (json_is_object(v)) return say_bits(text, used, v);
	if (json_is_array(v)) {
		used += (size_t)snprintf(text + used, ITEM_TEXT - used, "[");
		used = say_list(text, used, v, ", ");
		return used + (size_t)snprintf(text + used, ITEM_TEXT - used, "]");
	}
	size_t room = ITEM_TEXT - used;
	int n = json_is_string(v)    ? snprintf(text + used, room, "%s", json_string_value(v))
	        : json_is_integer(v) ? snprintf(text + used, room, "%" JSON_INTEGER_FORMAT, json_integer_value(v))
	        : json_is_real(v)    ? snprintf(text + used, room, "%.9g", json_real_value(v))
	                             : snprintf(text + used, room, "%s", json_is_true(v) ? "yes" : "no");
	return used + (n < 0 ? 0 : (size_t)n < room ? (size_t)n : room - 1);
}

static void print(ts_report *report, json_t *v, int depth, bool item);

/* The leaves of an element of a list, as many per line as fit, behind a dash. */
static void print_leaves(ts_report *report, json_t *o, int depth)
{
	char line[2 * ITEM_TEXT] = "", text[ITEM_TEXT];
	const char *key, *mark = "- ";
	json_t *v;
	json_object_foreach (o, key, v) {
		if (!is_leaf(v)) continue;
		say(text, 0, v);
		size_t n = strlen(line);
		if (n > 0 && n + strlen(key) + strlen(text) + 4 > (size_t)(WIDTH - depth)) {
			ts_report_line(report, "%*s%s%s", depth, "", mark, line);
			mark = "  ";
			n = 0;
		}
		snprintf(line + n, sizeof line - n, "%s%s: %s", n > 0 ? "; " : "", key, text);
	}
	if (line[0] != 0) ts_report_line(report, "%*s%s%s", depth, "", mark, line);
}

static void print_member(ts_report *report, const char *key, json_t *v, int depth, bool item)
{
	char text[ITEM_TEXT];
	if (is_leaf(v)) {
		if (item) return;
		say(text, 0, v);
		bool none = json_is_array(v) && json_array_size(v) == 0;
		ts_report_line(report, "%*s%s: %s", depth, "", key, none ? "none" : text);
	} else {
		ts_report_line(report, "%*s%s:", depth, "", key);
		print(report, v, depth + 2, false);
	}
}

/* Members of an object, one per line, or elements of a list; item: its leaves are already printed. */
static void print(ts_report *report, json_t *v, int depth, bool item)
{
	const char *key;
	json_t *member;
	size_t i;
	if (json_is_object(v)) {
		json_object_foreach (v, key, member) print_member(report, key, member, depth, item);
		return;
	}
	json_array_foreach (v, i, member) {
		char text[ITEM_TEXT];
		if (json_is_object(member)) {
			print_leaves(report, member, depth);
			print(report, member, depth + 2, true);
		} else {
			say(text, 0, member);
			ts_report_line(report, "%*s- %s", depth, "", text);
		}
	}
}

static ts_status read_pixel(const ts_cli *cli, u32 *x, u32 *y)
{
	char item[16];
	const char *list = cli->place.pixel;
	ts_words_item(&list, item, sizeof item);
	if (list == NULL || strchr(list, ',') != NULL)
		return ts_fail("--pixel %s: not two numbers; write --pixel X,Y", cli->place.pixel);
	if (ts_words_count(x, item, 0, 65535, "--pixel X") != TS_OK) return TS_ERROR;
	return ts_words_count(y, list, 0, 65535, "--pixel Y");
}

static ts_status ask_pixel(const ts_cli *cli, ts_context *context, const ts_trace *trace, ts_tree **answer)
{
	u32 x, y;
	const char *view = cli->place.view;
	if (read_pixel(cli, &x, &y) != TS_OK) return TS_ERROR;
	return ts_probe_pixel(context, answer, trace, x, y, view != NULL && strcmp(view, "eye") != 0 ? view : NULL);
}

/* "P", or the key "PIECE,X,Y". */
static ts_status ask_point(const ts_cli *cli, ts_context *context, const ts_trace *trace, ts_tree **answer)
{
	char item[16];
	i64 key[3];
	const char *list = cli->place.point;
	u32 n = 0;
	for (; n < 3 && ts_words_item(&list, item, sizeof item); n++) {
		u32 value;
		bool minus = n > 0 && item[0] == '-';
		if (ts_words_count(&value, item + minus, 0, 4294967294u, "--point") != TS_OK) return TS_ERROR;
		key[n] = minus ? -(i64)value : (i64)value;
	}
	if (list != NULL || n == 2) return ts_fail("--point %s: neither an index nor a key PIECE,X,Y", cli->place.point);
	return n == 3 ? ts_probe_point_key(context, answer, trace, key)
	              : ts_probe_point(context, answer, trace, (u64)key[0]);
}

static ts_status ask(const ts_cli *cli, ts_context *context, const ts_trace *trace, ts_tree **answer)
{
	if (cli->place.pixel != NULL) return ask_pixel(cli, context, trace, answer);
	if (cli->place.point != NULL) return ask_point(cli, context, trace, answer);
	return ts_probe_triangle(context, answer, trace, cli->place.triangle);
}

static ts_status print_answer(const ts_cli *cli, json_t *answer)
{
	ts_report report;
	const char *key;
	json_t *v;
	ts_report_begin(&report, cli->job.output.json);
	print(&report, answer, 0, false);
	ts_report_value(&report, "trace", json_string(cli->arguments[0]));
	json_object_foreach (answer, key, v) ts_report_value(&report, key, json_incref(v));
	return ts_report_end(&report);
}

ts_status ts_probe_command(ts_cli *cli)
{
	ts_context *context;
	ts_trace *trace = NULL;
	ts_tree *tree = NULL;
	int asked = (cli->place.pixel != NULL) + (cli->place.point != NULL) + cli->given[TS_OPTION_TRIANGLE];
	if (asked != 1) return ts_fail("probe: one of --pixel X,Y, --triangle T and --point P must be given");
	if (cli->place.view != NULL && cli->place.pixel == NULL) return ts_fail("probe: --view goes with --pixel");
	ts_status status = ts_client_open(&context, cli);
	if (status == TS_OK) status = ts_trace_open(context, &trace, cli->arguments[0]);
	if (status == TS_OK) status = ask(cli, context, trace, &tree);
	json_t *answer = ts_client_json(tree);
	if (status == TS_OK) status = answer != NULL ? print_answer(cli, answer) : TS_ERROR;
	json_decref(answer);
	ts_trace_close(trace);
	ts_context_close(context);
	return status;
}

/* What each kind of question reports, below how to ask it. */
void ts_probe_help(void)
{
	const ts_probe_info *row;
	const char *option = "";
	char text[512];
	for (size_t i = 0; (row = ts_probe_at(i)) != NULL; option = row->option, i++) {
		if (strcmp(row->option, option) != 0) printf("\nWhat %s also shows:\n", row->option);
		snprintf(text, sizeof text, "%s%s%s%s", row->view[0] != 0 ? "VIEW " : "", row->view,
		         row->view[0] != 0 ? ": " : "", row->answer);
		ts_help_item(row->methods, text);
	}
}
