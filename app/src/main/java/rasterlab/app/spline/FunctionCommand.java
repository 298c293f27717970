package rasterlab.app.spline;

import java.util.Locale;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.SplineFunctionTopic;
import rasterlab.engine.spline.function.SplineProblem;

/** The shell command that finds the function which the lab shows, with its coefficients. */
final class FunctionCommand {
    private FunctionCommand() {}

    static String of(FunctionLabState state) {
        FunctionChoice choice = state.choice();
        var problem =
                new SplineProblem(
                        choice.knots().stream().mapToDouble(Place::x).toArray(),
                        choice.knots().stream().mapToDouble(Place::y).toArray(),
                        choice.ends(),
                        state.at().stream().mapToDouble(FunctionAt::x).toArray(),
                        false);
        return "echo '%s' | ./lab run spline-function %s"
                .formatted(
                        CommandInput.signed(new SplineFunctionTopic().format(), problem),
                        OwnWords.known(choice.method(), choice.comparison(), "spline-function"));
    }

    /** The kind as the command line names it. */
    static String code(SplineEnds.Kind kind) {
        return kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
