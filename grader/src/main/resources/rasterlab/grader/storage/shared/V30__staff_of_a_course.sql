-- The only course that somebody of the staff teaches; null for all of the server.
ALTER TABLE instructors ADD COLUMN course_id TEXT REFERENCES courses (id);
