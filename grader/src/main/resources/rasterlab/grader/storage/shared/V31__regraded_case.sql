-- The only case whose result a regrade replaces, and whether that earns stability; null where it replaces whole results.
ALTER TABLE regrades ADD COLUMN case_name TEXT;
ALTER TABLE regrades ADD COLUMN earns_stability INTEGER CHECK (earns_stability IN (0, 1));
