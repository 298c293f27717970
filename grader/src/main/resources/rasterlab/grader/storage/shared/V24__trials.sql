-- A copy of a submission that staff changed and ran. What comes of it is kept among the results of the submission, where it
-- never counts; the submission itself stays as it is.
CREATE TABLE trials (
    id TEXT PRIMARY KEY,
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    account_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    source TEXT NOT NULL,
    begun_at TEXT NOT NULL,
    state TEXT NOT NULL DEFAULT 'queued' CHECK (state IN ('queued', 'running', 'done')),
    tries INTEGER NOT NULL DEFAULT 0,
    lease TEXT,
    lease_until TEXT,
    result_id TEXT REFERENCES results (id)
) ${strict};
CREATE INDEX trials_by_submission ON trials (submission_id, begun_at);
CREATE INDEX trials_not_done ON trials (state) WHERE state <> 'done';
CREATE INDEX trials_by_result ON trials (result_id);
