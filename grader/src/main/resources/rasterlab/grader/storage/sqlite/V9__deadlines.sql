CREATE TABLE deadlines (
    course_id TEXT NOT NULL REFERENCES courses (id),
    exercise TEXT NOT NULL,
    due_at TEXT NOT NULL,
    PRIMARY KEY (course_id, exercise)
) STRICT;
