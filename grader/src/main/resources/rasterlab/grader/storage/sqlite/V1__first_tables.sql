-- Times are UTC, ISO-8601 with milliseconds, so that text order is time order.
-- Ids are 128 random bits and tokens are SHA-256 hashes, both base64url.

CREATE TABLE instructors (
    id TEXT PRIMARY KEY,
    token_hash TEXT NOT NULL UNIQUE,
    created_at TEXT NOT NULL,
    announced_at TEXT
) STRICT;

CREATE TABLE courses (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    code TEXT NOT NULL UNIQUE,
    created_at TEXT NOT NULL
) STRICT;

CREATE TABLE students (
    id TEXT PRIMARY KEY,
    course_id TEXT NOT NULL REFERENCES courses (id),
    name TEXT NOT NULL,
    token_hash TEXT NOT NULL UNIQUE,
    joined_at TEXT NOT NULL
) STRICT;

CREATE TABLE sessions (
    token_hash TEXT PRIMARY KEY,
    account_id TEXT NOT NULL,
    expires_at TEXT NOT NULL
) STRICT;

CREATE TABLE submissions (
    sequence INTEGER PRIMARY KEY AUTOINCREMENT,
    id TEXT NOT NULL UNIQUE,
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    revision TEXT NOT NULL,
    attempt INTEGER NOT NULL CHECK (attempt >= 1),
    source TEXT NOT NULL,
    seed INTEGER NOT NULL,
    received_at TEXT NOT NULL,
    state TEXT NOT NULL CHECK (state IN ('queued', 'running', 'done')),
    tries INTEGER NOT NULL DEFAULT 0,
    lease TEXT,
    lease_until TEXT,
    UNIQUE (student_id, exercise, attempt)
) STRICT;
CREATE INDEX submissions_by_state ON submissions (state, sequence);
CREATE INDEX submissions_by_student ON submissions (student_id, received_at);

CREATE TABLE results (
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    revision TEXT NOT NULL,
    verdict TEXT NOT NULL,
    accuracy INTEGER NOT NULL,
    stability INTEGER NOT NULL,
    speed INTEGER NOT NULL,
    points_of INTEGER NOT NULL,
    isolation TEXT NOT NULL,
    nanos_per_item REAL NOT NULL,
    graded_at TEXT NOT NULL,
    PRIMARY KEY (submission_id, revision)
) STRICT;

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
    picture_text TEXT,
    expected_png BLOB,
    actual_png BLOB,
    difference_png BLOB,
    PRIMARY KEY (submission_id, revision, position),
    FOREIGN KEY (submission_id, revision) REFERENCES results (submission_id, revision)
) STRICT;

CREATE TABLE diagnostics (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    position INTEGER NOT NULL,
    line INTEGER NOT NULL,
    column_number INTEGER NOT NULL,
    message TEXT NOT NULL,
    PRIMARY KEY (submission_id, revision, position),
    FOREIGN KEY (submission_id, revision) REFERENCES results (submission_id, revision)
) STRICT;

-- What a repeated POST gets again; the key itself is a secret of the client, so only its hash is kept.
CREATE TABLE idempotency_keys (
    owner TEXT NOT NULL,
    key_hash TEXT NOT NULL,
    request_hash TEXT NOT NULL,
    made TEXT NOT NULL,
    created_at TEXT NOT NULL,
    PRIMARY KEY (owner, key_hash)
) STRICT;

-- Random bytes that only this server knows.
CREATE TABLE secrets (
    name TEXT PRIMARY KEY,
    value BLOB NOT NULL
) STRICT;

-- db-scheduler's own table, laid out as that library documents it.
CREATE TABLE scheduled_tasks (
    task_name TEXT NOT NULL,
    task_instance TEXT NOT NULL,
    task_data BLOB,
    execution_time TIMESTAMP NOT NULL,
    picked BOOLEAN NOT NULL,
    picked_by TEXT,
    last_success TIMESTAMP,
    last_failure TIMESTAMP,
    consecutive_failures INT,
    last_heartbeat TIMESTAMP,
    version BIGINT NOT NULL,
    priority SMALLINT,
    PRIMARY KEY (task_name, task_instance)
);
CREATE INDEX scheduled_tasks_by_time ON scheduled_tasks (execution_time);
