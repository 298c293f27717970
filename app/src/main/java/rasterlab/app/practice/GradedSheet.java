package rasterlab.app.practice;

import java.util.function.Consumer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.predicting.HandedAnswers;

/**
 * A sheet that is answered here to be handed in.
 *
 * @param begun the answers that it has already
 * @param keep takes the whole sheet after each answer
 * @param handIn takes the whole sheet, to have it judged
 * @param back shows the exercise, from which the sheet came
 */
public record GradedSheet(
        Exercise exercise,
        HandedAnswers begun,
        Consumer<String> keep,
        Consumer<String> handIn,
        Runnable back) {}
