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
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.StageTimes;
import rasterlab.engine.plan.WorkCount;
import rasterlab.engine.plan.WorkEstimate;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;

/**
 * A picture's work, counted, beside what a planner predicts of it, and what both cost by the
 * measured table.
 *
 * @param work counted stage by stage
 * @param milliseconds of processor time that the count costs, stage by stage
 * @param estimate predicted stage by stage before the picture is drawn, by the faces' outlines
 * @param estimated milliseconds of processor time that the estimate costs, stage by stage
 * @param origin of the table
 */
public record CountedWork(
        PictureWork work,
        Map<String, Double> milliseconds,
        PictureWork estimate,
        Map<String, Double> estimated,
        String origin) {

    /**
     * Counts a picture of faces; empty for edges, surfaces, two eyes and methods without costs.
     *
     * @param plan by which the picture is drawn: its prediction is the one that counts
     * @param cancelled asked often
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static Optional<CountedWork> of(
            RenderRequest request, Optional<Plan> plan, BooleanSupplier cancelled) {
        if (!drawsFaces(request)) return Optional.empty();
        Optional<Family> family = Family.measured(Renderer.visibility(request).chosen());
        if (family.isEmpty()) return Optional.empty();
        PictureWork work = WorkCount.of(request, cancelled);
        PictureWork estimate =
                plan.map(by -> by.cost().work()).orElseGet(() -> WorkEstimate.of(request));
        Costs costs = Costs.measured();
        return Optional.of(
                new CountedWork(
                        work,
                        costs.stages(family.get(), work),
                        estimate,
                        costs.stages(family.get(), estimate),
                        costs.origin()));
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
        return total(milliseconds);
    }

    /**
     * Writes the fields {@code counted}, {@code predicted}, which has the count's cost, and {@code
     * planner}, which has what was predicted before anything was drawn.
     */
    public void write(JsonGenerator json) throws IOException {
        writeWork(json, "counted", work);
        json.writeObjectFieldStart("predicted");
        writeCosts(json, milliseconds);
        json.writeStringField("costs", origin);
        json.writeEndObject();
        json.writeObjectFieldStart("planner");
        writeWork(json, "work", estimate);
        writeCosts(json, estimated);
        json.writeEndObject();
    }

    /** Writes a field with the number of each stage. */
    static void writeWork(JsonGenerator json, String name, PictureWork work) throws IOException {
        json.writeObjectFieldStart(name);
        for (Map.Entry<String, Long> stage : work.stages().entrySet())
            json.writeNumberField(stage.getKey(), stage.getValue());
        json.writeEndObject();
    }

    private static void writeCosts(JsonGenerator json, Map<String, Double> stages)
            throws IOException {
        double all = total(stages);
        json.writeNumberField("processorMilliseconds", rounded(all));
        writeStages(json, "milliseconds", stages, 1);
        writeStages(json, "shares", stages, 1 / all);
    }

    private static void writeStages(
            JsonGenerator json, String name, Map<String, Double> stages, double factor)
            throws IOException {
        json.writeObjectFieldStart(name);
        for (Map.Entry<String, Double> stage : stages.entrySet())
            json.writeNumberField(stage.getKey(), rounded(factor * stage.getValue()));
        json.writeEndObject();
    }

    private static double total(Map<String, Double> stages) {
        return stages.values().stream().mapToDouble(Double::doubleValue).sum();
    }

    /** Writes the field {@code measured}: what the stages took on one thread. */
    public static void write(JsonGenerator json, StageTimes times) throws IOException {
        json.writeObjectFieldStart("measured");
        json.writeNumberField("processorMilliseconds", rounded(times.total()));
        writeStages(json, "stages", times.milliseconds(), 1);
        writeStages(
                json, "shares", times.milliseconds(), times.total() > 0 ? 1 / times.total() : 0);
        json.writeNumberField("rounds", times.rounds());
        json.writeEndObject();
    }

    /** Rounds to four places behind the point. */
    static double rounded(double value) {
        return Math.rint(value * 1e4) / 1e4;
    }
}
