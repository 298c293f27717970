package rasterlab.exercises;

import rasterlab.exercises.Exercise.StatedLimits;

/** Exercises that state other limits than their own. */
public final class Capped {
    private Capped() {}

    public static Exercise with(Exercise one, StatedLimits caps) {
        return new Exercise(
                one.id(),
                one.topic(),
                one.contract(),
                one.title(),
                one.statement(),
                one.pictures(),
                one.starter(),
                one.revision(),
                one.tolerance(),
                one.points(),
                caps,
                one.timed(),
                one.groups(),
                one.cases(),
                one.breaking(),
                one.predicting(),
                one.evidence(),
                one.minutes(),
                one.hints());
    }
}
