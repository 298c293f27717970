package rasterlab.exercises.judging;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.exercises.score.Message;

/**
 * The region codes by which a clipper takes or drops a segment, with the t where it comes in and
 * goes out; of a polygon, which of its corners lie beyond which side of the window.
 */
final class ClipDecision {
    static final Map<String, Decision> BY_TOPIC =
            Map.of(
                    "clip-segment",
                    (input, right, at) ->
                            at.index().isPresent()
                                    ? inWindow(input, right, at.index().getAsInt())
                                    : Message.NONE,
                    "clip-volume",
                    (input, right, at) ->
                            at.index().isPresent()
                                    ? inVolume(input, right, at.index().getAsInt())
                                    : Message.NONE,
                    "clip-polygon",
                    (input, right, at) -> onPolygon(input));

    /** A polygon of more corners has them counted. */
    private static final int FEW = 12;

    private static final String NO_CORNER = "–";

    private ClipDecision() {}

    static Message inWindow(JsonNode input, JsonNode right, int index) {
        double[] window = numbers(input.path("window"));
        double[] ends = numbers(input.path("segments").path(index));
        return onSegment(
                "clip-segment",
                index,
                isLeft(right, index),
                distances(window, ends[0], ends[1]),
                distances(window, ends[2], ends[3]));
    }

    /** How far a point is within each side: left, right, bottom, top. */
    private static double[] distances(double[] window, double x, double y) {
        return new double[] {x - window[0], window[2] - x, y - window[1], window[3] - y};
    }

    static Message inVolume(JsonNode input, JsonNode right, int index) {
        double zmin = input.path("zmin").asDouble();
        double[] ends = numbers(input.path("segments").path(index));
        return onSegment(
                "clip-volume",
                index,
                isLeft(right, index),
                behind(zmin, ends[0], ends[1], ends[2]),
                behind(zmin, ends[3], ends[4], ends[5]));
    }

    /** How far a point is within each plane, y up to z first, z from zmin last. */
    private static double[] behind(double zmin, double x, double y, double z) {
        return new double[] {z - y, y + z, z - x, x + z, 1 - z, z - zmin};
    }

    private static boolean isLeft(JsonNode right, int index) {
        return right.path("segments").path(index).isArray();
    }

    /**
     * The sentence on a segment; nothing where doubles do not tell what is right there.
     *
     * @param isLeft whether a part of it is left
     * @param start how far it is within each border, below 0 beyond it
     * @param end the same
     */
    private static Message onSegment(
            String topic, int index, boolean isLeft, double[] start, double[] end) {
        double enters = 0;
        double leaves = 1;
        boolean shared = false;
        for (int i = 0; i < start.length; i++) {
            shared |= start[i] < 0 && end[i] < 0;
            double t = start[i] / (start[i] - end[i]);
            if (!Double.isFinite(start[i] - end[i])) return Message.NONE;
            if (start[i] < 0 && end[i] >= 0) enters = Math.max(enters, t);
            if (start[i] >= 0 && end[i] < 0) leaves = Math.min(leaves, t);
        }
        boolean inside =
                DoubleStream.concat(DoubleStream.of(start), DoubleStream.of(end))
                        .allMatch(one -> one >= 0);
        String kind = inside ? "inside" : shared ? "beyond" : enters <= leaves ? "cut" : "past";
        if (isLeft != (inside || kind.equals("cut"))) return Message.NONE;
        return Decisions.message(
                topic, kind, index + 1, code(start), code(end), number(enters), number(leaves));
    }

    private static String code(double[] within) {
        return DoubleStream.of(within).mapToObj(one -> one < 0 ? "1" : "0").collect(joining());
    }

    private static String number(double t) {
        return Decisions.number(new BigDecimal(t));
    }

    static Message onPolygon(JsonNode input) {
        List<double[]> window = points(input.path("window"));
        List<double[]> polygon = points(input.path("polygon"));
        double inside = turn(window);
        List<String> beyond = new ArrayList<>();
        for (int i = 0; i < window.size(); i++) {
            double[] from = window.get(i);
            double[] to = window.get((i + 1) % window.size());
            List<Integer> outside =
                    IntStream.range(0, polygon.size())
                            .filter(corner -> inside * side(from, to, polygon.get(corner)) < 0)
                            .mapToObj(corner -> corner + 1)
                            .toList();
            if (outside.size() == polygon.size())
                return Decisions.message("clip-polygon", "outside", i + 1);
            beyond.add(cornersText(outside, polygon.size()));
        }
        return beyond.stream().allMatch(NO_CORNER::equals)
                ? Decisions.message("clip-polygon", "inside")
                : Decisions.message(
                        "clip-polygon",
                        polygon.size() <= FEW ? "beyond" : "counted",
                        String.join("; ", beyond));
    }

    private static String cornersText(List<Integer> corners, int all) {
        if (corners.isEmpty()) return NO_CORNER;
        if (all > FEW) return String.valueOf(corners.size());
        return corners.stream().map(String::valueOf).collect(joining(", "));
    }

    /** 1 for a window whose corners go counter-clockwise, −1 for one where they go clockwise. */
    private static double turn(List<double[]> window) {
        double twiceArea = 0;
        for (int i = 2; i < window.size(); i++)
            twiceArea += side(window.get(0), window.get(i - 1), window.get(i));
        return Math.signum(twiceArea);
    }

    /** The value is above 0 where the point lies to the left of the line. */
    private static double side(double[] from, double[] to, double[] point) {
        return (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0]);
    }

    private static List<double[]> points(JsonNode rows) {
        List<double[]> points = new ArrayList<>();
        rows.forEach(one -> points.add(numbers(one)));
        return points;
    }

    private static double[] numbers(JsonNode row) {
        return IntStream.range(0, row.size()).mapToDouble(i -> row.get(i).asDouble()).toArray();
    }
}
