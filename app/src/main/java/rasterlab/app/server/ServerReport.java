package rasterlab.app.server;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.StreamSupport;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.exercises.published.ManualPoints;
import rasterlab.exercises.published.PublishedCase;
import rasterlab.exercises.published.PublishedDiagnostic;
import rasterlab.exercises.published.PublishedPicture;
import rasterlab.exercises.published.PublishedPoints;
import rasterlab.exercises.published.PublishedReport;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.published.ShownWords;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.PicturePart;
import rasterlab.exercises.score.PublishedVerdict;
import rasterlab.exercises.score.SpeedFigures;

/** Reads the document that a grading server gives of a submission with a result. */
public final class ServerReport {
    private ServerReport() {}

    public static PublishedReport read(JsonNode submission) {
        return new PublishedReport(
                text(submission, "exercise"),
                text(submission, "revision"),
                text(submission, "verdict"),
                points(submission.path("points")),
                all(submission.path("cases"), ServerReport::judged),
                all(submission.path("diagnostics"), ServerReport::diagnostic),
                text(submission, "isolation"),
                Optional.of(submission.path("speed"))
                        .filter(JsonNode::isObject)
                        .flatMap(ServerReport::speed));
    }

    /**
     * The speed; empty where the figures cannot be used: they are shown beside the result, not in
     * it.
     */
    private static Optional<PublishedSpeed> speed(JsonNode speed) {
        try {
            return Optional.of(
                    new PublishedSpeed(
                            new SpeedFigures(
                                    ratio(speed),
                                    speed.path("reference").asDouble(),
                                    error(speed),
                                    all(speed.path("methods"), ServerReport::method)),
                            text(speed, "item"),
                            text(speed, "errorUnit"),
                            speed.path("fullUpTo").asDouble(),
                            speed.path("noneAbove").asDouble()));
        } catch (IllegalArgumentException invalid) {
            return Optional.empty();
        }
    }

    private static SpeedFigures.MethodSpeed method(JsonNode one) {
        return new SpeedFigures.MethodSpeed(text(one, "name"), ratio(one), error(one));
    }

    /** A ratio with its interval, of which an older server tells nothing. */
    private static MedianInterval ratio(JsonNode of) {
        double median = of.path("ratio").asDouble();
        return new MedianInterval(
                of.path("low").asDouble(median), median, of.path("high").asDouble(median));
    }

    private static double error(JsonNode of) {
        return of.path("error").asDouble(Double.POSITIVE_INFINITY);
    }

    private static PublishedPoints points(JsonNode points) {
        return new PublishedPoints(
                number(points, "accuracy"),
                number(points, "stability"),
                number(points, "speed"),
                number(points, "hints"),
                number(points, "late"),
                manual(points.path("manual")),
                Math.max(0, number(points, "total")),
                number(points, "of"));
    }

    private static List<ManualPoints> manual(JsonNode all) {
        return StreamSupport.stream(all.spliterator(), false)
                .map(one -> new ManualPoints(number(one, "points"), text(one, "reason")))
                .toList();
    }

    /** A judged case of it, or of the events before there is a result. */
    public static PublishedCase judged(JsonNode one) {
        return new PublishedCase(
                text(one, "name"),
                text(one, "title"),
                text(one, "visibility"),
                new PublishedVerdict(
                        one.path("verdict").asText(GradingVerdict.NO_RESULT.code()),
                        one.path("run").asBoolean(true)),
                number(one, "points"),
                number(one, "of"),
                ShownWords.of(text(one, "message")),
                text(one, "message"),
                Optional.ofNullable(one.path("place").textValue()),
                Optional.ofNullable(one.path("tolerance").textValue()),
                Optional.ofNullable(one.path("rule").textValue()),
                all(one.path("pictures"), ServerReport::picture),
                one.path("scene").isObject() ? one.path("scene").toString() : "",
                Optional.ofNullable(one.path("why").textValue()));
    }

    private static PublishedPicture picture(JsonNode one) {
        return new PublishedPicture(
                text(one, "kind"),
                text(one, "url"),
                ShownWords.of(text(one, "text")),
                text(one, "text"),
                PicturePart.ofData(one.path("part").toString()));
    }

    private static PublishedDiagnostic diagnostic(JsonNode one) {
        return new PublishedDiagnostic(
                Math.max(0, number(one, "line")),
                Math.max(0, number(one, "column")),
                text(one, "message"));
    }

    private static <T> List<T> all(JsonNode items, Function<JsonNode, T> read) {
        return StreamSupport.stream(items.spliterator(), false).map(read).toList();
    }

    private static String text(JsonNode of, String field) {
        return of.path(field).asText("");
    }

    private static int number(JsonNode of, String field) {
        return of.path(field).asInt();
    }
}
