-- The number of a course's last student, kept when that student is deleted, so that no number is given twice.
ALTER TABLE courses ADD COLUMN last_number INTEGER NOT NULL DEFAULT 0;
UPDATE courses SET last_number = (SELECT coalesce(max(number), 0) FROM students WHERE course_id = courses.id);
