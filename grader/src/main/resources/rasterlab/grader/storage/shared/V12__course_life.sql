-- What a course needs for its life. Both databases run these statements; what stands in braces is a type that they name
-- differently.

-- A result is a run of grading: a regrade adds a run and overwrites none. One of a submission's runs counts, that is its
-- current one. Before, there was one result for each revision of the exercise, and the latest counted.
CREATE TABLE runs (
    id TEXT PRIMARY KEY,
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    run INTEGER NOT NULL CHECK (run >= 1),
    is_current INTEGER NOT NULL CHECK (is_current IN (0, 1)),
    revision TEXT NOT NULL,
    verdict TEXT NOT NULL,
    accuracy INTEGER NOT NULL,
    stability INTEGER NOT NULL,
    speed INTEGER NOT NULL,
    points_of INTEGER NOT NULL,
    isolation TEXT NOT NULL,
    nanos_per_item ${real} NOT NULL,
    reference_nanos ${real} CHECK (reference_nanos > 0),
    error ${real} CHECK (error >= 0),
    graded_at TEXT NOT NULL,
    UNIQUE (submission_id, run)
) ${strict};
CREATE UNIQUE INDEX results_that_count ON runs (submission_id) WHERE is_current = 1;

INSERT INTO runs (id, submission_id, run, is_current, revision, verdict, accuracy, stability, speed, points_of, isolation,
    nanos_per_item, reference_nanos, error, graded_at)
SELECT submission_id || '-' || run, submission_id, run, CASE WHEN run = runs_of_it THEN 1 ELSE 0 END, revision, verdict,
    accuracy, stability, speed, points_of, isolation, nanos_per_item, reference_nanos, error, graded_at
FROM (
    SELECT results.*, row_number() OVER (PARTITION BY submission_id ORDER BY graded_at, revision) AS run,
        count(*) OVER (PARTITION BY submission_id) AS runs_of_it
    FROM results
) AS numbered;

CREATE TABLE run_cases (
    result_id TEXT NOT NULL REFERENCES runs (id),
    position INTEGER NOT NULL,
    name TEXT NOT NULL,
    visibility TEXT NOT NULL,
    verdict TEXT NOT NULL,
    points INTEGER NOT NULL,
    points_of INTEGER NOT NULL,
    message TEXT NOT NULL,
    message_data TEXT NOT NULL DEFAULT '',
    scene TEXT NOT NULL,
    PRIMARY KEY (result_id, position)
) ${strict};
INSERT INTO run_cases (result_id, position, name, visibility, verdict, points, points_of, message, message_data, scene)
SELECT runs.id, position, name, visibility, one.verdict, points, one.points_of, message, message_data, scene
FROM case_results AS one JOIN runs ON runs.submission_id = one.submission_id AND runs.revision = one.revision;

CREATE TABLE run_pictures (
    result_id TEXT NOT NULL,
    case_position INTEGER NOT NULL,
    position INTEGER NOT NULL,
    kind TEXT NOT NULL,
    png ${bytes} NOT NULL,
    png_ru ${bytes},
    text TEXT NOT NULL,
    text_data TEXT NOT NULL,
    part TEXT,
    PRIMARY KEY (result_id, case_position, position),
    UNIQUE (result_id, case_position, kind),
    FOREIGN KEY (result_id, case_position) REFERENCES run_cases (result_id, position)
) ${strict};
INSERT INTO run_pictures (result_id, case_position, position, kind, png, png_ru, text, text_data, part)
SELECT runs.id, case_position, position, kind, png, png_ru, text, text_data, part
FROM case_pictures AS one JOIN runs ON runs.submission_id = one.submission_id AND runs.revision = one.revision;

CREATE TABLE run_diagnostics (
    result_id TEXT NOT NULL REFERENCES runs (id),
    position INTEGER NOT NULL,
    line INTEGER NOT NULL,
    column_number INTEGER NOT NULL,
    message TEXT NOT NULL,
    message_data TEXT NOT NULL DEFAULT '',
    PRIMARY KEY (result_id, position)
) ${strict};
INSERT INTO run_diagnostics (result_id, position, line, column_number, message, message_data)
SELECT runs.id, position, line, column_number, message, message_data
FROM diagnostics AS one JOIN runs ON runs.submission_id = one.submission_id AND runs.revision = one.revision;

