-- How much one student of a course may hand in, where its instructor asks for less than the server allows; null for what
-- the server allows.
CREATE TABLE course_limits (
    course_id TEXT PRIMARY KEY REFERENCES courses (id),
    per_minute INTEGER CHECK (per_minute >= 1),
    waiting INTEGER CHECK (waiting >= 1)
) ${strict};
