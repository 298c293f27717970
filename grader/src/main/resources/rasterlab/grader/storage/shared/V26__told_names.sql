-- What a platform called a student last, so that a change of it is seen; null where it was not noted yet.
ALTER TABLE lti_students ADD COLUMN told_name TEXT;
