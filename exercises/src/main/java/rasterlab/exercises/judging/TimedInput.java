package rasterlab.exercises.judging;

import rasterlab.engine.range.Bounds;

/**
 * An input to time a method on.
 *
 * @param part number of the part of the exercise's data that drew it, from 0
 */
public record TimedInput<I>(I input, int part) {
    public TimedInput {
        Bounds.requireAtLeast("part", part, 0);
    }
}
