package rasterlab.engine.signmap;

import rasterlab.engine.predicate.Spacing;

/** One way to compute a sign, with the numbers that it computes with. */
record SignForm(String name, Spacing spacing, Sign sign) {}
