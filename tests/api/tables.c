/* The tables that the API walks are those that the command lists, with all that their rows promise. */
#include "tests/api/api.h"

static void methods_list_their_stages_in_order(void **state)
{
	(void)state;
	const ts_method_info *method;
	const ts_stage_info *stage;
	size_t n = 0, n_stages = 0;
	for (; ts_stage_at(n_stages) != NULL; n_stages++) {
	}
	for (; (method = ts_method_at(n)) != NULL; n++) {
		assert_true(method->effect[0] != 0 && method->name[0] != 0 && method->doc[0] != 0);
		size_t i = 0;
		for (; (stage = ts_method_stage(method->effect, method->name, i)) != NULL; i++) {
			bool known = false;
			for (size_t k = 0; k < n_stages; k++) known |= ts_stage_at(k) == stage;
			assert_true(known && stage->doc[0] != 0);
			assert_true(ts_stage_input(stage->name, 0) != NULL && ts_stage_output(stage->name, 0) != NULL);
			assert_true(strcmp(stage->kind, "map") == 0 || strcmp(stage->kind, "emit") == 0 ||
			            strcmp(stage->kind, "scatter") == 0);
			const uint32_t number = ts_method_stage_number(method->effect, method->name, i);
			const uint32_t before = i > 0 ? ts_method_stage_number(method->effect, method->name, i - 1) : 0;
			assert_true(number == before || number == before + 1);
			assert_true(number > 0 && (stage->margin_of == NULL || number == before));
			if (stage->margin_of != NULL) {
				assert_string_equal(stage->margin_of, ts_method_stage(method->effect, method->name, i - 1)->name);
			}
		}
		assert_true(i >= 3);
	}
	assert_true(n >= 30 && n_stages > 40);
	assert_null(ts_method_at(n + 1));
	assert_null(ts_stage_at(n_stages));
	assert_string_equal(ts_method_at(0)->effect, "reflections");
	assert_null(ts_method_stage("reflections", "magic", 0));
	assert_int_equal(ts_method_stage_number("reflections", "magic", 0), 0);
	assert_int_equal(ts_method_stage_number("reflections", "epr", 1000), 0);
	assert_string_equal(ts_stage_output("eye", 0), "eye.depth_triangle");
	assert_null(ts_stage_output("eye", 1));
	assert_null(ts_stage_input("magic", 0));
}

static size_t bytes_of_type(const char *type) { return strcmp(type, "u64") == 0 ? 8 : 4; }

/* A record's bytes are those of its fields, so that a program can lay it out. */
static void fields_make_up_the_bytes_of_records(void **state)
{
	(void)state;
	const ts_buffer_info *buffer;
	const ts_field_info *field;
	size_t n = 0;
	for (; (buffer = ts_buffer_at(n)) != NULL; n++) {
		size_t bytes = 0;
		for (size_t i = 0; (field = ts_field_at(i)) != NULL; i++) {
			if (strcmp(field->record, buffer->element) == 0) bytes += field->count * bytes_of_type(field->type);
		}
		if (strncmp(buffer->element, "ts_", 3) == 0) assert_int_equal(bytes, buffer->element_bytes);
		assert_true(strchr(buffer->name, '.') != NULL && buffer->doc[0] != 0 && buffer->shape[0] != 0);
		if (strcmp(buffer->order, "set") == 0) assert_true(buffer->key[0] != 0);
		const bool eyes = strncmp(buffer->shape, "height width", 12) == 0 ||
		                  strncmp(buffer->shape, "eye_rows width", 14) == 0 ||
		                  strncmp(buffer->shape, "sample_rows width", 17) == 0;
		assert_int_equal(ts_buffer_is_image(buffer->name), eyes);
	}
	assert_true(n > 100);
	assert_int_equal(sizeof(ts_vertex), 80);
	assert_int_equal(sizeof(ts_material), 80);
}

/* Shapes are products and sums of numbers and of sizes that are listed. */
static void shapes_are_made_of_listed_sizes(void **state)
{
	(void)state;
	const ts_buffer_info *buffer;
	const ts_size_info *size;
	size_t n = 0, used = 0;
	for (; (size = ts_size_at(n)) != NULL; n++) assert_true(size->name[0] != 0 && size->doc[0] != 0);
	for (size_t i = 0; (buffer = ts_buffer_at(i)) != NULL; i++) {
		char shape[256], *rest = NULL;
		snprintf(shape, sizeof shape, "%s", buffer->shape);
		for (char *word = strtok_r(shape, " *+", &rest); word != NULL; word = strtok_r(NULL, " *+", &rest)) {
			size_t k = 0;
			while (k < n && strcmp(ts_size_at(k)->name, word) != 0) k++;
			if (k == n) assert_int_equal(strspn(word, "0123456789"), strlen(word));
			used += k < n;
		}
	}
	assert_true(n > 20 && used > 100);
	assert_null(ts_size_at(n + 1));
}

static void parameters_read_back_what_was_set(void **state)
{
	(void)state;
	ts_params *params = small_params(), *copy;
	const ts_param_info *param;
	char text[64], tiny[2];
	size_t n = 0;
	for (; (param = ts_param_at(n)) != NULL; n++) {
		done(ts_params_get(params, param->name, text, sizeof text));
		done(ts_params_set(params, param->name, text));
	}
	assert_true(n > 60);
	done(ts_params_copy(&copy, params));
	done(ts_params_set(params, "width", "128"));
	done(ts_params_get(copy, "width", text, sizeof text));
	assert_string_equal(text, "64");
	refused(ts_params_get(copy, "width", tiny, sizeof tiny), "does not fit");
	refused(ts_params_get(copy, "breadth", text, sizeof text), "breadth");
	refused(ts_params_set(copy, "width", "-1"), "width");
	ts_params_free(copy);
	ts_params_free(params);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(methods_list_their_stages_in_order),
		cmocka_unit_test(fields_make_up_the_bytes_of_records),
		cmocka_unit_test(shapes_are_made_of_listed_sizes),
		cmocka_unit_test(parameters_read_back_what_was_set),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
