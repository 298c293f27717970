-- An exam of a course: some of its exercises, in a window of time. Addresses stand as networks with spaces between them, none
-- for any; a second session takes over where takes_over is 1, and is refused else.
CREATE TABLE exams (
    id TEXT PRIMARY KEY,
    course_id TEXT NOT NULL REFERENCES courses (id),
    name TEXT NOT NULL,
    opens_at TEXT NOT NULL,
    closes_at TEXT NOT NULL,
    zone TEXT NOT NULL,
    minutes INTEGER NOT NULL CHECK (minutes BETWEEN 1 AND 1440),
    is_fixed INTEGER NOT NULL CHECK (is_fixed IN (0, 1)),
    grace INTEGER NOT NULL CHECK (grace BETWEEN 0 AND 600),
    addresses TEXT NOT NULL,
    takes_over INTEGER NOT NULL CHECK (takes_over IN (0, 1))
) ${strict};
CREATE INDEX exams_by_course ON exams (course_id);

CREATE TABLE exam_exercises (
    exam_id TEXT NOT NULL REFERENCES exams (id),
    exercise TEXT NOT NULL,
    position INTEGER NOT NULL,
    PRIMARY KEY (exam_id, exercise)
) ${strict};

-- A student at an exam: more minutes, when it was begun and ended, and from where; the session is a hash.
CREATE TABLE exam_sittings (
    exam_id TEXT NOT NULL REFERENCES exams (id),
    student_id TEXT NOT NULL REFERENCES students (id),
    extra INTEGER NOT NULL DEFAULT 0 CHECK (extra BETWEEN 0 AND 1440),
    started_at TEXT,
    ended_at TEXT,
    session_hash TEXT,
    address TEXT,
    PRIMARY KEY (exam_id, student_id)
) ${strict};

-- The text that a student wrote last, and whether just that is handed in.
CREATE TABLE exam_drafts (
    exam_id TEXT NOT NULL REFERENCES exams (id),
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    source TEXT NOT NULL,
    saved_at TEXT NOT NULL,
    is_handed INTEGER NOT NULL CHECK (is_handed IN (0, 1)),
    PRIMARY KEY (exam_id, student_id, exercise)
) ${strict};

-- What happened at an exam; rows are only ever added.
CREATE TABLE exam_events (
    id TEXT PRIMARY KEY,
    exam_id TEXT NOT NULL REFERENCES exams (id),
    student_id TEXT NOT NULL REFERENCES students (id),
    number INTEGER NOT NULL,
    noted_at TEXT NOT NULL,
    kind TEXT NOT NULL,
    address TEXT NOT NULL,
    detail TEXT NOT NULL,
    UNIQUE (exam_id, number)
) ${strict};
