-- Points that staff give or take beside those of grading, with a reason that the student reads. None is ever overwritten:
-- a later one is added to those before, and one that is taken back stays here as what it was.
CREATE TABLE adjustments (
    id TEXT PRIMARY KEY,
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    points INTEGER NOT NULL CHECK (points <> 0),
    reason TEXT NOT NULL,
    total_before INTEGER NOT NULL CHECK (total_before >= 0),
    account_id TEXT NOT NULL,
    given_at TEXT NOT NULL,
    revoked_by TEXT,
    revoked_at TEXT
) ${strict};
CREATE INDEX adjustments_by_submission ON adjustments (submission_id, given_at);
