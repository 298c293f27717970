-- The exercises that an instructor chose for a course; where there are none, the course has all that the server has.
CREATE TABLE chosen_exercises (
    course_id TEXT NOT NULL REFERENCES courses (id),
    exercise TEXT NOT NULL,
    PRIMARY KEY (course_id, exercise)
) ${strict};
