package rasterlab.app.plan;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.plan.Combination;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.PlanDecision;
import rasterlab.engine.plan.PlanPath;
import rasterlab.engine.plan.PlanTrial;

/**
 * The bill of a plan: what is left out, why, and what that saves, predicted and measured.
 *
 * @param trial the plan beside the full pipeline
 * @param path what deciding takes while the camera moves
 * @param costs where the predicted costs come from
 * @param proof all other ways within the tolerance, the cheapest first; empty unless asked for
 */
public record PlanReport(PlanTrial trial, PlanPath path, String costs, List<Combination> proof) {

    /** Prints it for people. */
    public void print(PrintStream out, Language language) {
        new PlanText(this, Texts.of("plan", language)).print(out);
    }

    /** A decision's reason in a language. */
    public static String reason(Texts texts, PlanDecision decision) {
        String pattern = texts.text("reason." + decision.reason().key());
        return decision.reason().in(pattern, texts.locale());
    }

    /** The choice, where it is words rather than a name, in a language. */
    public static String word(Texts texts, String chosen) {
        String key = "word." + chosen.replaceAll("[ ,]+", "-");
        if (texts.has(key)) return texts.text(key);
        return chosen.replaceAll("^part ", texts.text("part") + " ")
                .replaceAll(": nothing$", ": " + texts.text("nothing"))
                .replaceAll(" faces$", " " + texts.text("faces"))
                .replaceAll(", inside ÷", ", " + texts.text("inside") + " ÷");
    }

    /** Writes it for programs: one object. */
    public void write(JsonGenerator json) throws IOException {
        Plan plan = trial.plan();
        json.writeStartObject();
        json.writeStringField("scene", plan.full().scene().name());
        json.writeNumberField("width", plan.full().width());
        json.writeNumberField("height", plan.full().height());
        writeDecisions(json, plan);
        writeCost(json, "predicted", plan.predictedLevels(), plan.cost(), plan.fullCost());
        json.writeObjectFieldStart("measured");
        json.writeNumberField("levels", trial.error().levels());
        json.writeNumberField("wrongPixels", trial.error().wrong());
        json.writeNumberField("share", trial.error().share());
        json.writeBooleanField("within", trial.error().within(plan.tolerance()));
        json.writeNumberField("milliseconds", trial.milliseconds());
        json.writeNumberField("fullMilliseconds", trial.fullMilliseconds());
        json.writeNumberField("processorMilliseconds", trial.processor());
        json.writeNumberField("fullProcessorMilliseconds", trial.fullProcessor());
        json.writeEndObject();
        json.writeObjectFieldStart("range");
        json.writeNumberField("turnRadians", plan.range().turn());
        json.writeNumberField("zoom", plan.range().zoom());
        json.writeEndObject();
        json.writeNumberField("decidingMilliseconds", plan.decidingMilliseconds());
        json.writeObjectFieldStart("path");
        json.writeNumberField("pictures", path.pictures());
        json.writeNumberField("plans", path.plans());
        json.writeNumberField("firstMilliseconds", path.firstMilliseconds());
        json.writeNumberField("perPictureMilliseconds", path.perPicture());
        json.writeNumberField("shareOfFullPicture", path.perPicture() / trial.fullProcessor());
        json.writeEndObject();
        json.writeNumberField("steppedBack", trial.steppedBack());
        json.writeStringField("costs", costs);
        if (!proof.isEmpty()) writeProof(json);
        json.writeEndObject();
        json.writeRaw('\n');
    }

    /** Writes the field {@code plan} of a picture that was drawn by one: what was left out, why. */
    public static void writePlan(JsonGenerator json, Plan plan) throws IOException {
        json.writeObjectFieldStart("plan");
        writeDecisions(json, plan);
        json.writeNumberField("levels", plan.predictedLevels());
        json.writeNumberField("pixels", plan.predictedPixels());
        json.writeNumberField("milliseconds", plan.cost().milliseconds());
        json.writeNumberField("fullMilliseconds", plan.fullCost().milliseconds());
        CountedWork.writeWork(json, "work", plan.cost().work());
        CountedWork.writeWork(json, "fullWork", plan.fullCost().work());
        json.writeEndObject();
    }

    private static void writeDecisions(JsonGenerator json, Plan plan) throws IOException {
        json.writeObjectFieldStart("tolerance");
        json.writeNumberField("pixels", plan.tolerance().pixels());
        json.writeNumberField("levels", plan.tolerance().levels());
        json.writeNumberField("share", plan.tolerance().share());
        json.writeEndObject();
        json.writeArrayFieldStart("decisions");
        for (PlanDecision decision : plan.decisions()) write(json, decision);
        json.writeEndArray();
    }

    private static void write(JsonGenerator json, PlanDecision decision) throws IOException {
        json.writeStartObject();
        json.writeStringField("subject", decision.subject());
        json.writeStringField("chosen", decision.chosen());
        json.writeStringField("instead", decision.instead());
        json.writeStringField("because", decision.reason().english());
        json.writeNumberField("levels", decision.levels());
        json.writeNumberField("pixels", decision.pixels());
        json.writeEndObject();
    }

    private static void writeCost(
            JsonGenerator json, String name, double levels, Plan.PlanCost least, Plan.PlanCost full)
            throws IOException {
        json.writeObjectFieldStart(name);
        json.writeNumberField("levels", levels);
        json.writeNumberField("milliseconds", least.milliseconds());
        json.writeNumberField("fullMilliseconds", full.milliseconds());
        CountedWork.writeWork(json, "work", least.work());
        CountedWork.writeWork(json, "fullWork", full.work());
        json.writeEndObject();
    }

    private void writeProof(JsonGenerator json) throws IOException {
        json.writeArrayFieldStart("combinations");
        for (Combination way : proof) {
            json.writeStartObject();
            json.writeStringField("name", way.name());
            json.writeNumberField("levels", way.error().levels());
            json.writeNumberField("wrongPixels", way.error().wrong());
            json.writeNumberField("processorMilliseconds", way.processor());
            json.writeEndObject();
        }
        json.writeEndArray();
    }
}
