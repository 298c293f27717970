package rasterlab.app.spline;

import java.util.stream.Collectors;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.engine.spline.curve.CurveTopic;

/** The shell commands that compute the points which the lab shows: one for each curve. */
final class CurveCommand {
    private CurveCommand() {}

    static String of(CurveChoice choice) {
        return choice.curves().stream()
                .map(
                        curve ->
                                "echo '%s' | ./lab run curve %s"
                                        .formatted(
                                                CommandInput.signed(
                                                        new CurveTopic().format(),
                                                        choice.sampling().task(curve)),
                                                OwnWords.known(
                                                        choice.method(),
                                                        choice.comparison(),
                                                        "curve")))
                .collect(Collectors.joining("\n"));
    }
}
