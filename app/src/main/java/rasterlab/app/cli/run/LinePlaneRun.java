package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.TreeSet;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.JsonNumbers;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;
import rasterlab.engine.geometry.meeting.LinePlaneTopic;
import rasterlab.engine.study.Topic;

/**
 * Topic {@code line-plane}: {@code line} and either {@code plane} by three points or {@code normal}
 * and {@code point}; {@code mu} and {@code point} out, and what the two make of each other.
 */
final class LinePlaneRun implements TopicRun {
    private static final JsonField<double[]> LINE =
            JsonField.required("line", json -> json.points(3, 2, 2));
    private static final JsonField<double[]> PLANE =
            JsonField.optional("plane", json -> json.points(3, 3, 3));
    private static final JsonField<double[]> NORMAL =
            JsonField.optional("normal", json -> json.numbers(3, 3));
    private static final JsonField<double[]> POINT =
            JsonField.optional("point", json -> json.numbers(3, 3));

    private final LinePlaneTopic topic = new LinePlaneTopic();
    private final Watch watch;

    /**
     * @param watch gives up a method that does not end
     */
    LinePlaneRun(Watch watch) {
        this.watch = watch;
    }

    @Override
    public Topic<?, ?, ?> topic() {
        return topic;
    }

    @Override
    public Form form() {
        return new Form(
                """
                {"line":[[x,y,z],[x,y,z]]} with "plane":[[x,y,z],[x,y,z],[x,y,z]] or \
                "normal":[a,b,c] and "point":[x,y,z]""",
                """
                {"mu":m, "point":[x,y,z], "part":"behind", "between" or "beyond", \
                "angle":degrees, "cosines":[...] of the line, \
                "projection": its length along the normal}; where mu is no number, it is null and \
                point and part are missing""");
    }

    @Override
    public Answer answer(String method, byte[] text, int length, boolean steps) {
        if (steps) throw Steps.none(method);
        Given given = StrictJson.object(text, length, LINE, PLANE, NORMAL, POINT);
        Line line = line(given.get(LINE));
        Plane plane = plane(given);
        LinePlane meeting = topic.method(method).implementation();
        double[] point = given.has("point") ? given.get(POINT) : middle(given.get(PLANE));
        Found found = watch.call(method, () -> Found.by(meeting, line, plane, point));
        return found::write;
    }

    /**
     * What the line and the plane make of each other, worked out before the first byte is written.
     */
    private record Found(double mu, Vector point, double angle, Vector cosines, double projection) {
        /**
         * @param point of the plane, as it was given
         * @throws IllegalArgumentException if one of the numbers is out of range
         */
        static Found by(LinePlane meeting, Line line, Plane plane, double[] point) {
            double mu =
                    meeting.meetsThrough(
                            numbers(plane.normal()),
                            point,
                            numbers(line.from()),
                            numbers(line.through()));
            return new Found(
                    mu,
                    Double.isFinite(mu) ? line.at(mu) : null,
                    plane.angleWith(line),
                    line.direction().unit(),
                    line.direction().projectedOn(plane.normal()));
        }

        /** A μ that is no number, as the textbook's can be, names no point. */
        void write(JsonGenerator json) throws IOException {
            JsonNumbers.writeField(json, "mu", mu);
            if (point != null) {
                json.writeFieldName("point");
                JsonNumbers.write(json, numbers(point));
                json.writeStringField("part", Line.part(mu).name().toLowerCase(Locale.ROOT));
            }
            JsonNumbers.writeField(json, "angle", angle);
            json.writeFieldName("cosines");
            JsonNumbers.write(json, numbers(cosines));
            JsonNumbers.writeField(json, "projection", projection);
        }
    }

    private static Line line(double[] ends) {
        try {
            return new Line(vector(ends, 0), vector(ends, 3));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("/line: " + e.getMessage());
        }
    }

    /** A plane parallel to the given one: methods get its point, so that no c is rounded here. */
    private static Plane plane(Given given) {
        boolean byNormal = given.has("normal") && given.has("point");
        if (given.has("normal") != given.has("point") || byNormal == given.has("plane"))
            throw Complaint.badInput(
                    "/: expected either plane, or normal and point, got "
                            + String.join(", ", new TreeSet<>(given.names())));
        try {
            if (byNormal) return new Plane(vector(given.get(NORMAL), 0), 0);
            double[] p = given.get(PLANE);
            return new Plane(Plane.normal(vector(p, 0), vector(p, 3), vector(p, 6)), 0);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput((byNormal ? "/normal: " : "/plane: ") + e.getMessage());
        }
    }

    /** The second of three points, at which the plane's c is taken. */
    private static double[] middle(double[] plane) {
        return Arrays.copyOfRange(plane, 3, 6);
    }

    private static Vector vector(double[] numbers, int from) {
        return new Vector(numbers[from], numbers[from + 1], numbers[from + 2]);
    }

    private static double[] numbers(Vector v) {
        return new double[] {v.x(), v.y(), v.z()};
    }
}
