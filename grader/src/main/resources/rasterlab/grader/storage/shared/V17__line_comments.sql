-- What is said about lines of a submission is a thread: a comment of staff or a question of its student, and the answers to it.
-- A thread is open as long as the student's last words in it wait for an answer.
ALTER TABLE comments ADD COLUMN last_line INTEGER CHECK (last_line >= 1);
ALTER TABLE comments ADD COLUMN thread_id TEXT REFERENCES comments (id);
ALTER TABLE comments ADD COLUMN is_open INTEGER NOT NULL DEFAULT 0 CHECK (is_open IN (0, 1));
ALTER TABLE comments ADD COLUMN edited_at TEXT;
UPDATE comments SET last_line = line;
CREATE INDEX comments_by_thread ON comments (thread_id);
CREATE INDEX comments_that_are_open ON comments (written_at, id) WHERE is_open = 1;

-- Comments that staff of a course write again and again, by a short name.
CREATE TABLE kept_comments (
    id TEXT PRIMARY KEY,
    course_id TEXT NOT NULL REFERENCES courses (id),
    name TEXT NOT NULL,
    text TEXT NOT NULL,
    account_id TEXT NOT NULL,
    kept_at TEXT NOT NULL,
    UNIQUE (course_id, name)
) ${strict};
