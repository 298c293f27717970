-- A student's point on the topic's chart of speed and accuracy, and the topic's methods beside it, as they were measured
-- in one run. Without a time of the reference there are no figures. Without an error, it has no end: items are missing,
-- extra, or there is no answer.

ALTER TABLE results ADD COLUMN reference_nanos REAL CHECK (reference_nanos > 0);
ALTER TABLE results ADD COLUMN error REAL CHECK (error >= 0);

CREATE TABLE speed_methods (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    position INTEGER NOT NULL,
    method TEXT NOT NULL,
    ratio REAL NOT NULL CHECK (ratio > 0),
    error REAL CHECK (error >= 0),
    PRIMARY KEY (submission_id, revision, position),
    FOREIGN KEY (submission_id, revision) REFERENCES results (submission_id, revision)
) STRICT;
