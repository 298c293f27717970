package rasterlab.exercises.published;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.exercises.score.SpeedFigures;
import rasterlab.exercises.score.SpeedPoints;

/**
 * A student's point on the topic's chart of speed and accuracy, and those of the topic's methods.
 *
 * @param item what the times are per, in English and the singular
 * @param errorUnit the unit of errors, in English
 * @param fullUpTo the largest ratio that earns all points
 * @param noneAbove the ratio above which there are none
 */
public record PublishedSpeed(
        SpeedFigures figures, String item, String errorUnit, double fullUpTo, double noneAbove)
        implements PublishedPart {
    private static final MathContext DIGITS = new MathContext(4);

    /** The figures of a method of that topic. */
    public static PublishedSpeed of(String topic, SpeedFigures figures) {
        Topic<?, ?, ?> named = Topics.named(topic);
        return new PublishedSpeed(
                figures,
                named.item(),
                named.errorUnit(),
                SpeedPoints.fullUpTo(),
                SpeedPoints.noneAbove());
    }

    @Override
    public void write(JsonGenerator out) throws IOException {
        out.writeStartObject();
        write(out, figures.ratio());
        out.writeNumberField("nanos", rounded(figures.nanos()));
        out.writeNumberField("reference", rounded(figures.reference()));
        write(out, figures.error());
        out.writeNumberField("fullUpTo", rounded(fullUpTo));
        out.writeNumberField("noneAbove", rounded(noneAbove));
        out.writeStringField("item", item);
        out.writeStringField("errorUnit", errorUnit);
        out.writeArrayFieldStart("methods");
        for (SpeedFigures.MethodSpeed one : figures.methods()) {
            out.writeStartObject();
            out.writeStringField("name", one.name());
            write(out, one.ratio());
            write(out, one.error());
            out.writeEndObject();
        }
        out.writeEndArray();
        out.writeEndObject();
    }

    private static void write(JsonGenerator out, MedianInterval ratio) throws IOException {
        out.writeNumberField("ratio", rounded(ratio.median()));
        out.writeNumberField("low", rounded(ratio.low()));
        out.writeNumberField("high", rounded(ratio.high()));
    }

    /** JSON has no number without end. */
    private static void write(JsonGenerator out, double error) throws IOException {
        if (Double.isFinite(error)) out.writeNumberField("error", rounded(error));
        else out.writeNullField("error");
    }

    private static BigDecimal rounded(double number) {
        BigDecimal few = BigDecimal.valueOf(number).round(DIGITS).stripTrailingZeros();
        return few.scale() < 0 ? few.setScale(0) : few;
    }
}
