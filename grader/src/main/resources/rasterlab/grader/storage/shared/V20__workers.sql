-- Processes that grade, each under a name of its own, and when each was last seen. One that is draining ends what it grades
-- and takes nothing more. The text of its isolation is for a server of a version that lacks the words of its data.
CREATE TABLE workers (
    name TEXT PRIMARY KEY,
    host TEXT NOT NULL,
    serves INTEGER NOT NULL CHECK (serves IN (0, 1)),
    isolation TEXT NOT NULL,
    isolation_data TEXT NOT NULL,
    slots INTEGER NOT NULL CHECK (slots >= 1),
    is_draining INTEGER NOT NULL CHECK (is_draining IN (0, 1)),
    started_at TEXT NOT NULL,
    seen_at TEXT NOT NULL
) ${strict};
