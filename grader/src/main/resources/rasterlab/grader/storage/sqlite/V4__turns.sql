-- Turns go round by student: a submission's round is one later than its student's round before, so that
-- whoever hands in five has one of them graded before the others have theirs, and not five.

ALTER TABLE submissions ADD COLUMN round INTEGER NOT NULL DEFAULT 0;
UPDATE submissions SET round =
    (SELECT count(*) FROM submissions earlier
     WHERE earlier.student_id = submissions.student_id AND earlier.state <> 'done'
       AND earlier.sequence < submissions.sequence)
WHERE state <> 'done';
DROP INDEX submissions_by_state;
CREATE INDEX submissions_by_turn ON submissions (state, round, sequence);
