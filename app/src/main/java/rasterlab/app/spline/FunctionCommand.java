package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.contract.SplineEnds;

/** The shell command that finds the function which the lab shows, with its coefficients. */
final class FunctionCommand {
    private FunctionCommand() {}

    static String of(FunctionLabState state) {
        FunctionChoice choice = state.choice();
        var at = new ArrayList<Double>();
        state.at().ifPresent(place -> at.add(place.x()));
        return "echo '{\"x\": %s, \"y\": %s, \"ends\": %s, \"at\": %s}' | ./lab run spline-function %s"
                .formatted(
                        JsonNumber.list(choice.knots().stream().map(Place::x).toList()),
                        JsonNumber.list(choice.knots().stream().map(Place::y).toList()),
                        ends(choice.ends()),
                        JsonNumber.list(List.copyOf(at)),
                        choice.method());
    }

    private static String ends(SplineEnds ends) {
        String kind = "{\"kind\": \"" + code(ends.kind()) + "\"";
        if (ends.kind() != SplineEnds.Kind.SLOPES) return kind + "}";
        return "%s, \"left\": %s, \"right\": %s}"
                .formatted(kind, JsonNumber.of(ends.left()), JsonNumber.of(ends.right()));
    }

    /** As the command line names it. */
    static String code(SplineEnds.Kind kind) {
        return kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
