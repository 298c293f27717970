-- A picture in Russian, with a decimal comma, where it is another one than in English.

ALTER TABLE case_pictures ADD COLUMN png_ru BLOB;
