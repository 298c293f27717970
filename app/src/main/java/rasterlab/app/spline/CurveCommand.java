package rasterlab.app.spline;

import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.contract.Curve;

/** The shell commands that compute the points which the lab shows: one for each curve. */
final class CurveCommand {
    private CurveCommand() {}

    static String of(CurveChoice choice) {
        return choice.curves().stream()
                .map(
                        curve ->
                                "echo '%s' | ./lab run curve %s"
                                        .formatted(json(curve, choice.sampling()), choice.method()))
                .collect(Collectors.joining("\n"));
    }

    private static String json(Curve curve, Sampling sampling) {
        return "{\"kind\": \"%s\", \"points\": %s, %s}"
                .formatted(curve.kind().code(), points(curve), wanted(sampling));
    }

    private static String points(Curve curve) {
        return IntStream.range(0, curve.x().length)
                .mapToObj(
                        i ->
                                "[%s, %s]"
                                        .formatted(
                                                JsonNumber.of(curve.x()[i]),
                                                JsonNumber.of(curve.y()[i])))
                .collect(Collectors.joining(", ", "[", "]"));
    }

    private static String wanted(Sampling sampling) {
        return sampling.isFlat()
                ? "\"flatness\": " + JsonNumber.of(sampling.flatness())
                : "\"at\": " + JsonNumber.list(sampling.at());
    }
}
