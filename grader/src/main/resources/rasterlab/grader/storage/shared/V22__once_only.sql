-- What is kept a while for a browser that went elsewhere to sign in, and is given out once to whoever has the key, of which
-- this is the hash.
CREATE TABLE once_only (
    key_hash TEXT PRIMARY KEY,
    kind TEXT NOT NULL,
    value TEXT NOT NULL,
    expires_at TEXT NOT NULL
) ${strict};
CREATE INDEX once_only_by_time ON once_only (kind, expires_at);