CREATE TABLE run_methods (
    result_id TEXT NOT NULL REFERENCES runs (id),
    position INTEGER NOT NULL,
    method TEXT NOT NULL,
    ratio ${real} NOT NULL CHECK (ratio > 0),
    error ${real} CHECK (error >= 0),
    PRIMARY KEY (result_id, position)
) ${strict};
INSERT INTO run_methods (result_id, position, method, ratio, error)
SELECT runs.id, position, method, ratio, one.error
FROM speed_methods AS one JOIN runs ON runs.submission_id = one.submission_id AND runs.revision = one.revision;

DROP TABLE case_pictures;
DROP TABLE case_results;
DROP TABLE diagnostics;
DROP TABLE speed_methods;
DROP TABLE results;
ALTER TABLE runs RENAME TO results;
ALTER TABLE run_cases RENAME TO case_results;
ALTER TABLE run_pictures RENAME TO case_pictures;
ALTER TABLE run_diagnostics RENAME TO diagnostics;
ALTER TABLE run_methods RENAME TO speed_methods;

-- A student's number in the course, from 1 in the order of joining, stays theirs; and no two are shown under one name.
-- What ends like a number in brackets gets one too, so that it cannot be mistaken for another's.
ALTER TABLE students ADD COLUMN number INTEGER NOT NULL DEFAULT 0;
ALTER TABLE students ADD COLUMN shown_name TEXT NOT NULL DEFAULT '';
UPDATE students SET number =
    (SELECT count(*) FROM students AS earlier
     WHERE earlier.course_id = students.course_id
       AND (earlier.joined_at, earlier.id) <= (students.joined_at, students.id));
UPDATE students SET shown_name =
    CASE WHEN name LIKE '%)' OR EXISTS
            (SELECT 1 FROM students AS earlier
             WHERE earlier.course_id = students.course_id AND earlier.name = students.name
               AND earlier.number < students.number)
        THEN name || ' (' || number || ')'
        ELSE name END;
CREATE UNIQUE INDEX students_by_number ON students (course_id, number);
CREATE UNIQUE INDEX students_by_shown_name ON students (course_id, shown_name);

-- What a roster calls a student, by the name of its column's meaning, so that marks find back to where it came from.
CREATE TABLE roster_fields (
    student_id TEXT NOT NULL REFERENCES students (id),
    kind TEXT NOT NULL,
    value TEXT NOT NULL,
    PRIMARY KEY (student_id, kind)
) ${strict};
CREATE INDEX roster_fields_by_value ON roster_fields (kind, value);

-- Rules of an exercise in a course. Without late days, whatever is handed in late counts, with a mark.
CREATE TABLE course_exercises (
    course_id TEXT NOT NULL REFERENCES courses (id),
    exercise TEXT NOT NULL,
    opens_at TEXT,
    due_at TEXT,
    zone TEXT NOT NULL DEFAULT 'UTC',
    late_days INTEGER CHECK (late_days >= 0),
    attempts INTEGER CHECK (attempts >= 1),
    policy TEXT NOT NULL DEFAULT 'best' CHECK (policy IN ('best', 'last', 'chosen')),
    PRIMARY KEY (course_id, exercise)
) ${strict};
INSERT INTO course_exercises (course_id, exercise, due_at) SELECT course_id, exercise, due_at FROM deadlines;
DROP TABLE deadlines;

CREATE TABLE extensions (
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    due_at TEXT NOT NULL,
    reason TEXT NOT NULL,
    PRIMARY KEY (student_id, exercise)
) ${strict};

ALTER TABLE submissions ADD COLUMN is_chosen INTEGER NOT NULL DEFAULT 0 CHECK (is_chosen IN (0, 1));

-- Who teaches: an assistant marks and comments, and changes no rules.
ALTER TABLE instructors ADD COLUMN name TEXT NOT NULL DEFAULT '';
ALTER TABLE instructors ADD COLUMN role TEXT NOT NULL DEFAULT 'instructor' CHECK (role IN ('instructor', 'assistant'));

-- What staff changed, with nothing secret in it; rows are only ever added.
CREATE TABLE audit (
    id TEXT PRIMARY KEY,
    noted_at TEXT NOT NULL,
    account_id TEXT NOT NULL,
    course_id TEXT NOT NULL REFERENCES courses (id),
    action TEXT NOT NULL,
    subject TEXT NOT NULL,
    detail TEXT NOT NULL
) ${strict};
CREATE INDEX audit_by_course ON audit (course_id, noted_at);

-- What is said about a submission, or about one of its lines.
CREATE TABLE comments (
    id TEXT PRIMARY KEY,
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    line INTEGER CHECK (line >= 1),
    author_id TEXT NOT NULL,
    text TEXT NOT NULL,
    written_at TEXT NOT NULL
) ${strict};
CREATE INDEX comments_by_submission ON comments (submission_id, written_at);
