package rasterlab.app.spline;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.spline.function.SplineProblem;
import rasterlab.engine.spline.function.SplineValues;
import rasterlab.engine.study.Topic;

/**
 * The results of both methods for one choice.
 *
 * @param other by the second method, if one is compared
 */
public record FunctionDrawings(
        FunctionChoice choice, FunctionDrawing drawing, Optional<FunctionDrawing> other) {
    static FunctionDrawings of(
            Topic<SplineFunction, SplineProblem, SplineValues> topic,
            FunctionChoice choice,
            BooleanSupplier cancelled) {
        FunctionDrawing drawing = FunctionDrawing.of(topic, choice.method(), choice);
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer choice was made");
        Optional<FunctionDrawing> other =
                Optional.of(choice.comparison())
                        .filter(name -> !name.isEmpty())
                        .map(name -> FunctionDrawing.of(topic, name, choice));
        return new FunctionDrawings(choice, drawing, other);
    }
}
