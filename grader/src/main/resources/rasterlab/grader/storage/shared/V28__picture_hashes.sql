-- The hash of a picture as it is in English, by which answers are told apart without reading it; null where it was kept
-- before there were hashes.
ALTER TABLE case_pictures ADD COLUMN png_hash TEXT;
