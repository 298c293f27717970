-- What a course holds, a row of each table at least, under the version of the tables that first took it.
-- since 11
INSERT INTO instructors (id, token_hash, created_at) VALUES ('i', 'hash of i', '2026-03-01T08:00:00.000Z');
INSERT INTO courses (id, name, code, created_at) VALUES ('c', 'Graphics', 'CODE', '2026-03-01T08:00:00.000Z');
INSERT INTO sessions (token_hash, account_id, expires_at) VALUES ('hash of a session', 'i', '2026-03-02T08:00:00.000Z');
INSERT INTO speed_bands (source_key, band) VALUES ('key', 2);
INSERT INTO idempotency_keys (owner, key_hash, request_hash, made, created_at)
VALUES ('i', 'hash of a key', 'hash of a request', 'c', '2026-03-01T08:00:00.000Z');
INSERT INTO secrets (name, value) VALUES ('links', ${bytes:0102});
INSERT INTO exercise_files (exercise, revision, name, content) VALUES ('draw-dot', 'r1', 'exercise.yaml', ${bytes:7b7d});
-- since 12
INSERT INTO students (id, course_id, name, token_hash, joined_at, number, shown_name)
VALUES ('a', 'c', 'Ada', 'hash of a', '2026-03-01T08:00:00.000Z', 1, 'Ada');
INSERT INTO students (id, course_id, name, token_hash, joined_at, number, shown_name)
VALUES ('b', 'c', 'Ada', 'hash of b', '2026-03-01T09:00:00.000Z', 2, 'Ada (2)');
INSERT INTO hints (student_id, exercise, step, cost, taken_at) VALUES ('a', 'draw-dot', 1, 1, '2026-03-03T08:00:00.000Z');
INSERT INTO roster_fields (student_id, kind, value) VALUES ('a', 'email', 'ada@example.org');
INSERT INTO course_exercises (course_id, exercise, opens_at, due_at, zone, late_days, attempts, policy)
VALUES ('c', 'draw-dot', '2026-03-01T08:00:00.000Z', '2026-03-28T22:59:59.000Z', 'Europe/Berlin', 2, 3, 'last');
INSERT INTO extensions (student_id, exercise, due_at, reason) VALUES ('b', 'draw-dot', '2026-04-01T21:59:59.000Z', 'ill');
INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state, round, hint_cost)
VALUES ('s', 'a', 'draw-dot', 'r1', 1, 'class Dot {}', 9007199254740993, '2026-03-04T08:00:00.000Z', 'done', 1, 1);
INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state, round)
VALUES ('t', 'a', 'draw-dot', 'r1', 2, 'class Dot { }', 7, '2026-03-05T08:00:00.000Z', 'queued', 2);
INSERT INTO submissions (id, student_id, exercise, revision, attempt, source, seed, received_at, state, round, is_chosen)
VALUES ('u', 'b', 'draw-dot', 'r1', 1, 'class Dot {} // ё', 8, '2026-03-30T08:00:00.000Z', 'done', 1, 1);
INSERT INTO results (id, submission_id, run, is_current, revision, verdict, accuracy, stability, speed, points_of,
    isolation, nanos_per_item, reference_nanos, error, graded_at)
VALUES ('q', 's', 1, 0, 'r0', 'wrong', 2, 1, 0, 10, 'bubblewrap', 0, NULL, NULL, '2026-03-04T08:00:01.000Z');
INSERT INTO results (id, submission_id, run, is_current, revision, verdict, accuracy, stability, speed, points_of,
    isolation, nanos_per_item, reference_nanos, error, graded_at)
