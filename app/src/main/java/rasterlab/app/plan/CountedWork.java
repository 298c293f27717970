package rasterlab.app.plan;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.plan.StageTimes;
import rasterlab.engine.plan.WorkCount;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;

/**
 * A picture's work, counted, and what it costs by the measured table.
 *
 * @param work stage by stage
 * @param milliseconds of processor time, stage by stage
 * @param origin of the table
 */
public record CountedWork(PictureWork work, Map<String, Double> milliseconds, String origin) {

    /**
     * Counts a picture of faces; empty for edges, surfaces, two eyes and methods without costs.
     *
     * @param cancelled asked often
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static Optional<CountedWork> of(RenderRequest request, BooleanSupplier cancelled) {
        if (!drawsFaces(request)) return Optional.empty();
        Optional<Family> family = Family.measured(Renderer.visibility(request).chosen());
        if (family.isEmpty()) return Optional.empty();
        PictureWork work = WorkCount.of(request, cancelled);
        Costs costs = Costs.measured();
        return Optional.of(new CountedWork(work, costs.stages(family.get(), work), costs.origin()));
    }

    /** Whether a picture has stages: edges, surfaces, the reference and two eyes have none. */
    public static boolean drawsFaces(RenderRequest request) {
        return request.look().shading() != ShadingMethod.WIRE
                && request.look().stereo().isEmpty()
                && request.look().given().isEmpty()
                && !request.visibility().equals(Renderer.SURFACES)
                && !request.visibility().equals(Renderer.REFERENCE);
    }

    /** Milliseconds of processor time of all stages. */
    public double total() {
        return milliseconds.values().stream().mapToDouble(Double::doubleValue).sum();
    }

    /** Writes the fields {@code counted} and {@code predicted}. */
    public void write(JsonGenerator json) throws IOException {
        json.writeObjectFieldStart("counted");
        for (Map.Entry<String, Long> stage : work.stages().entrySet())
            json.writeNumberField(stage.getKey(), stage.getValue());
        json.writeEndObject();
        json.writeObjectFieldStart("predicted");
        json.writeNumberField("processorMilliseconds", rounded(total()));
        json.writeObjectFieldStart("shares");
        for (Map.Entry<String, Double> stage : milliseconds.entrySet())
            json.writeNumberField(stage.getKey(), rounded(stage.getValue() / total()));
        json.writeEndObject();
        json.writeStringField("costs", origin);
        json.writeEndObject();
    }

    /** Writes the field {@code measured}: what the stages took on one thread. */
    public static void write(JsonGenerator json, StageTimes times) throws IOException {
        json.writeObjectFieldStart("measured");
        json.writeNumberField("processorMilliseconds", rounded(times.total()));
        json.writeObjectFieldStart("stages");
        for (Map.Entry<String, Double> stage : times.milliseconds().entrySet())
            json.writeNumberField(stage.getKey(), rounded(stage.getValue()));
        json.writeEndObject();
        json.writeObjectFieldStart("shares");
        for (String stage : times.milliseconds().keySet())
            json.writeNumberField(stage, rounded(times.share(stage)));
        json.writeEndObject();
        json.writeNumberField("rounds", times.rounds());
        json.writeEndObject();
    }

    /** Rounds to four places behind the point. */
    static double rounded(double value) {
        return Math.rint(value * 1e4) / 1e4;
    }
}
