-- The intervals in which the ratios of times lie, the student's and those of the topic's methods; what was measured before
-- has none.
ALTER TABLE results ADD COLUMN ratio_low ${real} CHECK (ratio_low > 0);
ALTER TABLE results ADD COLUMN ratio_high ${real} CHECK (ratio_high >= ratio_low);
ALTER TABLE speed_methods ADD COLUMN ratio_low ${real} CHECK (ratio_low > 0);
ALTER TABLE speed_methods ADD COLUMN ratio_high ${real} CHECK (ratio_high >= ratio_low);
