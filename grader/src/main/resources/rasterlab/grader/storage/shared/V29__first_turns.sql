-- Whether its student has nothing in the round before, or nothing waited when it came: there a row of the student's turns begins.
-- What comes next takes a place after the latest of those that wait, which is asked at each submission.
ALTER TABLE submissions ADD COLUMN begins_turns INTEGER NOT NULL DEFAULT 0 CHECK (begins_turns IN (0, 1));
CREATE INDEX submissions_by_round ON submissions (student_id, round);
UPDATE submissions SET begins_turns = 1
WHERE NOT EXISTS (SELECT 1 FROM submissions AS before
                  WHERE before.student_id = submissions.student_id AND before.round = submissions.round - 1);
CREATE INDEX submissions_by_first_turn ON submissions (state, round) WHERE begins_turns = 1;

-- The latest results tell how long the queue takes.
CREATE INDEX results_by_time ON results (graded_at);
