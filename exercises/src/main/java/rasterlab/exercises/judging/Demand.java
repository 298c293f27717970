package rasterlab.exercises.judging;

import rasterlab.exercises.Exercise.ExerciseTolerance;

/**
 * The demand of a case on an answer.
 *
 * @param mayRefuse whether an IllegalArgumentException is as good as the right answer
 * @param cut whether only the beginning of the answer is looked at; the method is stopped there
 * @param items the most items of the right answer that are looked at
 */
public record Demand(ExerciseTolerance tolerance, boolean mayRefuse, boolean cut, int items) {}
