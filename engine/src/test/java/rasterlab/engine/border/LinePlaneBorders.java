package rasterlab.engine.border;

import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.geometry.meeting.Meetings;
import rasterlab.engine.geometry.meeting.PlaneAndLines;

/** Planes, given by c or by a point, and lines that meet them or hardly do. */
final class LinePlaneBorders {
    private static final LinePlaneTopic TOPIC = new LinePlaneTopic();

    /**
     * The error that UnroundedMeeting allows for its own rounding, and a step of the answer's own.
     */
    private static final double SHARE = 5 * 0x1p-53;

    private LinePlaneBorders() {}

    static Border<?, ?, ?> all() {
        return Border.of(TOPIC, LinePlaneBorders::input, LinePlaneBorders::mayRefuse)
                .promising(LinePlaneBorders::digitsAreRight);
    }

    private static PlaneAndLines input(Draws draws) {
        double[] normal = draws.numbers(3);
        if (normal[0] == 0 && normal[1] == 0 && normal[2] == 0)
            throw new IllegalArgumentException("no normal");
        double[] point = draws.numbers(draws.coin() ? 3 : 0);
        double c = draws.number();
        double[] from = draws.numbers(3);
        double[] through = draws.numbers(3);
        return new PlaneAndLines(normal, point, c, new double[][] {from}, new double[][] {through});
    }

    private static boolean mayRefuse(String method, PlaneAndLines input, String message) {
        boolean none = Double.isNaN(TOPIC.exact(input, 1).mu(0));
        if (message.startsWith("line must not be parallel") || message.startsWith("μ must be"))
            return none;
        double[] points =
                Stream.of(input.point(), input.from()[0], input.through()[0])
                        .flatMapToDouble(DoubleStream::of)
                        .toArray();
        if (message.startsWith("coordinate ") && message.contains("must be finite"))
            return overflows(input);
        double normal = largest(input.normal());
        if (message.startsWith("coordinates must be"))
            return apart(input.normal(), 400) || apart(points, 400);
        int products = Math.getExponent(normal) + Math.getExponent(largest(points));
        return message.startsWith("c must be")
                && input.point().length == 0
                && Math.abs(exponent(input.c()) - products) >= 898;
    }

    /** Whether the meeting point is as far as the largest double, within rounding. */
    private static boolean overflows(PlaneAndLines input) {
        double mu = TOPIC.exact(input, 1).mu(0);
        var halves = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            double from = input.from()[0][axis] / 2;
            halves[axis] = from + mu * (input.through()[0][axis] / 2 - from);
        }
        return largest(halves) >= Double.MAX_VALUE / 2 * (1 - 1e-14);
    }

    /** The exponent, that of a subnormal number too. */
    private static int exponent(double number) {
        return Math.getExponent(number) < Double.MIN_EXPONENT
                ? Math.getExponent(number * 0x1p60) - 60
                : Math.getExponent(number);
    }

    private static double largest(double[] numbers) {
        return DoubleStream.of(numbers).map(Math::abs).max().orElse(0);
    }

    /** Whether a number but 0 is at least 2 to that power smaller than the largest. */
    private static boolean apart(double[] numbers, int exponents) {
        int most = exponent(largest(numbers));
        return DoubleStream.of(numbers)
                .anyMatch(each -> each != 0 && exponent(each) <= most - exponents);
    }

    private static boolean digitsAreRight(PlaneAndLines input, Meetings answer) {
        double exact = TOPIC.exact(input, 1).mu(0);
        double most = SHARE * Math.abs(exact) + Double.MIN_VALUE;
        return Double.isNaN(exact) || Math.abs(answer.mu(0) - exact) <= most;
    }
}
