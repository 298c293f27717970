-- A speed that a busy machine did not let be measured is measured again when nothing else is to do: how often yet,
-- and not before when. And in which band of speed each source was, which it keeps unless it has clearly left it.

ALTER TABLE submissions ADD COLUMN speeds_left INTEGER NOT NULL DEFAULT 0;
ALTER TABLE submissions ADD COLUMN speed_due TEXT;
CREATE INDEX submissions_by_speed ON submissions (speeds_left) WHERE speeds_left > 0;

CREATE TABLE speed_bands (
    source_key TEXT PRIMARY KEY,
    band INTEGER NOT NULL
) STRICT;
