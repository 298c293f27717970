package rasterlab.app.plan;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
        Texts texts = Texts.of("plan", language);
        Plan plan = trial.plan();
        out.println(
                texts.text(
                        "head",
                        plan.full().scene().name(),
                        plan.full().width() + "×" + plan.full().height(),
                        number(plan.tolerance().pixels()),
                        number(plan.tolerance().levels())));
        for (PlanDecision decision : plan.decisions()) {
            out.println(
                    texts.text(
                            decision.saves() ? "decision" : "kept",
                            texts.text("subject." + decision.subject()),
                            word(texts, decision.chosen()),
                            word(texts, decision.instead())));
            out.println("    " + reason(texts, decision));
        }
        out.println(
                texts.text(
                        "predicted",
                        number(plan.predictedPixels()),
                        number(plan.predictedLevels()),
                        number(plan.cost().milliseconds()),
                        number(plan.fullCost().milliseconds())));
        out.println(
                texts.text(
                        "measured",
                        number(trial.error().levels()),
                        Long.toString(trial.error().wrong()),
                        number(100 * trial.error().share()),
                        number(trial.processor()),
                        number(trial.fullProcessor()),
                        number(trial.processor() / trial.fullProcessor())));
        out.println(
                texts.text("wall", number(trial.milliseconds()), number(trial.fullMilliseconds())));
        out.println(texts.text("counted"));
        var full = plan.fullCost().work().stages();
        for (Map.Entry<String, Long> stage : plan.cost().work().stages().entrySet())
            if (stage.getValue() > 0 || full.get(stage.getKey()) > 0)
                out.println(
                        texts.text(
                                "stage",
                                texts.text("stage." + stage.getKey()),
                                stage.getValue().toString(),
                                full.get(stage.getKey()).toString()));
        out.println(range(texts, plan));
        out.println(
                texts.text(
                        "deciding",
                        number(path.firstMilliseconds()),
                        number(path.perPicture()),
                        Integer.toString(path.pictures()),
                        Integer.toString(path.plans()),
                        number(100 * path.perPicture() / trial.fullProcessor())));
        if (trial.steppedBack() > 0) out.println(texts.text("back", trial.steppedBack() + ""));
        out.println(texts.text("costs", costs));
        printProof(out, texts);
    }

    private void printProof(PrintStream out, Texts texts) {
        if (proof.isEmpty()) return;
        Combination best = proof.get(0);
        out.println(
                texts.text(
                        "proof",
                        proof.size() + "",
                        best.name(),
                        number(best.processor()),
                        number(trial.processor() / best.processor())));
    }

    /** A decision's reason in a language. */
    public static String reason(Texts texts, PlanDecision decision) {
        return decision.reason().in(texts.text("reason." + decision.reason().key()));
    }

    /** The choice, where it is words rather than a name, in a language. */
    public static String word(Texts texts, String chosen) {
        String key = "word." + chosen.replaceAll("[ ,]+", "-");
        if (texts.has(key)) return texts.text(key);
        return chosen.replaceAll("^part ", texts.text("part") + " ")
                .replaceAll(": nothing$", ": " + texts.text("nothing"))
                .replaceAll(" faces$", " " + texts.text("faces"));
    }

    private static String range(Texts texts, Plan plan) {
        if (plan.range().turn() == 0) return texts.text("range.here");
        return texts.text(
                "range",
                number(Math.toDegrees(plan.range().turn())),
                number(100 * (plan.range().zoom() - 1)));
    }

    private static String number(double value) {
        if (Double.isInfinite(value)) return "∞";
        String three = String.format(Locale.ROOT, "%.3f", value);
        return three.replaceAll("0+$", "").replaceAll("\\.$", "");
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
            JsonGenerator json, String name, double levels, Plan.Cost least, Plan.Cost full)
            throws IOException {
        json.writeObjectFieldStart(name);
        json.writeNumberField("levels", levels);
        json.writeNumberField("milliseconds", least.milliseconds());
        json.writeNumberField("fullMilliseconds", full.milliseconds());
        writeWork(json, "work", least);
        writeWork(json, "fullWork", full);
        json.writeEndObject();
    }

    private static void writeWork(JsonGenerator json, String name, Plan.Cost cost)
            throws IOException {
        json.writeObjectFieldStart(name);
        for (Map.Entry<String, Long> stage : cost.work().stages().entrySet())
            json.writeNumberField(stage.getKey(), stage.getValue());
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
