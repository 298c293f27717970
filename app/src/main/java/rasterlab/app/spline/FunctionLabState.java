package rasterlab.app.spline;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.range.Bounds;

/**
 * The state that the lab shows at one moment.
 *
 * @param choice the newest one
 * @param drawings the newest finished ones, maybe of an earlier choice
 * @param step steps of the method taken so far, from 0
 * @param share where the function is read, as a share of the way between the end knots
 * @param arrangement changes when the stage should show everything again
 */
public record FunctionLabState(
        FunctionChoice choice, FunctionDrawings drawings, int step, double share, int arrangement) {
    public FunctionLabState {
        Bounds.requireAtLeast("step", step, 0);
    }

    /** The result of the chosen method. */
    public FunctionDrawing drawing() {
        return drawings.drawing();
    }

    /** The function at the share; empty where there is none. */
    public Optional<FunctionAt> at() {
        if (drawing().coefficients().isEmpty()) return Optional.empty();
        return Optional.of(FunctionAt.of(drawings.choice(), drawing(), share));
    }

    /** The answers so far of a method without steps of its own. */
    public List<FunctionDrawing.FunctionAnswer> answers() {
        return drawing().steps().stream()
                .limit(step)
                .flatMap(one -> one.answer().stream())
                .toList();
    }

    /** The step taken last; empty before the first. */
    public Optional<FunctionDrawing.FunctionStep> taken() {
        return step == 0 ? Optional.empty() : Optional.of(drawing().steps().get(step - 1));
    }
}
