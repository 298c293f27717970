package rasterlab.app.spline;

import java.util.List;
import java.util.stream.Collectors;

/** Numbers of a command: each the shortest text that is read back as the same double. */
final class JsonNumber {
    private JsonNumber() {}

    static String of(double value) {
        String text = Double.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }

    static String list(List<Double> values) {
        return values.stream().map(JsonNumber::of).collect(Collectors.joining(", ", "[", "]"));
    }
}
