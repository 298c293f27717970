-- The tables that SQLite has after its eleventh script, in PostgreSQL's types; from the twelfth on, both take the same ones.
-- Times are UTC, ISO-8601 with milliseconds, so that text order is time order.
-- Ids are 128 random bits and tokens are SHA-256 hashes, both base64url.

CREATE TABLE instructors (
    id TEXT PRIMARY KEY,
    token_hash TEXT NOT NULL UNIQUE,
    created_at TEXT NOT NULL,
    announced_at TEXT
);

CREATE TABLE courses (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    code TEXT NOT NULL UNIQUE,
    created_at TEXT NOT NULL
);

CREATE TABLE students (
    id TEXT PRIMARY KEY,
    course_id TEXT NOT NULL REFERENCES courses (id),
    name TEXT NOT NULL,
    token_hash TEXT NOT NULL UNIQUE,
    joined_at TEXT NOT NULL
);

CREATE TABLE sessions (
    token_hash TEXT PRIMARY KEY,
    account_id TEXT NOT NULL,
    expires_at TEXT NOT NULL
);

CREATE TABLE submissions (
    sequence BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
    id TEXT NOT NULL UNIQUE,
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    revision TEXT NOT NULL,
    attempt INTEGER NOT NULL CHECK (attempt >= 1),
    source TEXT NOT NULL,
    seed BIGINT NOT NULL,
    received_at TEXT NOT NULL,
    state TEXT NOT NULL CHECK (state IN ('queued', 'running', 'done')),
    tries INTEGER NOT NULL DEFAULT 0,
    lease TEXT,
    lease_until TEXT,
    round INTEGER NOT NULL DEFAULT 0,
    speeds_left INTEGER NOT NULL DEFAULT 0,
    speed_due TEXT,
    hint_cost INTEGER NOT NULL DEFAULT 0 CHECK (hint_cost >= 0),
    UNIQUE (student_id, exercise, attempt)
);
CREATE INDEX submissions_by_turn ON submissions (state, round, sequence);
CREATE INDEX submissions_by_student ON submissions (student_id, received_at);
CREATE INDEX submissions_by_speed ON submissions (speeds_left) WHERE speeds_left > 0;

CREATE TABLE results (
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    revision TEXT NOT NULL,
    verdict TEXT NOT NULL,
    accuracy INTEGER NOT NULL,
    stability INTEGER NOT NULL,
    speed INTEGER NOT NULL,
    points_of INTEGER NOT NULL,
    isolation TEXT NOT NULL,
    nanos_per_item DOUBLE PRECISION NOT NULL,
    graded_at TEXT NOT NULL,
    reference_nanos DOUBLE PRECISION CHECK (reference_nanos > 0),
    error DOUBLE PRECISION CHECK (error >= 0),
    PRIMARY KEY (submission_id, revision)
);

CREATE TABLE case_results (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    position INTEGER NOT NULL,
    name TEXT NOT NULL,
    visibility TEXT NOT NULL,
    verdict TEXT NOT NULL,
    points INTEGER NOT NULL,
    points_of INTEGER NOT NULL,
    message TEXT NOT NULL,
    scene TEXT NOT NULL,
    message_data TEXT NOT NULL DEFAULT '',
    PRIMARY KEY (submission_id, revision, position),
    FOREIGN KEY (submission_id, revision) REFERENCES results (submission_id, revision)
);

CREATE TABLE case_pictures (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    case_position INTEGER NOT NULL,
    position INTEGER NOT NULL,
    kind TEXT NOT NULL,
    png BYTEA NOT NULL,
    png_ru BYTEA,
    text TEXT NOT NULL,
    text_data TEXT NOT NULL,
    part TEXT,
    PRIMARY KEY (submission_id, revision, case_position, position),
    UNIQUE (submission_id, revision, case_position, kind),
    FOREIGN KEY (submission_id, revision, case_position) REFERENCES case_results (submission_id, revision, position)
);

CREATE TABLE diagnostics (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    position INTEGER NOT NULL,
    line INTEGER NOT NULL,
    column_number INTEGER NOT NULL,
    message TEXT NOT NULL,
    message_data TEXT NOT NULL DEFAULT '',
    PRIMARY KEY (submission_id, revision, position),
    FOREIGN KEY (submission_id, revision) REFERENCES results (submission_id, revision)
);

CREATE TABLE speed_methods (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    position INTEGER NOT NULL,
    method TEXT NOT NULL,
    ratio DOUBLE PRECISION NOT NULL CHECK (ratio > 0),
    error DOUBLE PRECISION CHECK (error >= 0),
    PRIMARY KEY (submission_id, revision, position),
    FOREIGN KEY (submission_id, revision) REFERENCES results (submission_id, revision)
);

CREATE TABLE speed_bands (
    source_key TEXT PRIMARY KEY,
    band INTEGER NOT NULL
);

CREATE TABLE idempotency_keys (
    owner TEXT NOT NULL,
    key_hash TEXT NOT NULL,
    request_hash TEXT NOT NULL,
    made TEXT NOT NULL,
    created_at TEXT NOT NULL,
    PRIMARY KEY (owner, key_hash)
);

CREATE TABLE secrets (
    name TEXT PRIMARY KEY,
    value BYTEA NOT NULL
);

CREATE TABLE exercise_files (
    exercise TEXT NOT NULL,
    revision TEXT NOT NULL,
    name TEXT NOT NULL,
    content BYTEA NOT NULL,
    PRIMARY KEY (exercise, revision, name)
);

CREATE TABLE hints (
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    step INTEGER NOT NULL CHECK (step >= 1),
    cost INTEGER NOT NULL CHECK (cost >= 0),
    taken_at TEXT NOT NULL,
    PRIMARY KEY (student_id, exercise, step)
);
CREATE INDEX hints_by_time ON hints (taken_at);

CREATE TABLE deadlines (
    course_id TEXT NOT NULL REFERENCES courses (id),
    exercise TEXT NOT NULL,
    due_at TEXT NOT NULL,
    PRIMARY KEY (course_id, exercise)
);

-- db-scheduler's own table, laid out as that library documents it.
CREATE TABLE scheduled_tasks (
    task_name TEXT NOT NULL,
    task_instance TEXT NOT NULL,
    task_data BYTEA,
    execution_time TIMESTAMP WITH TIME ZONE NOT NULL,
    picked BOOLEAN NOT NULL,
    picked_by TEXT,
    last_success TIMESTAMP WITH TIME ZONE,
    last_failure TIMESTAMP WITH TIME ZONE,
    consecutive_failures INT,
    last_heartbeat TIMESTAMP WITH TIME ZONE,
    version BIGINT NOT NULL,
    priority SMALLINT,
    PRIMARY KEY (task_name, task_instance)
);
CREATE INDEX scheduled_tasks_by_time ON scheduled_tasks (execution_time);
