-- When somebody of the staff was here last, and since when a token lets nobody in; what was done before stays under its name.
ALTER TABLE instructors ADD COLUMN last_used_at TEXT;
ALTER TABLE instructors ADD COLUMN revoked_at TEXT;
ALTER TABLE students ADD COLUMN revoked_at TEXT;

-- Some changes belong to no course, such as those of the staff.
CREATE TABLE changes (
    id TEXT PRIMARY KEY,
    noted_at TEXT NOT NULL,
    account_id TEXT NOT NULL,
    course_id TEXT REFERENCES courses (id),
    action TEXT NOT NULL,
    subject TEXT NOT NULL,
    detail TEXT NOT NULL
) ${strict};
INSERT INTO changes (id, noted_at, account_id, course_id, action, subject, detail)
SELECT id, noted_at, account_id, course_id, action, subject, detail FROM audit;
DROP TABLE audit;
ALTER TABLE changes RENAME TO audit;
CREATE INDEX audit_by_time ON audit (noted_at, id);
