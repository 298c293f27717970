-- What a message says as data beside its English text, so that a page can say it in its reader's language.

ALTER TABLE case_results ADD COLUMN message_data TEXT NOT NULL DEFAULT '';
ALTER TABLE diagnostics ADD COLUMN message_data TEXT NOT NULL DEFAULT '';
