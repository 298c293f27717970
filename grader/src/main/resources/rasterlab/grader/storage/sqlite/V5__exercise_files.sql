-- What each exercise was read from when something may have been handed in for it, so that this can be graded
-- against it, and its result be shown with its words, when the exercise has changed or gone.

CREATE TABLE exercise_files (
    exercise TEXT NOT NULL,
    revision TEXT NOT NULL,
    name TEXT NOT NULL,
    content BLOB NOT NULL,
    PRIMARY KEY (exercise, revision, name)
) STRICT;
