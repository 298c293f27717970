-- The steps of hints that students were shown, when, and what each costs in what they hand in from then on. What a
-- submission is charged is fixed when it is received: neither a later hint nor another price changes it.

CREATE TABLE hints (
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    step INTEGER NOT NULL CHECK (step >= 1),
    cost INTEGER NOT NULL CHECK (cost >= 0),
    taken_at TEXT NOT NULL,
    PRIMARY KEY (student_id, exercise, step)
) STRICT;
CREATE INDEX hints_by_time ON hints (taken_at);

ALTER TABLE submissions ADD COLUMN hint_cost INTEGER NOT NULL DEFAULT 0 CHECK (hint_cost >= 0);
