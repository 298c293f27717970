-- What late work costs: percent of its points for each late day begun that is not covered; 0 for nothing. Of a submission, what
-- its student agreed to when it came, and what it costs by the rules and the deadline of now, which is never more.
ALTER TABLE course_exercises ADD COLUMN late_penalty INTEGER NOT NULL DEFAULT 0 CHECK (late_penalty BETWEEN 0 AND 100);
ALTER TABLE submissions ADD COLUMN penalty_agreed INTEGER NOT NULL DEFAULT 0 CHECK (penalty_agreed BETWEEN 0 AND 100);
ALTER TABLE submissions ADD COLUMN penalty INTEGER NOT NULL DEFAULT 0 CHECK (penalty BETWEEN 0 AND 100);
