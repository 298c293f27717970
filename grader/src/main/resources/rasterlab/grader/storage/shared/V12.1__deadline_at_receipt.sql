-- The deadline that held for a student when a submission was received, null where there was none: one that is set into
-- the past, or moved ahead, later makes nothing late that came in time. Of what came before, today's is the best known.
ALTER TABLE submissions ADD COLUMN due_at TEXT;
UPDATE submissions SET due_at =
    (SELECT coalesce(extensions.due_at, rules.due_at)
     FROM students
     JOIN course_exercises AS rules ON rules.course_id = students.course_id AND rules.exercise = submissions.exercise
     LEFT JOIN extensions ON extensions.student_id = students.id AND extensions.exercise = rules.exercise
     WHERE students.id = submissions.student_id);
