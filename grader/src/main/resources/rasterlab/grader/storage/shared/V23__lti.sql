-- Places of learning platforms in which this server is registered.
CREATE TABLE lti_platforms (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    issuer TEXT NOT NULL,
    client_id TEXT NOT NULL,
    deployment TEXT NOT NULL,
    login_url TEXT NOT NULL,
    token_url TEXT NOT NULL,
    keys_url TEXT NOT NULL,
    makes_staff INTEGER NOT NULL CHECK (makes_staff IN (0, 1)),
    added_at TEXT NOT NULL,
    UNIQUE (issuer, client_id, deployment)
) ${strict};

-- Which course here a platform's course is.
CREATE TABLE lti_contexts (
    platform_id TEXT NOT NULL REFERENCES lti_platforms (id),
    context TEXT NOT NULL,
    title TEXT NOT NULL,
    course_id TEXT NOT NULL REFERENCES courses (id),
    bound_at TEXT NOT NULL,
    PRIMARY KEY (platform_id, context)
) ${strict};
CREATE INDEX lti_contexts_by_course ON lti_contexts (course_id);

-- Who a platform's person is in a course here, and who of the staff.
CREATE TABLE lti_students (
    platform_id TEXT NOT NULL REFERENCES lti_platforms (id),
    subject TEXT NOT NULL,
    course_id TEXT NOT NULL REFERENCES courses (id),
    student_id TEXT NOT NULL REFERENCES students (id),
    PRIMARY KEY (platform_id, subject, course_id)
) ${strict};
CREATE INDEX lti_students_by_student ON lti_students (student_id);

CREATE TABLE lti_staff (
    platform_id TEXT NOT NULL REFERENCES lti_platforms (id),
    subject TEXT NOT NULL,
    account_id TEXT NOT NULL REFERENCES instructors (id),
    PRIMARY KEY (platform_id, subject)
) ${strict};

-- A platform's link to an exercise, and where its scores go: to a line item, which may still have to be made among the line items.
CREATE TABLE lti_links (
    id TEXT PRIMARY KEY,
    platform_id TEXT NOT NULL REFERENCES lti_platforms (id),
    context TEXT NOT NULL,
    link TEXT NOT NULL,
    exercise TEXT NOT NULL,
    line_item TEXT,
    line_items TEXT,
    UNIQUE (platform_id, context, link)
) ${strict};

-- The points of a student as they are to stand at a link, null for none, and what was sent last. What is due is sent until
-- the platform has taken it; whoever sends has the lease. A change has a version of its own.
CREATE TABLE lti_scores (
    link_id TEXT NOT NULL REFERENCES lti_links (id),
    student_id TEXT NOT NULL REFERENCES students (id),
    exercise TEXT NOT NULL,
    points INTEGER,
    points_of INTEGER NOT NULL,
    version INTEGER NOT NULL,
    changed_at TEXT NOT NULL,
    due_at TEXT,
    tries INTEGER NOT NULL DEFAULT 0,
    fault TEXT,
    lease TEXT,
    lease_until TEXT,
    sent_points INTEGER,
    sent_at TEXT,
    PRIMARY KEY (link_id, student_id)
) ${strict};
CREATE INDEX lti_scores_by_student ON lti_scores (student_id);
CREATE INDEX lti_scores_due ON lti_scores (due_at);
