-- What staff say to all who gave the same wrong answers to an exercise, now or later.
CREATE TABLE group_comments (
    course_id TEXT NOT NULL REFERENCES courses (id),
    exercise TEXT NOT NULL,
    wrong_group TEXT NOT NULL,
    text TEXT NOT NULL,
    account_id TEXT NOT NULL,
    written_at TEXT NOT NULL,
    PRIMARY KEY (course_id, exercise, wrong_group)
) ${strict};
