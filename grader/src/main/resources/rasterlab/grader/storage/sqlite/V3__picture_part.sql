-- Which pixels a case's pictures show, as JSON; null in results of before.

ALTER TABLE case_results ADD COLUMN picture_part TEXT;
