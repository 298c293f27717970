-- A case's pictures as a list: of what kind each is, and a text for people who do not see it, as data beside its
-- English. Before, there were three pictures of pixels and one text, the rows of their difference: from these come the
-- rows of what was expected and of what was drawn, below the line on the part where there is one.

CREATE TABLE case_pictures (
    submission_id TEXT NOT NULL,
    revision TEXT NOT NULL,
    case_position INTEGER NOT NULL,
    position INTEGER NOT NULL,
    kind TEXT NOT NULL,
    png BLOB NOT NULL,
    text TEXT NOT NULL,
    text_data TEXT NOT NULL,
    part TEXT,
    PRIMARY KEY (submission_id, revision, case_position, position),
    UNIQUE (submission_id, revision, case_position, kind),
    FOREIGN KEY (submission_id, revision, case_position) REFERENCES case_results (submission_id, revision, position)
) STRICT;

WITH drawn AS (
    SELECT *, CASE WHEN picture_text LIKE 'columns %' THEN instr(picture_text, char(10)) ELSE 0 END AS head
    FROM case_results
    WHERE picture_text IS NOT NULL
), cut AS (
    SELECT *, substr(picture_text, 1, head) AS part_line, substr(picture_text, head + 1) AS marks
    FROM drawn
), pictures AS (
    SELECT *, 0 AS place, 'expected' AS kind, expected_png AS png,
        part_line || replace(replace(marks, '-', '#'), '+', '.') AS text
    FROM cut
    UNION ALL
    SELECT *, 1, 'actual', actual_png, part_line || replace(replace(marks, '+', '#'), '-', '.')
    FROM cut
    UNION ALL
    SELECT *, 2, 'difference', difference_png, picture_text
    FROM cut
)
INSERT INTO case_pictures (submission_id, revision, case_position, position, kind, png, text, text_data, part)
SELECT submission_id, revision, position, place, kind, png, text, json_array(json_array('rows', text)), picture_part
FROM pictures
WHERE png IS NOT NULL;

ALTER TABLE case_results DROP COLUMN expected_png;
ALTER TABLE case_results DROP COLUMN actual_png;
ALTER TABLE case_results DROP COLUMN difference_png;
ALTER TABLE case_results DROP COLUMN picture_text;
ALTER TABLE case_results DROP COLUMN picture_part;
