-- What a student says against the result for one case, and what staff answered. One result is complained of once for each
-- case; a later result of the submission can be complained of anew.
CREATE TABLE complaints (
    id TEXT PRIMARY KEY,
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    result_id TEXT NOT NULL REFERENCES results (id),
    case_name TEXT NOT NULL,
    text TEXT NOT NULL,
    opened_at TEXT NOT NULL,
    state TEXT NOT NULL DEFAULT 'open' CHECK (state IN ('open', 'accepted', 'declined')),
    answer TEXT,
    account_id TEXT,
    answered_at TEXT,
    regrade_id TEXT REFERENCES regrades (id),
    UNIQUE (result_id, case_name)
) ${strict};
CREATE INDEX complaints_by_submission ON complaints (submission_id, opened_at);
CREATE INDEX complaints_that_are_open ON complaints (opened_at, id) WHERE state = 'open';

-- Whether the class reads the student's name on its chart of speed and accuracy, which nobody has to want.
ALTER TABLE students ADD COLUMN named_on_front INTEGER NOT NULL DEFAULT 0 CHECK (named_on_front IN (0, 1));