VALUES ('r', 's', 2, 1, 'r1', 'wrong', 5, 2, 1, 10, 'bubblewrap', 2.5, 5, 0.5, '2026-03-04T09:00:00.000Z');
INSERT INTO case_results (result_id, position, name, visibility, verdict, points, points_of, message, message_data, scene)
VALUES ('r', 0, 'steep', 'OPEN', 'WRONG', 0, 3, 'pixel (1, 2)', '', '{}');
INSERT INTO case_pictures (result_id, case_position, position, kind, png, png_ru, text, text_data, part)
VALUES ('r', 0, 0, 'actual', ${bytes:01}, ${bytes:02}, '#', '[]', NULL);
INSERT INTO diagnostics (result_id, position, line, column_number, message) VALUES ('q', 0, 3, 4, 'not a statement');
INSERT INTO speed_methods (result_id, position, method, ratio, error) VALUES ('r', 0, 'dda', 1.5, NULL);
INSERT INTO audit (id, noted_at, account_id, course_id, action, subject, detail)
VALUES ('n', '2026-03-01T08:00:00.000Z', 'i', 'c', 'rules', 'draw-dot', 'attempts 3');
INSERT INTO comments (id, submission_id, line, author_id, text, written_at)
VALUES ('k', 's', 3, 'i', 'why?', '2026-03-06T08:00:00.000Z');
-- since 12.1
UPDATE submissions SET due_at = '2026-03-28T22:59:59.000Z' WHERE id = 's';
-- since 13
UPDATE results SET ratio_low = 0.4, ratio_high = 0.6 WHERE id = 'r';
-- since 14
INSERT INTO regrades (id, course_id, exercise, revision, choice, is_dry, state, account_id, begun_at, settled_at)
VALUES ('g', 'c', 'draw-dot', 'r1', 'all', 0, 'accepted', 'i', '2026-03-04T08:59:00.000Z', '2026-03-04T09:00:00.000Z');
INSERT INTO regrade_items (regrade_id, submission_id, position, state, result_id, former_id)
VALUES ('g', 's', 1, 'done', 'r', 'q');
-- since 15
INSERT INTO adjustments (id, submission_id, points, reason, total_before, account_id, given_at)
VALUES ('p', 's', -2, 'copied', 8, 'i', '2026-03-07T08:00:00.000Z');
-- since 16
UPDATE instructors SET last_used_at = '2026-03-07T08:00:00.000Z', name = 'Grace', role = 'assistant' WHERE id = 'i';
INSERT INTO audit (id, noted_at, account_id, course_id, action, subject, detail)
VALUES ('m', '2026-03-07T08:00:00.000Z', 'i', NULL, 'staff-add', 'j', '');
-- since 17
INSERT INTO comments (id, submission_id, line, author_id, text, written_at, last_line, thread_id, is_open)
VALUES ('l', 's', 3, 'a', 'so', '2026-03-06T09:00:00.000Z', 4, 'k', 1);
INSERT INTO kept_comments (id, course_id, name, text, account_id, kept_at)
VALUES ('x', 'c', 'names', 'Say it.', 'i', '2026-03-06T08:00:00.000Z');
-- since 18
UPDATE course_exercises SET late_penalty = 20;
UPDATE submissions SET penalty_agreed = 20, penalty = 20 WHERE id = 'u';
-- since 19
INSERT INTO exams (id, course_id, name, opens_at, closes_at, zone, minutes, is_fixed, grace, addresses, takes_over)
VALUES ('e', 'c', 'Midterm', '2026-04-01T08:00:00.000Z', '2026-04-01T10:00:00.000Z', 'UTC', 90, 0, 30, '10.0.0.0/8', 0);
INSERT INTO exam_exercises (exam_id, exercise, position) VALUES ('e', 'draw-dot', 0);
INSERT INTO exam_sittings (exam_id, student_id, extra, started_at) VALUES ('e', 'a', 15, '2026-04-01T08:05:00.000Z');
INSERT INTO exam_drafts (exam_id, student_id, exercise, source, saved_at, is_handed)
VALUES ('e', 'a', 'draw-dot', 'class Dot {', '2026-04-01T08:06:00.000Z', 0);
INSERT INTO exam_events (id, exam_id, student_id, number, noted_at, kind, address, detail)
VALUES ('v', 'e', 'a', 1, '2026-04-01T08:05:00.000Z', 'begin', '10.0.0.7', '');
-- since 20
INSERT INTO workers (name, host, serves, isolation, isolation_data, slots, is_draining, started_at, seen_at)
VALUES ('w', 'lab-1', 0, 'bubblewrap 0.8.0', '[]', 2, 1, '2026-03-01T08:00:00.000Z', '2026-03-01T09:00:00.000Z');
-- since 21
INSERT INTO complaints (id, submission_id, result_id, case_name, text, opened_at, state, answer, account_id, answered_at,
    regrade_id)
