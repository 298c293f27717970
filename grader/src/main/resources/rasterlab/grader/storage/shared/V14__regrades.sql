-- Submissions that are graded again. What comes of it is kept as further results, and all of them count together when the
-- regrade is accepted; one that is not dry is accepted as its last submission is graded.
CREATE TABLE regrades (
    id TEXT PRIMARY KEY,
    course_id TEXT NOT NULL REFERENCES courses (id),
    exercise TEXT NOT NULL,
    revision TEXT NOT NULL,
    choice TEXT NOT NULL CHECK (choice IN ('all', 'latest', 'best', 'some')),
    is_dry INTEGER NOT NULL CHECK (is_dry IN (0, 1)),
    state TEXT NOT NULL CHECK (state IN ('grading', 'graded', 'accepted', 'discarded', 'undone')),
    account_id TEXT NOT NULL,
    begun_at TEXT NOT NULL,
    settled_at TEXT
) ${strict};
CREATE INDEX regrades_by_course ON regrades (course_id, begun_at);
CREATE INDEX regrades_by_state ON regrades (state);

-- One submission of a regrade, with a lease of its own: the submission stays done meanwhile. The former result is the one
-- that counted when the regrade was accepted, which undoing it brings back.
CREATE TABLE regrade_items (
    regrade_id TEXT NOT NULL REFERENCES regrades (id),
    submission_id TEXT NOT NULL REFERENCES submissions (id),
    position INTEGER NOT NULL CHECK (position >= 1),
    state TEXT NOT NULL CHECK (state IN ('queued', 'running', 'done')),
    tries INTEGER NOT NULL DEFAULT 0,
    lease TEXT,
    lease_until TEXT,
    result_id TEXT REFERENCES results (id),
    former_id TEXT REFERENCES results (id),
    PRIMARY KEY (regrade_id, submission_id)
) ${strict};
CREATE INDEX regrade_items_by_submission ON regrade_items (submission_id);
CREATE INDEX regrade_items_not_done ON regrade_items (state) WHERE state <> 'done';