VALUES ('y', 's', 'r', 'steep', 'it is right', '2026-03-08T08:00:00.000Z', 'accepted', 'yes', 'i',
    '2026-03-08T09:00:00.000Z', 'g');
UPDATE students SET named_on_front = 1 WHERE id = 'b';
-- since 22
INSERT INTO once_only (key_hash, kind, value, expires_at) VALUES ('hash of a state', 'oidc', '{}', '2026-03-01T08:10:00.000Z');
-- since 23
INSERT INTO lti_platforms (id, name, issuer, client_id, deployment, login_url, token_url, keys_url, makes_staff, added_at)
VALUES ('o', 'Moodle', 'https://m.example', 'r', '1', 'l', 't', 'k', 1, '2026-03-01T08:00:00.000Z');
INSERT INTO lti_contexts (platform_id, context, title, course_id, bound_at)
VALUES ('o', '7', 'CG', 'c', '2026-03-01T08:00:00.000Z');
INSERT INTO lti_students (platform_id, subject, course_id, student_id) VALUES ('o', 'sub', 'c', 'a');
INSERT INTO lti_staff (platform_id, subject, account_id) VALUES ('o', 'boss', 'i');
INSERT INTO lti_links (id, platform_id, context, link, exercise, line_item) VALUES ('h', 'o', '7', '9', 'draw-dot', 'https://m.example/1');
INSERT INTO lti_scores (link_id, student_id, exercise, points, points_of, version, changed_at, sent_points, sent_at)
VALUES ('h', 'a', 'draw-dot', 8, 10, 3, '2026-03-04T09:00:00.000Z', 8, '2026-03-04T09:00:05.000Z');
-- since 24
INSERT INTO results (id, submission_id, run, is_current, revision, verdict, accuracy, stability, speed, points_of,
    isolation, nanos_per_item, graded_at)
VALUES ('z', 's', 3, 0, 'r1', 'ok', 6, 3, 1, 10, 'bubblewrap', 0, '2026-03-09T08:00:01.000Z');
INSERT INTO trials (id, submission_id, account_id, revision, source, begun_at, state, tries, result_id)
VALUES ('d', 's', 'i', 'r1', 'class Dot { /* mended */ }', '2026-03-09T08:00:00.000Z', 'done', 1, 'z');
-- since 25
INSERT INTO chosen_exercises (course_id, exercise) VALUES ('c', 'draw-dot');
-- since 26
UPDATE lti_students SET told_name = 'Ada L.';
-- since 27
INSERT INTO group_comments (course_id, exercise, wrong_group, text, account_id, written_at)
VALUES ('c', 'draw-dot', 'hash of answers', 'Look at x.', 'i', '2026-03-09T08:00:00.000Z');
-- since 28
UPDATE case_pictures SET png_hash = 'hash of a picture';
-- since 29
UPDATE submissions SET begins_turns = 1 WHERE id IN ('s', 'u');
-- since 30
INSERT INTO instructors (id, token_hash, created_at, name, role, course_id)
VALUES ('j', 'hash of j', '2026-03-09T08:00:00.000Z', 'Jo', 'instructor', 'c');
-- since 31
INSERT INTO regrades (id, course_id, exercise, revision, choice, is_dry, state, account_id, begun_at, case_name, earns_stability)
VALUES ('f', 'c', 'draw-dot', 'r1', 'some', 0, 'grading', 'i', '2026-03-10T08:00:00.000Z', 'steep', 1);
-- since 32
INSERT INTO course_limits (course_id, per_minute, waiting) VALUES ('c', 3, NULL);
-- since 33
INSERT INTO courses (id, name, code, created_at, last_number)
VALUES ('n', 'Geometry', 'NEXT', '2026-03-10T08:00:00.000Z', 30);
